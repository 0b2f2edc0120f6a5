#include "apps/smat-batch/AtmosphereInfo.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/AtmosphereInput.h"

namespace smat::batch {

namespace {

using nlohmann::ordered_json;

std::vector<std::string> quantities(const irsg::Atmosphere& atmosphere) {
    std::vector<std::string> names;
    for (const irsg::AtmosphereProperty property : irsg::allAtmosphereProperties) {
        if (atmosphere.supports(property)) {
            names.emplace_back(irsg::name(property));
        }
    }
    return names;
}

std::string plural(std::size_t count, const std::string& noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

struct ParameterLine {
    const irsg::SmartParameter* parameter;
    std::string value, defaultValue;

    bool differs() const { return value != defaultValue; }
};

std::vector<ParameterLine> parameterLines(const irsg::AtmosphereSmart& air) {
    const irsg::AtmosphereSmartParameters defaults;
    std::vector<ParameterLine> lines;
    for (const auto table : {irsg::smartParameters(), irsg::ownSmartParameters()}) {
        for (const irsg::SmartParameter& parameter : table) {
            lines.push_back({&parameter, irsg::valueText(parameter, air.parameters()),
                             irsg::valueText(parameter, defaults)});
        }
    }
    return lines;
}

ordered_json describe(const irsg::AtmosphereSmart& air) {
    ordered_json parameters = ordered_json::array();
    for (const ParameterLine& line : parameterLines(air)) {
        parameters.push_back({{"name", line.parameter->name},
                              {"value", line.value},
                              {"unit", line.parameter->unit},
                              {"default", line.defaultValue},
                              {"differs", line.differs()},
                              {"help", line.parameter->help}});
    }
    const irsg::Profile& profile = air.air().profile;
    const irsg::AirState& ground = profile.levels().front();
    return {{"profile", profile.name()},
            {"levels", profile.levels().size()},
            {"top_m", profile.top_m()},
            {"ground_air",
             {{"temperature_K", ground.temperature_K},
              {"pressure_hPa", ground.pressure_hPa},
              {"relative_humidity", irsg::relativeHumidity(ground)},
              {"co2_ppmv", 1e6 * ground.fraction(irsg::Gas::CO2)}}},
            {"parameters", parameters}};
}

void print(const irsg::AtmosphereSmart& air) {
    const irsg::Profile& profile = air.air().profile;
    const irsg::AirState& ground = profile.levels().front();
    fmt::print("  air of {}: {} up to {:g} km\n", profile.name(),
               plural(profile.levels().size(), "level"), 1e-3 * profile.top_m());
    fmt::print(
        "  at the ground {:.2f} K, {:.1f} hPa, relative humidity {:.0f} %, CO2 {:.4g} ppmv\n",
        ground.temperature_K, ground.pressure_hPa, 100.0 * irsg::relativeHumidity(ground),
        1e6 * ground.fraction(irsg::Gas::CO2));
    const std::vector<ParameterLine> lines = parameterLines(air);
    const auto changed = std::ranges::count_if(lines, &ParameterLine::differs);
    fmt::print("  {}, {}\n", plural(lines.size(), "parameter"),
               changed == 0 ? "all as by default"
                            : fmt::format("{} not as by default (*)", changed));
    for (const ParameterLine& line : lines) {
        const auto& [name, unit] = std::pair(line.parameter->name, line.parameter->unit);
        fmt::print("  {} {:<26}  {}{}{}{}\n", line.differs() ? "*" : " ", name,
                   line.value.empty() ? "none" : line.value, unit.empty() ? "" : " ", unit,
                   line.differs()
                       ? fmt::format("  (default {})",
                                     line.defaultValue.empty() ? "none" : line.defaultValue)
                       : "");
    }
}

/// Steps between neighbouring wavenumbers.
std::pair<double, double> steps_cm(const std::vector<double>& wavenumbers_cm) {
    double least = wavenumbers_cm[1] - wavenumbers_cm[0];
    double most = least;
    for (std::size_t i = 2; i < wavenumbers_cm.size(); ++i) {
        least = std::min(least, wavenumbers_cm[i] - wavenumbers_cm[i - 1]);
        most = std::max(most, wavenumbers_cm[i] - wavenumbers_cm[i - 1]);
    }
    return {least, most};
}

void print(const irsg::TabulatedAtmosphere& table) {
    const std::vector<double>& wavenumbers = table.runs().front().wavenumbers_cm;
    const auto [least, most] = steps_cm(wavenumbers);
    fmt::print("  {}, {:g} to {:g} cm-1, steps of {}\n", plural(wavenumbers.size(), "wavenumber"),
               wavenumbers.front(), wavenumbers.back(),
               most - least < 1e-6 ? fmt::format("{:.4g} cm-1", least)
                                   : fmt::format("{:.4g} to {:.4g} cm-1", least, most));
    for (const std::string& span : table.spans()) {
        fmt::print("  {}\n", span);
    }
    fmt::print("  {}\n", plural(table.runs().size(), "run"));
    for (const irsg::SpectralRun& run : table.runs()) {
        fmt::print(
            "    {}: {}, sensor {:g} m, target {:g} m, range {:.7g} m, elevation {:.4g} deg\n",
            run.source, irsg::name(run.kind), run.geometry.sensorAltitude_m,
            run.geometry.targetAltitude_m, run.geometry.range_m,
            irsg::degrees(run.geometry.elevation_rad));
    }
    fmt::print("  error of each node predicted from its neighbours (absolute for transmittance, "
               "else of the largest value)\n");
    for (const irsg::InterpolationError& error : table.interpolationErrors()) {
        if (error.isKnown()) {
            fmt::print("    {} over {}: worst {:.2g}, rms {:.2g} ({} nodes)\n", error.quantity,
                       error.axis, error.worst, error.rms, error.nodes);
        } else {
            fmt::print("    {} over {}: not known, no run lies between two others\n",
                       error.quantity, error.axis);
        }
    }
    for (const std::string& warning : table.warnings()) {
        fmt::print("  warning: {}\n", warning);
    }
}

/// "sensor altitude 10 m, ...": what the spectra are known for.
std::vector<std::pair<std::string, double>> geometryOf(const irsg::SpectraAtmosphere& air) {
    const irsg::SpectraAtmosphereParameters& known = air.parameters();
    std::vector<std::pair<std::string, double>> numbers;
    if (known.path) {
        numbers.emplace_back("sensor_altitude_m", known.path->sensorAltitude_m);
        numbers.emplace_back("range_m", known.path->range_m);
    } else if (known.sight) {
        numbers.emplace_back("sensor_altitude_m", known.sight->sensorAltitude_m);
    }
    if (known.path || known.targetAltitude_m) {
        numbers.emplace_back("target_altitude_m",
                             known.path ? known.path->targetAltitude_m : *known.targetAltitude_m);
    }
    if (known.sight) {
        numbers.emplace_back("los_elevation_deg", irsg::degrees(known.sight->elevation_rad));
        numbers.emplace_back("los_azimuth_deg", irsg::degrees(known.sight->azimuth_rad));
    }
    if (known.sun) {
        numbers.emplace_back("sun_azimuth_deg", irsg::degrees(known.sun->azimuth_rad));
        numbers.emplace_back("sun_elevation_deg", irsg::degrees(known.sun->elevation_rad));
    }
    return numbers;
}

void print(const irsg::SpectraAtmosphere& air) {
    fmt::print("  known for one geometry\n");
    for (const auto& [key, value] : geometryOf(air)) {
        const auto unit = key.rfind('_');
        std::string words = key.substr(0, unit);
        std::ranges::replace(words, '_', ' ');
        fmt::print("    {} {:.7g} {}\n", words, value, key.substr(unit + 1));
    }
}

ordered_json describe(const irsg::Atmosphere& atmosphere) {
    const irsg::SpectralRange base = atmosphere.base();
    ordered_json result = {{"name", atmosphere.name()},
                           {"base_um", {base.min_um, base.max_um}},
                           {"supports", quantities(atmosphere)},
                           {"wideband", atmosphere.isWidebandModeAvailable()},
                           {"remarks", atmosphere.remarks()}};
    if (const auto* smart = dynamic_cast<const irsg::AtmosphereSmart*>(&atmosphere)) {
        result["smart"] = describe(*smart);
    } else if (const auto* table = dynamic_cast<const irsg::TabulatedAtmosphere*>(&atmosphere)) {
        result["table"] = tableInfo(*table);
    } else if (const auto* spectra = dynamic_cast<const irsg::SpectraAtmosphere*>(&atmosphere)) {
        for (const auto& [key, value] : geometryOf(*spectra)) {
            result["geometry"][key] = value;
        }
    } else if (const auto* homogeneous = dynamic_cast<const irsg::BeerLambert*>(&atmosphere)) {
        result["air_temperature_K"] = homogeneous->parameters().airTemperature_K;
        result["ground_temperature_K"] = homogeneous->parameters().groundTemperature_K;
    }
    return result;
}

/// What all kinds have, each line after `indent`.
void printCommon(const irsg::Atmosphere& atmosphere, const std::string& indent) {
    const irsg::SpectralRange base = atmosphere.base();
    fmt::print("{}base {:.6g} to {:.6g} um\n", indent, base.min_um, base.max_um);
    fmt::print("{}supports {}{}\n", indent, fmt::join(quantities(atmosphere), ", "),
               atmosphere.isWidebandModeAvailable() ? "; spectral and wideband-ck" : "");
    for (const std::string& remark : atmosphere.remarks()) {
        fmt::print("{}remark: {}\n", indent, remark);
    }
}

void print(const irsg::Atmosphere& atmosphere) {
    printCommon(atmosphere, "  ");
    if (const auto* smart = dynamic_cast<const irsg::AtmosphereSmart*>(&atmosphere)) {
        print(*smart);
    } else if (const auto* table = dynamic_cast<const irsg::TabulatedAtmosphere*>(&atmosphere)) {
        print(*table);
    } else if (const auto* spectra = dynamic_cast<const irsg::SpectraAtmosphere*>(&atmosphere)) {
        print(*spectra);
    } else if (const auto* homogeneous = dynamic_cast<const irsg::BeerLambert*>(&atmosphere)) {
        fmt::print("  homogeneous air of {:g} K over ground of {:g} K\n",
                   homogeneous->parameters().airTemperature_K,
                   homogeneous->parameters().groundTemperature_K);
    }
}

/// An Environment file: what it says, and the atmospheres it names, in the same order.
struct EnvironmentFile {
    explicit EnvironmentFile(const std::filesystem::path& file)
        : loaded(irsg::loadEnvironment(file)),
          parameters(irsg::environmentFromKarma(irsg::KarmaXml::read(file)).parameters) {}

    irsg::LoadedEnvironment loaded;
    irsg::EnvironmentParameters parameters;
};

ordered_json describe(const EnvironmentFile& file) {
    const auto& background = file.parameters.background;
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < file.parameters.composition.size(); ++i) {
        const irsg::KarmaComposite& entry = file.parameters.composition[i];
        ordered_json one = {
            {"entry", entry.name}, {"priority", entry.priority}, {"parameters", entry.parameters}};
        one.update(describe(*file.loaded.environment.atmospheres()[i]));
        list.push_back(std::move(one));
    }
    ordered_json result = {
        {"sun_azimuth_deg", irsg::degrees(file.loaded.environment.sun.azimuth_rad)},
        {"sun_elevation_deg", irsg::degrees(file.loaded.environment.sun.elevation_rad)},
        {"atmospheres", list},
        {"remarks", file.loaded.remarks}};
    if (background) {
        result["default_background"] = {{"wavelengths_um", background->wavelengths_um()},
                                        {"radiances_W_m2_sr_um", background->values()}};
    }
    return result;
}

void print(const EnvironmentFile& file) {
    const irsg::Environment& environment = file.loaded.environment;
    fmt::print("  sun at azimuth {:.6g} deg, elevation {:.6g} deg\n",
               irsg::degrees(environment.sun.azimuth_rad),
               irsg::degrees(environment.sun.elevation_rad));
    if (const auto& background = file.parameters.background) {
        fmt::print("  default background from {:.6g} to {:.6g} um, {}\n",
                   background->wavelengths_um().front(), background->wavelengths_um().back(),
                   plural(background->wavelengths_um().size(), "node"));
    } else {
        fmt::print("  no default background\n");
    }
    for (const std::string& remark : file.loaded.remarks) {
        fmt::print("  remark: {}\n", remark);
    }
    fmt::print("  {}; the first that has a quantity over the whole band answers\n",
               plural(environment.atmospheres().size(), "atmosphere"));
    for (std::size_t i = 0; i < environment.atmospheres().size(); ++i) {
        const irsg::KarmaComposite& entry = file.parameters.composition[i];
        fmt::print("    {}. {} (priority {}): {}\n", i + 1, entry.name, entry.priority,
                   environment.atmospheres()[i]->name());
        printCommon(*environment.atmospheres()[i], "       ");
    }
}

} // namespace

ordered_json tableInfo(const irsg::TabulatedAtmosphere& table) {
    ordered_json runs = ordered_json::array();
    for (const irsg::SpectralRun& run : table.runs()) {
        runs.push_back({{"source", run.source},
                        {"kind", irsg::name(run.kind)},
                        {"sensor_altitude_m", run.geometry.sensorAltitude_m},
                        {"target_altitude_m", run.geometry.targetAltitude_m},
                        {"range_m", run.geometry.range_m},
                        {"elevation_rad", run.geometry.elevation_rad},
                        {"cards", run.cards}});
    }
    ordered_json errors = ordered_json::array();
    for (const irsg::InterpolationError& error : table.interpolationErrors()) {
        ordered_json entry = {
            {"quantity", error.quantity}, {"axis", error.axis}, {"nodes", error.nodes}};
        if (error.isKnown()) {
            entry["worst"] = error.worst;
            entry["rms"] = error.rms;
        }
        errors.push_back(std::move(entry));
    }
    const std::vector<double>& wavenumbers = table.runs().front().wavenumbers_cm;
    const auto [least, most] = steps_cm(wavenumbers);
    return {{"wavenumbers", wavenumbers.size()},
            {"first_cm-1", wavenumbers.front()},
            {"last_cm-1", wavenumbers.back()},
            {"least_step_cm-1", least},
            {"largest_step_cm-1", most},
            {"runs", runs},
            {"spans", table.spans()},
            {"interpolation_errors", errors},
            {"warnings", table.warnings()}};
}

ordered_json atmosphereInfo(const std::filesystem::path& file) {
    ordered_json result = {{"file", file.string()}};
    if (irsg::isEnvironmentXml(file)) {
        result["kind"] = "environment";
        result.update(describe(EnvironmentFile(file)));
    } else {
        result["kind"] = "atmosphere";
        result.update(describe(*openAtmosphere(file)));
    }
    return result;
}

void printAtmosphereInfo(const std::filesystem::path& file) {
    if (irsg::isEnvironmentXml(file)) {
        const EnvironmentFile environment(file);
        fmt::print("{}: environment\n", file.string());
        print(environment);
    } else {
        const auto atmosphere = openAtmosphere(file);
        fmt::print("{}: {}\n", file.string(), atmosphere->name());
        print(*atmosphere);
    }
}

} // namespace smat::batch
