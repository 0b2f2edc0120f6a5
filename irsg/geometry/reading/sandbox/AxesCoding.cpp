#include "irsg/geometry/reading/sandbox/AxesCoding.h"

#include <cmath>

namespace irsg {

namespace {

constexpr std::uint8_t axisCount = 6;

void putAxis(ByteSink& sink, const std::optional<ModelAxis>& axis) {
    sink.put(axis ? static_cast<std::uint8_t>(*axis) : axisCount);
}

std::optional<ModelAxis> getAxis(ByteSource& source) {
    const auto number = source.get<std::uint8_t>();
    if (number > axisCount)
        throw DamagedBytes("an axis that there is not");
    return number == axisCount ? std::nullopt : std::optional(static_cast<ModelAxis>(number));
}

std::optional<double> getUnit(ByteSource& source) {
    const auto unit_m = source.get<double>();
    if (!(unit_m >= 0.0) || !std::isfinite(unit_m))
        throw DamagedBytes("a unit that is no length");
    return unit_m > 0.0 ? std::optional(unit_m) : std::nullopt;
}

} // namespace

void putAxes(ByteSink& sink, const FileAxes& axes) {
    sink.put(axes.unit_m.value_or(0.0));
    putAxis(sink, axes.up);
    putAxis(sink, axes.front);
    sink.putText(axes.reason);
    sink.put(axes.spokenUnit ? axes.spokenUnit->unit_m : 0.0);
    sink.putText(axes.spokenUnit ? axes.spokenUnit->words : "");
    putAxis(sink, axes.usualFront);
}

FileAxes getAxes(ByteSource& source) {
    FileAxes axes;
    axes.unit_m = getUnit(source);
    axes.up = getAxis(source);
    axes.front = getAxis(source);
    axes.reason = source.getText();
    const auto spoken_m = getUnit(source);
    std::string words = source.getText();
    if (spoken_m)
        axes.spokenUnit = {*spoken_m, std::move(words)};
    axes.usualFront = getAxis(source);
    return axes;
}

} // namespace irsg
