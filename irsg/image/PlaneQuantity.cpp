#include "irsg/image/PlaneQuantity.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "irsg/core/Quantity.h"
#include "irsg/core/Wording.h"

namespace irsg {

namespace {

constexpr const char *temperature = "temperature", *counts = "counts";

/// Units of files by the quantity that has them and nothing else.
struct KnownUnit {
    std::string_view unit;
    const char* quantity;
};

std::string quantityOfUnit(const std::string& unit) {
    static const KnownUnit known[] = {{info(Quantity::radiance).unit, "radiance"},
                                      {info(Quantity::spectralRadiance).unit, "spectral radiance"},
                                      {info(Quantity::irradiance).unit, "irradiance"},
                                      {info(Quantity::intensity).unit, "intensity"},
                                      {info(Quantity::temperature).unit, temperature},
                                      {"°C", temperature},
                                      {"degC", temperature},
                                      {"Celsius", temperature},
                                      {"Kelvin", temperature},
                                      {"counts", counts},
                                      {"DN", counts}};
    const auto found = std::ranges::find(known, std::string_view(unit), &KnownUnit::unit);
    return found == std::end(known) ? "" : found->quantity;
}

/// Of words such as "apparent-temperature", "Brightness temperature", "DN".
std::string quantityOfWords(const std::string& words) {
    const std::string text = lowerCase(words);
    const auto has = [&](const char* word) { return text.find(word) != text.npos; };
    if (has("temperature"))
        return temperature;
    if (has("irradiance"))
        return "irradiance";
    if (has("radiance"))
        return has("spectral") ? "spectral radiance" : "radiance";
    if (has("count") || has("digital number") || text == "dn")
        return counts;
    return has("intensity") ? "intensity" : "";
}

/// That of the files of this program.
std::string unitOfQuantity(const std::string& quantity) {
    for (const Quantity one : {Quantity::radiance, Quantity::spectralRadiance, Quantity::irradiance,
                               Quantity::intensity, Quantity::temperature})
        if (quantityOfUnit(std::string(info(one).unit)) == quantity)
            return std::string(info(one).unit);
    return "";
}

std::string attributeOf(const RadianceImage& image, std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const auto found = image.attributes.find(name); found != image.attributes.end())
            return found->second;
    return "";
}

} // namespace

PlaneQuantity quantityOf(const RadianceImage& image, const ImageChannel& plane) {
    if (!plane.unit.empty())
        return {quantityOfUnit(plane.unit), plane.unit};
    if (plane.name == "T_apparent")
        return {temperature, unitOfQuantity(temperature)};
    if (plane.name == counts)
        return {counts, ""};
    const bool isShown = !image.channels.empty() && &plane == &image.channels.front();
    if (!isShown)
        return {};
    const std::string unit = attributeOf(image, {"unit", "units"});
    const std::string stated = quantityOfWords(attributeOf(image, {"image.quantity", "quantity"}));
    const std::string ofUnit = quantityOfUnit(unit);
    if (stated.empty())
        return {ofUnit, unit};
    return {stated, unit.empty() ? unitOfQuantity(stated) : unit};
}

} // namespace irsg
