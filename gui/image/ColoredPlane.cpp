#include "gui/image/ColoredPlane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>

#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"

namespace smat::gui {
namespace {

QRgb rgbOf(const irsg::Rgb& color) {
    return qRgb(color.red, color.green, color.blue);
}

/// Mean of two colours, all channels at once.
QRgb mean(QRgb a, QRgb b) {
    return (a & b) + (((a ^ b) & 0xFEFEFEFEU) >> 1U);
}

} // namespace

SharedValues shareValues(std::shared_ptr<const irsg::RadianceImage> image,
                         const irsg::ImageChannel& plane) {
    return SharedValues(std::move(image), &plane.values);
}

QColor ColoredPlane::markColor(Mark mark) {
    return mark == failed ? colors::failedPixel() : colors::warnedPixel();
}

void ColoredPlane::setValues(int width, int height, SharedValues values) {
    if (values->size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw irsg::LogicError("a plane is not as large as its picture");
    if (width != width_ || height != height_)
        levels_.reset();
    width_ = width;
    height_ = height;
    values_ = std::move(values);
    light_.reset();
    marks_.reset();
    stale_ = true;
}

void ColoredPlane::setLight(const LightPlanes& light) {
    for (const SharedValues& plane : light)
        if (plane->size() != pixelCount())
            throw irsg::LogicError("red, green or blue is not as large as its picture");
    light_ = light;
    stale_ = true;
}

void ColoredPlane::setColors(const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    map_ = &map;
    limits_ = limits;
    stale_ = true;
}

void ColoredPlane::setMarks(std::vector<std::uint8_t> marks) {
    if (!marks.empty() && (isEmpty() || marks.size() != values_->size()))
        throw irsg::LogicError("marks are not as many as pixels");
    if (marks.empty() && !marks_)
        return;
    marks_ = marks.empty() ? nullptr
                           : std::make_shared<const std::vector<std::uint8_t>>(std::move(marks));
    stale_ = true;
}

float ColoredPlane::at(int x, int y) const {
    return (*values_)[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                      static_cast<std::size_t>(x)];
}

const QImage& ColoredPlane::picture() const {
    if (stale_ || !levels_)
        color();
    return levels_->front().picture;
}

QColor ColoredPlane::shownColorAt(int x, int y) const {
    return levels_ ? levels_->front().picture.pixelColor(x, y) : QColor();
}

void ColoredPlane::forgetPicture() {
    levels_.reset();
    stale_ = true;
}

void ColoredPlane::showPictureOf(const ColoredPlane& other) {
    if (width_ == other.width_ && height_ == other.height_ && other.levels_)
        levels_ = other.levels_;
}

void ColoredPlane::color() const {
    if (isEmpty() || map_ == nullptr)
        throw irsg::LogicError("a plane without values or colours has no picture");
    std::vector<Level> levels{colored()};
    while (levels.back().picture.width() > 1 || levels.back().picture.height() > 1)
        levels.push_back(halved(levels.back()));
    levels_ = std::make_shared<const std::vector<Level>>(std::move(levels));
    stale_ = false;
}

ColoredPlane::Level ColoredPlane::colored() const {
    const std::array<QRgb, 3> marked = {0, markColor(warned).rgb(), markColor(failed).rgb()};
    Level first{light_ ? lightColors() : falseColors(),
                marks_ ? *marks_ : std::vector<std::uint8_t>()};
    auto* pixels = reinterpret_cast<QRgb*>(first.picture.bits());
    for (std::size_t i = 0; i < first.marks.size(); ++i)
        if (first.marks[i] != unmarked)
            pixels[i] = marked[first.marks[i]];
    return first;
}

QImage ColoredPlane::lightColors() const {
    const auto byte = [this](float value) {
        const double part =
            (static_cast<double>(value) - limits_.low) / (limits_.high - limits_.low);
        return std::isnan(part) ? 0 : irsg::byteOfLight(part);
    };
    QImage picture(width_, height_, QImage::Format_RGB32);
    std::size_t i = 0;
    for (int y = 0; y < height_; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < width_; ++x, ++i)
            line[x] =
                qRgb(byte((*(*light_)[0])[i]), byte((*(*light_)[1])[i]), byte((*(*light_)[2])[i]));
    }
    return picture;
}

QImage ColoredPlane::falseColors() const {
    // The map as it is written into the picture.
    std::array<QRgb, irsg::ColorMap::size> table;
    std::ranges::transform(map_->table(), table.begin(), rgbOf);
    const bool marks = limits_.marksOutside;
    const QRgb below = marks ? rgbOf(map_->below()) : table.front(),
               above = marks ? rgbOf(map_->above()) : table.back(),
               hole = rgbOf(map_->notANumber());
    const double low = limits_.low, high = limits_.high;
    const double scale = static_cast<double>(table.size() - 1) / (high - low);
    const bool isLinear = limits_.scale == irsg::ColorScale::linear;

    QImage picture(width_, height_, QImage::Format_RGB32);
    const float* next = values_->data();
    for (int y = 0; y < height_; ++y) {
        auto* line = reinterpret_cast<QRgb*>(picture.scanLine(y));
        for (int x = 0; x < width_; ++x) {
            const auto value = static_cast<double>(*next++);
            if (value >= low && value <= high)
                line[x] = table[static_cast<std::size_t>(
                    isLinear
                        ? (value - low) * scale + 0.5
                        : limits_.position(value) * static_cast<double>(table.size() - 1) + 0.5)];
            else
                line[x] = std::isnan(value) ? hole : value < low ? below : above;
        }
    }
    return picture;
}

ColoredPlane::Level ColoredPlane::halved(const Level& from) {
    const int width = (from.picture.width() + 1) / 2, height = (from.picture.height() + 1) / 2;
    const auto fromWidth = static_cast<std::size_t>(from.picture.width());
    const std::array<QRgb, 3> marked = {0, markColor(warned).rgb(), markColor(failed).rgb()};
    Level result{QImage(width, height, QImage::Format_RGB32), {}};
    if (!from.marks.empty())
        result.marks.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const int y0 = 2 * y, y1 = std::min(2 * y + 1, from.picture.height() - 1);
        const auto* top = reinterpret_cast<const QRgb*>(from.picture.constScanLine(y0));
        const auto* bottom = reinterpret_cast<const QRgb*>(from.picture.constScanLine(y1));
        auto* line = reinterpret_cast<QRgb*>(result.picture.scanLine(y));
        for (int x = 0; x < width; ++x) {
            const int x0 = 2 * x, x1 = std::min(2 * x + 1, from.picture.width() - 1);
            line[x] = mean(mean(top[x0], top[x1]), mean(bottom[x0], bottom[x1]));
            if (from.marks.empty())
                continue;
            const auto markAt = [&](int column, int row) {
                return from.marks[static_cast<std::size_t>(row) * fromWidth +
                                  static_cast<std::size_t>(column)];
            };
            const std::uint8_t mark =
                std::max({markAt(x0, y0), markAt(x1, y0), markAt(x0, y1), markAt(x1, y1)});
            result.marks[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)] = mark;
            if (mark != unmarked)
                line[x] = marked[mark];
        }
    }
    return result;
}

