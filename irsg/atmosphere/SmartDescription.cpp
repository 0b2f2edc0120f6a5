#include <algorithm>

#include "irsg/atmosphere/AtmosphereSmart.h"

namespace irsg {

namespace {

struct ParameterLine {
    const SmartParameter* parameter;
    std::string value, defaultValue;

    bool differs() const { return value != defaultValue; }

    /// "* Visibility                  23000 m  (default 0)"
    std::string text() const {
        const std::string unit(parameter->unit);
        std::string line = (differs() ? "* " : "  ") + std::string(parameter->name);
        line.resize(std::max<std::size_t>(line.size(), 28), ' ');
        line += "  " + (value.empty() ? "none" : value);
        if (!unit.empty())
            line += " " + unit;
        if (differs())
            line += "  (default " + (defaultValue.empty() ? "none" : defaultValue) + ")";
        return line;
    }
    AtmosphereFacts facts() const {
        return {{"name", {std::string(parameter->name)}},
                {"value", {value}},
                {"unit", {std::string(parameter->unit)}},
                {"default", {defaultValue}},
                {"differs", {differs()}},
                {"help", {std::string(parameter->help)}}};
    }
};

std::vector<ParameterLine> parameterLines(const AtmosphereSmartParameters& parameters) {
    const AtmosphereSmartParameters defaults;
    std::vector<ParameterLine> lines;
    for (const auto table : {smartParameters(), ownSmartParameters()})
        for (const SmartParameter& parameter : table)
            lines.push_back(
                {&parameter, valueText(parameter, parameters), valueText(parameter, defaults)});
    return lines;
}

} // namespace

AtmosphereDescription AtmosphereSmart::describe() const {
    const Profile& profile = air_.profile;
    const AtmosphericState& ground = profile.levels().front();
    const double co2_ppmv = 1e6 * ground.fraction(Gas::CO2);
    const std::vector<ParameterLine> own = parameterLines(parameters_);
    const auto changed = std::ranges::count_if(own, &ParameterLine::differs);

    std::vector<std::string> lines;
    lines.push_back("air of " + profile.name() + ": " + counted(profile.levels().size(), "level") +
                    " up to " + general(1e-3 * profile.top_m()) + " km");
    lines.push_back("at the ground " + fixed(ground.temperature_K, 2) + " K, " +
                    fixed(ground.pressure_hPa, 1) + " hPa, relative humidity " +
                    fixed(100.0 * relativeHumidity(ground), 0) + " %, CO2 " + general(co2_ppmv, 4) +
                    " ppmv");
    lines.push_back(
        counted(own.size(), "parameter") + ", " +
        (changed == 0 ? "all as by default" : std::to_string(changed) + " not as by default (*)"));
    AtmosphereFactList parameters;
    for (const ParameterLine& line : own) {
        lines.push_back(line.text());
        parameters.push_back({line.facts()});
    }

    AtmosphereFacts groundAir = {{"temperature_K", {ground.temperature_K}},
                                 {"pressure_hPa", {ground.pressure_hPa}},
                                 {"relative_humidity", {relativeHumidity(ground)}},
                                 {"co2_ppmv", {co2_ppmv}}};
    AtmosphereFacts facts = {{"profile", {std::string(profile.name())}},
                             {"levels", {static_cast<std::int64_t>(profile.levels().size())}},
                             {"top_m", {profile.top_m()}},
                             {"ground_air", {std::move(groundAir)}},
                             {"parameters", {std::move(parameters)}}};
    return {std::move(lines), {{"smart", {std::move(facts)}}}};
}

} // namespace irsg
