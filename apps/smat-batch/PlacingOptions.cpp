#include "apps/smat-batch/PlacingOptions.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "apps/smat-batch/Command.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/model/PlacingGuess.h"
#include "smatcore/project/JsonReading.h"
#include "smatcore/project/JsonWriting.h"
#include "smatcore/project/Project.h"

namespace smat::batch {

namespace {

irsg::ModelAxis axisOf(const char* option, const std::string& text) {
    const auto& names = irsg::modelAxisNames();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (text == names[i] || "+" + text == names[i])
            return static_cast<irsg::ModelAxis>(i);
    throw refusal(option, text, "+x, -x, +y, -y, +z or -z");
}

std::optional<double> numberOf(const std::string& text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(value)
               ? std::optional(value)
               : std::nullopt;
}

irsg::ModelOrigin originOf(const std::string& text) {
    const auto& names = modelOriginNames();
    for (std::size_t i = 0; i < names.size(); ++i)
        if (text == names[i])
            return {static_cast<irsg::ModelOrigin::At>(i), {}};
    std::array<double, 3> point{};
    std::size_t begin = 0, count = 0;
    for (; count < 3 && begin <= text.size(); ++count) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number = numberOf(text.substr(begin, end - begin));
        if (!number || std::abs(*number) > 1e9)
            break;
        point[count] = *number;
        begin = end + 1;
    }
    if (count != 3 || begin != text.size() + 1)
        throw refusal("--origin", text, "file, centre, base or x,y,z in the unit of the file");
    return {irsg::ModelOrigin::At::point, {point[0], point[1], point[2]}};
}

} // namespace

PlacingOptions::PlacingOptions(CLI::App& command, Kind kind) {
    command
        .add_option("--up-axis", up_,
                    "What of a bare model's file points up; as the file says, else +z")
        ->type_name("AXIS");
    command
        .add_option("--nose-axis", nose_,
                    "What of it points forward (write --nose-axis=-x); as the file says, else +y")
        ->type_name("AXIS");
    command
        .add_option("--unit", unit_,
                    "What one unit of it is: m, cm, mm, in, ft, km or metres; "
                    "as the file says, else m")
        ->type_name("UNIT");
    if (kind == Kind::axesAndUnit)
        return;
    command
        .add_option("--origin", origin_,
                    "Which point of it becomes the origin: file, centre, base or x,y,z of the file")
        ->type_name("POINT");
    textureOption_ =
        command
            .add_flag(textureFlag, cutsTextureAlpha_,
                      "What the alpha of its textures leaves out, below 0.5 or the file's own "
                      "threshold, is no part of its faces; false: it is")
            ->take_last();
}

std::string PlacingOptions::given() const {
    return !up_.empty()       ? "--up-axis"
           : !nose_.empty()   ? "--nose-axis"
           : !unit_.empty()   ? "--unit"
           : !origin_.empty() ? "--origin"
           : isTextureGiven() ? textureFlag
                              : "";
}

irsg::ModelOptions PlacingOptions::over(irsg::ModelOptions options) const {
    irsg::ModelPlacing& placing = options.placing;
    if (isTextureGiven())
        options.cutsTextureAlpha = cutsTextureAlpha_;
    if (!up_.empty())
        placing.up = axisOf("--up-axis", up_);
    if (!nose_.empty())
        placing.nose = axisOf("--nose-axis", nose_);
    if (!unit_.empty()) {
        placing.unit_m.reset();
        for (const irsg::ModelUnit& unit : irsg::modelUnits)
            if (unit_ == unit.symbol)
                placing.unit_m = unit.unit_m;
        if (!placing.unit_m)
            placing.unit_m = numberOf(unit_);
        if (!placing.unit_m ||
            !(*placing.unit_m >= leastModelUnit_m && *placing.unit_m <= mostModelUnit_m))
            throw refusal("--unit", unit_,
                          fmt::format("m, cm, mm, in, ft, km or metres from {} to {}",
                                      leastModelUnit_m, mostModelUnit_m));
    }
    if (!origin_.empty())
        placing.origin = originOf(origin_);
    return options;
}

nlohmann::ordered_json placingJson(const irsg::ModelPlacing& placing) {
    nlohmann::json json;
    writeModelOptions(json, {.placing = placing});
    return json;
}

} // namespace smat::batch