void ColoredPlane::draw(QPainter& painter, const QRectF& target, const QRectF& clip,
                        double pixelRatio) const {
    const QRectF seen = target & clip;
    if (isEmpty() || seen.isEmpty() || !levels_)
        return;

    // The level whose pixels are a half to one device pixel, the plane itself when enlarged.
    const double zoom = target.width() / width_ * pixelRatio;
    std::size_t reduction = 0;
    for (double at = zoom; at <= 0.5 && ((width_ >> reduction) > 1 || (height_ >> reduction) > 1);
         at *= 2.0)
        ++reduction;
    const QImage& picture = levels_->at(std::min(reduction, levels_->size() - 1)).picture;

    // Whole pixels around what is seen of it. A level of odd size is a half pixel too wide.
    const auto factor = static_cast<double>(1U << reduction);
    const double across = target.width() / width_ * factor,
                 down = target.height() / height_ * factor;
    const QRectF part((seen.left() - target.left()) / across, (seen.top() - target.top()) / down,
                      seen.width() / across, seen.height() / down);
    const QRect source = part.toAlignedRect().adjusted(-1, -1, 1, 1) & picture.rect();
    painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom < 1.0);
    painter.drawImage(QRectF(target.left() + source.left() * across,
                             target.top() + source.top() * down, source.width() * across,
                             source.height() * down),
                      picture, source);
}

} // namespace smat::gui
