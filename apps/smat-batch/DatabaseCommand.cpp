#include "apps/smat-batch/DatabaseCommand.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Output.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/scene/Model.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/support/TextFile.h"

namespace smat::batch {

namespace {

using irsg::Finding;

struct DatabaseOptions {
    std::string file, out, model, band;
    bool acceptChanges = false;
};

irsg::SignatureDatabase loaded(const DatabaseOptions& options, Context& context) {
    const StageTimer::Scope scope(&context.timer, "load");
    const irsg::LoadedSignature signature =
        irsg::loadSignatureFile(options.file, options.acceptChanges ? irsg::OutsideChanges::accept
                                                                    : irsg::OutsideChanges::refuse);
    for (const std::string& entry : signature.changedOutside) {
        warn(options.file + ": " + entry + " was changed outside this program");
    }
    return signature.database;
}

/// A database with an entry for each code of a model, or for index 0 alone: opaque black surfaces
/// at ambient temperature, to be given their real values.
int create(const DatabaseOptions& options, Context&) {
    if (std::filesystem::exists(options.file)) {
        throw irsg::InputError(irsg::Offence{.file = options.file,
                                             .position = "",
                                             .value = "a file that exists already",
                                             .expected = "the name of a new file"});
    }
    irsg::SignatureDatabase database;
    database.title = std::filesystem::path(options.file).stem().string();
    std::map<irsg::IrCodes, irsg::CodeUse> codes = {{{}, {}}};
    if (!options.model.empty()) {
        codes = irsg::Model::load(options.model)->codes();
        database.title = std::filesystem::path(options.model).stem().string();
    }
    for (const auto& [pair, use] : codes) {
        database.temperatures[pair.temperature].name =
            "temperature " + std::to_string(pair.temperature);
        database.materials[pair.material].name = "material " + std::to_string(pair.material);
    }
    irsg::saveSignatureFile(database, options.file);
    fmt::print("{}: {} temperatures, {} materials\n", options.file, database.temperatures.size(),
               database.materials.size());
    return done;
}

const char* modeName(irsg::EmissionMode mode) {
    return mode == irsg::EmissionMode::temperature ? "temperature equation" : "user spectrum";
}

int info(const DatabaseOptions& options, Context& context) {
    const irsg::SignatureDatabase database = loaded(options, context);
    if (context.json) {
        nlohmann::ordered_json temperatures = nlohmann::ordered_json::array();
        for (const auto& [index, entry] : database.temperatures) {
            temperatures.push_back(
                {{"index", index}, {"name", entry.name}, {"mode", modeName(entry.mode)}});
        }
        nlohmann::ordered_json materials = nlohmann::ordered_json::array();
        for (const auto& [index, material] : database.materials) {
            materials.push_back({{"index", index},
                                 {"name", material.name},
                                 {"opaque", material.isOpaque()},
                                 {"n_angle_factor", material.nAngleFactor}});
        }
        nlohmann::ordered_json spectra = nlohmann::ordered_json::array();
        for (const auto& [spectrumName, spectrum] : database.spectra) {
            spectra.push_back({{"name", spectrumName},
                               {"components", spectrum.components.size()},
                               {"reference_distance_m", spectrum.referenceDistance_m}});
        }
        fmt::print("{}\n", nlohmann::ordered_json{{"file", options.file},
                                                  {"title", database.title},
                                                  {"temperatures", temperatures},
                                                  {"materials", materials},
                                                  {"spectra", spectra}}
                               .dump(1));
        return done;
    }
    fmt::print("{}: {}\n", options.file, database.title);
    for (const auto& [index, entry] : database.temperatures) {
        fmt::print("  temperature {:>6}  {} ({}{})\n", index, entry.name, modeName(entry.mode),
                   entry.userSpectrum.empty() ? "" : " " + entry.userSpectrum);
    }
    for (const auto& [index, material] : database.materials) {
        fmt::print("  material    {:>6}  {} ({})\n", index, material.name,
                   material.isOpaque() ? "opaque" : "transparent");
    }
    for (const auto& [spectrumName, spectrum] : database.spectra) {
        fmt::print("  spectrum    {} ({} components, reference distance {} m)\n", spectrumName,
                   spectrum.components.size(), spectrum.referenceDistance_m);
    }
    return done;
}

/// What a person should look at, the codes of a model that have no entry among them.
std::vector<Finding> findingsOf(const irsg::SignatureDatabase& database,
                                const DatabaseOptions& options) {
    std::vector<Finding> findings =
        options.band.empty() ? irsg::lint(database)
                             : irsg::lint(database, irsg::Band::fromText(options.band).range());
    if (options.model.empty()) {
        return findings;
    }
    for (const auto& [pair, use] : irsg::Model::load(options.model)->codes()) {
        const auto missing = [&](const char* table, int index) {
            findings.push_back(
                {.severity = Finding::Severity::error,
                 .place = fmt::format("{}.{}", table, index),
                 .value = "no entry",
                 .reason = fmt::format("{} faces of {} carry this code", use.faces, options.model),
                 .repair = "add the entry, or name a fallback in the project"});
        };
        if (database.temperatures.count(pair.temperature) == 0) {
            missing("temperatures", pair.temperature);
        }
        if (database.materials.count(pair.material) == 0) {
            missing("materials", pair.material);
        }
    }
    return findings;
}

int lint(const DatabaseOptions& options, Context& context) {
    const std::vector<Finding> findings = findingsOf(loaded(options, context), options);
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    int exitCode = done;
    for (const Finding& finding : findings) {
        const bool isError = finding.severity == Finding::Severity::error;
        exitCode = std::max<int>(exitCode, isError ? refused : warned);
        if (context.json) {
            list.push_back({{"severity", isError ? "error" : "warning"},
                            {"place", finding.place},
                            {"value", finding.value},
                            {"reason", finding.reason},
                            {"repair", finding.repair}});
        } else {
            fmt::print("{}: {}: found {}: {}{}\n", isError ? "error" : "warning", finding.place,
                       finding.value, finding.reason,
                       finding.repair.empty() ? "" : "; " + finding.repair);
        }
    }
    if (context.json) {
        fmt::print("{}\n", nlohmann::ordered_json{{"findings", list}}.dump(1));
    } else if (findings.empty()) {
        fmt::print("{}: nothing to find fault with\n", options.file);
    }
    return exitCode;
}

int exportJson(const DatabaseOptions& options, Context& context) {
    const std::string text = irsg::signatureToJson(loaded(options, context));
    if (options.out.empty()) {
        fmt::print("{}", text);
    } else {
        writeTextFile(options.out, text);
    }
    return done;
}

} // namespace

void addDatabaseCommand(CLI::App& app, Context& context) {
    CLI::App* database =
        app.add_subcommand("db", "Makes, checks and exchanges signature databases");
    database->require_subcommand(1);
    const auto add = [&](const char* name, const char* help,
                         int (*work)(const DatabaseOptions&, Context&)) {
        CLI::App* command = database->add_subcommand(name, help);
        auto options = std::make_shared<DatabaseOptions>();
        command->add_option("FILE", options->file, "Signature database (.sigdb)")
            ->required()
            ->type_name("");
        command->callback([&context, options, work] {
            context.work = [&context, options, work] { return work(*options, context); };
        });
        return std::pair{command, options};
    };
    const auto takeChanges = [](const auto& made) {
        made.first->add_flag("--accept-changes", made.second->acceptChanges,
                             "Take entries that were changed outside this program");
    };

    const auto createMade =
        add("create", "A new database: black surfaces at ambient temperature", create);
    createMade.first->add_option("--model", createMade.second->model,
                                 "With an entry for each code of this model");
    takeChanges(add("info", "Entries, materials and spectra", info));
    const auto lintMade = add("lint", "What a person should look at", lint);
    lintMade.first->add_option("--band", lintMade.second->band, "Band that spectra must cover")
        ->type_name("MIN-MAX");
    lintMade.first->add_option("--model", lintMade.second->model,
                               "Model whose codes must have an entry");
    takeChanges(lintMade);
    const auto exportMade = add("export", "Sorted JSON, to review and to compare", exportJson);
    exportMade.first
        ->add_option("OUT", exportMade.second->out, "JSON file; standard output without one")
        ->type_name("");
    takeChanges(exportMade);
    addDatabaseImport(*database, context);
}

} // namespace smat::batch
