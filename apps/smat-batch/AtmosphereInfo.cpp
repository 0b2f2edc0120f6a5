#include "apps/smat-batch/AtmosphereInfo.h"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/AtmosphereInput.h"

namespace smat::batch {

namespace {

using nlohmann::ordered_json;

std::vector<std::string> quantities(const irsg::Atmosphere& atmosphere) {
    std::vector<std::string> names;
    for (const irsg::AtmosphereProperty property : irsg::allAtmosphereProperties)
        if (atmosphere.supports(property))
            names.emplace_back(irsg::name(property));
    return names;
}

ordered_json jsonOf(const irsg::AtmosphereFacts& facts);

ordered_json jsonOf(const irsg::AtmosphereFactValue& fact) {
    return std::visit(
        [](const auto& value) -> ordered_json {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (std::is_same_v<Value, irsg::AtmosphereFacts>) {
                return jsonOf(value);
            } else if constexpr (std::is_same_v<Value, irsg::AtmosphereFactList>) {
                ordered_json list = ordered_json::array();
                for (const irsg::AtmosphereFactValue& entry : value)
                    list.push_back(jsonOf(entry));
                return list;
            } else {
                return value;
            }
        },
        fact.value);
}

ordered_json jsonOf(const irsg::AtmosphereFacts& facts) {
    ordered_json result = ordered_json::object();
    for (const irsg::AtmosphereFact& fact : facts)
        result[fact.name] = jsonOf(fact.value);
    return result;
}

ordered_json describe(const irsg::Atmosphere& atmosphere) {
    const irsg::SpectralRange base = atmosphere.base();
    ordered_json result = {{"name", atmosphere.name()},
                           {"base_um", {base.min_um, base.max_um}},
                           {"supports", quantities(atmosphere)},
                           {"wideband", atmosphere.isWidebandModeAvailable()},
                           {"remarks", atmosphere.remarks()}};
    result.update(jsonOf(atmosphere.describe().facts));
    return result;
}

/// What all kinds have, each line after `indent`.
void printCommon(const irsg::Atmosphere& atmosphere, const std::string& indent) {
    const irsg::SpectralRange base = atmosphere.base();
    fmt::print("{}base {:.6g} to {:.6g} um\n", indent, base.min_um, base.max_um);
    fmt::print("{}supports {}{}\n", indent, fmt::join(quantities(atmosphere), ", "),
               atmosphere.isWidebandModeAvailable() ? "; spectral and wideband-ck" : "");
    for (const std::string& remark : atmosphere.remarks())
        fmt::print("{}remark: {}\n", indent, remark);
}

void print(const irsg::Atmosphere& atmosphere) {
    printCommon(atmosphere, "  ");
    for (const std::string& line : atmosphere.describe().lines)
        fmt::print("  {}\n", line);
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
                   irsg::counted(background->wavelengths_um().size(), "node"));
    } else {
        fmt::print("  no default background\n");
    }
    for (const std::string& remark : file.loaded.remarks)
        fmt::print("  remark: {}\n", remark);
    fmt::print("  {}; the first that provides a quantity over the whole band is used\n",
               irsg::counted(environment.atmospheres().size(), "atmosphere"));
    for (std::size_t i = 0; i < environment.atmospheres().size(); ++i) {
        const irsg::KarmaComposite& entry = file.parameters.composition[i];
        fmt::print("    {}. {} (priority {}): {}\n", i + 1, entry.name, entry.priority,
                   environment.atmospheres()[i]->name());
        printCommon(*environment.atmospheres()[i], "       ");
    }
}

} // namespace

ordered_json factsOf(const irsg::Atmosphere& atmosphere) {
    return jsonOf(atmosphere.describe().facts);
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
