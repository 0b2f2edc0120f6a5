#include "gui/image/IndexColors.h"

#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "gui/widgets/NumberFormat.h"
#include "irsg/image/ColorMap.h"

namespace smat::gui {
namespace {

QString nameIn(const irsg::RadianceImage& image, const irsg::ImageChannel& plane, int index) {
    const auto found = image.attributes.find(plane.name + "." + std::to_string(index));
    return found == image.attributes.end() ? QString() : QString::fromStdString(found->second);
}

/// Steps of the golden ratio along the circle of hues are far apart however many there are; every
/// third colour is darker, every third paler.
QColor colorOf(std::size_t place) {
    constexpr double step = 0.618033988749895, first = 0.58;
    const double hue = std::fmod(first + step * static_cast<double>(place), 1.0);
    constexpr std::array saturations{0.75, 0.85, 0.45}, values{0.95, 0.62, 1.0};
    const QColor color =
        QColor::fromHsvF(static_cast<float>(hue), static_cast<float>(saturations[place % 3]),
                         static_cast<float>(values[place % 3]));
    return QColor(color.rgb()); // of whole bytes, as it is drawn
}

float linearOf(int byte) {
    return static_cast<float>(irsg::lightOfByte(static_cast<std::uint8_t>(byte)));
}

} // namespace

bool isIndexPlane(const irsg::ImageChannel& plane) {
    return plane.name.ends_with("_index");
}

QString SeenIndex::words() const {
    return QString::number(index) + (name.isEmpty() ? QString() : "  " + name);
}

std::vector<SeenIndex> seenIndices(const irsg::RadianceImage& image,
                                   const irsg::ImageChannel& plane) {
    std::map<int, std::size_t> counts;
    for (const float value : plane.values)
        if (std::isfinite(value))
            ++counts[static_cast<int>(std::lround(value))];
    std::vector<SeenIndex> seen;
    for (const auto& [index, pixels] : counts)
        seen.push_back({index, nameIn(image, plane, index), colorOf(seen.size()), pixels});
    return seen;
}

LightPlanes lightOf(const irsg::ImageChannel& plane, const std::vector<SeenIndex>& seen) {
    std::map<int, std::array<float, 3>> lights;
    for (const SeenIndex& one : seen)
        lights[one.index] = {linearOf(one.color.red()), linearOf(one.color.green()),
                             linearOf(one.color.blue())};
    std::array<std::vector<float>, 3> planes;
    for (std::vector<float>& values : planes)
        values.resize(plane.values.size());
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
        if (!std::isfinite(plane.values[i]))
            continue;
        const auto found = lights.find(static_cast<int>(std::lround(plane.values[i])));
        for (std::size_t k = 0; found != lights.end() && k < planes.size(); ++k)
            planes[k][i] = found->second[k];
    }
    const auto shared = [](std::vector<float>& values) {
        return std::make_shared<const std::vector<float>>(std::move(values));
    };
    return {shared(planes[0]), shared(planes[1]), shared(planes[2])};
}

QString valueWords(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                   std::size_t offset) {
    const auto value = static_cast<double>(plane.values.at(offset));
    const QString number = formattedNumber(value);
    if (!isIndexPlane(plane) || !std::isfinite(value))
        return number;
    const QString name = nameIn(image, plane, static_cast<int>(std::lround(value)));
    return name.isEmpty() ? number : number + " " + name;
}

} // namespace smat::gui
