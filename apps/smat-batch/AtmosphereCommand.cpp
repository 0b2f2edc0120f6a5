#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/radiometry/Units.h"

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

ordered_json describe(const irsg::TabulatedAtmosphere& table) {
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

void print(const irsg::TabulatedAtmosphere& table) {
    const std::vector<double>& wavenumbers = table.runs().front().wavenumbers_cm;
    const auto [least, most] = steps_cm(wavenumbers);
    fmt::print("  {} wavenumbers, {:g} to {:g} cm-1, steps of {}\n", wavenumbers.size(),
               wavenumbers.front(), wavenumbers.back(),
               most - least < 1e-6 ? fmt::format("{:.4g} cm-1", least)
                                   : fmt::format("{:.4g} to {:.4g} cm-1", least, most));
    for (const std::string& span : table.spans()) {
        fmt::print("  {}\n", span);
    }
    fmt::print("  {} run{}\n", table.runs().size(), table.runs().size() == 1 ? "" : "s");
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

int info(const std::string& file, Context& context) {
    std::shared_ptr<const irsg::Atmosphere> atmosphere;
    {
        const StageTimer::Scope scope(&context.timer, "load");
        atmosphere = irsg::loadAtmosphere(file);
    }
    const auto* table = dynamic_cast<const irsg::TabulatedAtmosphere*>(atmosphere.get());
    const auto* homogeneous = dynamic_cast<const irsg::BeerLambert*>(atmosphere.get());
    const irsg::SpectralRange base = atmosphere->base();
    if (context.json) {
        ordered_json result = {{"file", file},
                               {"name", atmosphere->name()},
                               {"base_um", {base.min_um, base.max_um}},
                               {"supports", quantities(*atmosphere)}};
        if (table) {
            result["table"] = describe(*table);
        }
        if (homogeneous) {
            result["air_temperature_K"] = homogeneous->parameters().airTemperature_K;
            result["ground_temperature_K"] = homogeneous->parameters().groundTemperature_K;
        }
        fmt::print("{}\n", result.dump(1));
        return done;
    }
    fmt::print("{}: {}\n", file, atmosphere->name());
    fmt::print("  base {:.6g} to {:.6g} um\n", base.min_um, base.max_um);
    fmt::print("  supports {}\n", fmt::join(quantities(*atmosphere), ", "));
    if (table) {
        print(*table);
    }
    if (homogeneous) {
        fmt::print("  homogeneous air of {:g} K over ground of {:g} K\n",
                   homogeneous->parameters().airTemperature_K,
                   homogeneous->parameters().groundTemperature_K);
    }
    return done;
}

int import(const std::vector<std::string>& names, const std::string& out, Context& context) {
    const std::vector<std::filesystem::path> files(names.begin(), names.end());
    const irsg::TabulatedAtmosphere table = [&] {
        const StageTimer::Scope scope(&context.timer, "load");
        return irsg::TabulatedAtmosphere::import(files);
    }();
    table.write(out);
    if (context.json) {
        ordered_json result = {{"file", out}, {"name", table.name()}};
        result["table"] = describe(table);
        fmt::print("{}\n", result.dump(1));
        return done;
    }
    for (const std::string& warning : table.warnings()) {
        warn(warning);
    }
    fmt::print("{}: {} run{}, {} wavenumbers\n", out, table.runs().size(),
               table.runs().size() == 1 ? "" : "s", table.runs().front().wavenumbers_cm.size());
    for (const std::string& span : table.spans()) {
        fmt::print("  {}\n", span);
    }
    return done;
}

} // namespace

void addAtmosphereCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("atmosphere", "Looks into atmospheres and imports those of others");
    command->require_subcommand(1);

    CLI::App* infoCommand = command->add_subcommand(
        "info", "Band, quantities and origin of an atmosphere, errors of a table");
    auto file = std::make_shared<std::string>();
    infoCommand->add_option("FILE", *file, "Atmosphere")->required()->type_name("");
    infoCommand->callback(
        [&context, file] { context.work = [&context, file] { return info(*file, context); }; });

    CLI::App* importCommand = command->add_subcommand(
        "import", "One table of MODTRAN results: tape7, tape7.scn, CSV and JSON");
    auto files = std::make_shared<std::vector<std::string>>();
    auto out = std::make_shared<std::string>();
    importCommand->add_option("FILES", *files, "Results of runs of one air")
        ->required()
        ->type_name("");
    importCommand->add_option("--out", *out, "Table to write (.smatatm)")
        ->required()
        ->type_name("FILE");
    importCommand->callback([&context, files, out] {
        context.work = [&context, files, out] { return import(*files, *out, context); };
    });
}

} // namespace smat::batch
