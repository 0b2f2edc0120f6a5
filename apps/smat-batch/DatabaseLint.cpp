#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/DatabaseCommand.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/model/ModelUse.h"
#include "irsg/radiometry/Band.h"
#include "irsg/signature/LintScalings.h"
#include "smatcore/analysis/ProjectLint.h"
#include "smatcore/support/TextFile.h"

namespace smat::batch {

namespace {

using irsg::Finding;

struct LintOptions {
    std::string file, band, project, out;
    std::vector<std::string> models;
    bool acceptChanges = false, repair = false;
};

bool isJson(const std::string& file) {
    return std::filesystem::path(file).extension() == ".json";
}

/// A database that may be wrong: lint is there to say so.
irsg::SignatureDatabase read(const LintOptions& options, Context& context) {
    const StageTimer::Scope scope(&context.timer, "load");
    if (isJson(options.file)) {
        return irsg::signatureFromJson(readTextFile(options.file), options.file,
                                       irsg::LintErrors::accept);
    }
    const irsg::LoadedSignature loaded = irsg::loadSignatureFile(
        options.file,
        options.acceptChanges ? irsg::OutsideChanges::accept : irsg::OutsideChanges::refuse,
        irsg::LintErrors::accept);
    for (const std::string& entry : loaded.changedOutside)
        warn(options.file + ": " + entry + " was changed outside this program");
    return loaded.database;
}

/// What the database is checked against: models with bands and states, and the scales beside them.
struct Surroundings {
    irsg::LintScope scope;
    std::vector<std::pair<irsg::ModelUse, irsg::ScalingUse>> scalings;

    std::vector<Finding> findings(const irsg::SignatureDatabase& database) const {
        std::vector<Finding> all = irsg::lint(database, scope);
        for (const auto& [model, use] : scalings) {
            const std::vector<Finding> more = irsg::lintScalings(database, model, use);
            all.insert(all.end(), more.begin(), more.end());
        }
        return all;
    }
};

Surroundings surroundingsOf(const LintOptions& options) {
    Surroundings around;
    if (!options.project.empty()) {
        SceneBuilder builder;
        const Project project = openProject(options.project);
        around.scope = lintScopeOf(project, options.file, builder);
        auto use = around.scope.models.begin();
        for (const std::size_t model : modelsWith(project, options.file))
            around.scalings.emplace_back(
                *use++, irsg::scalingUseOf(project.resolve(project.models[model].file)));
    }
    for (const std::string& file : options.models) {
        around.scope.models.push_back(irsg::useOf(*irsg::Model::load(file)));
        around.scalings.emplace_back(around.scope.models.back(), irsg::scalingUseOf(file));
    }
    if (!options.band.empty())
        around.scope.bands = {irsg::Band::fromText(options.band).range()};
    return around;
}

nlohmann::ordered_json jsonOf(const std::vector<Finding>& findings) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings) {
        list.push_back({{"severity", finding.isError() ? "error" : "warning"},
                        {"entry", finding.entry},
                        {"place", finding.place},
                        {"value", finding.value},
                        {"reason", finding.reason},
                        {"repair", finding.remedy},
                        {"repairable", finding.repair && !finding.removes}});
    }
    return list;
}

void print(const std::vector<Finding>& findings, const char* severity = nullptr) {
    for (const Finding& finding : findings) {
        fmt::print("{}: {}: found {}: {}{}\n",
                   severity != nullptr ? severity
                   : finding.isError() ? "error"
                                       : "warning",
                   finding.place, finding.value, finding.reason,
                   finding.remedy.empty() ? "" : "; " + finding.remedy);
    }
}

int exitCodeOf(const std::vector<Finding>& findings) {
    if (std::ranges::any_of(findings, &Finding::isError))
        return refused;
    return findings.empty() ? done : warned;
}

void save(const irsg::SignatureDatabase& database, const std::string& file) {
    if (isJson(file))
        writeTextFile(file, irsg::signatureToJson(database));
    else
        irsg::saveSignatureFile(database, file);
}

void checkOptions(const LintOptions& options) {
    if (options.repair == options.out.empty()) {
        throw irsg::InputError({.file = options.repair ? "--repair" : "--out",
                                .position = "",
                                .value = options.repair ? "no --out FILE" : "no --repair",
                                .expected = "--repair with --out FILE for the repaired database"});
    }
}

int lint(const LintOptions& options, Context& context) {
    checkOptions(options);
    irsg::SignatureDatabase database = read(options, context);
    const StageTimer::Scope timed(&context.timer, "lint");
    const Surroundings around = surroundingsOf(options);
    const std::vector<Finding> repaired =
        options.repair ? irsg::repairAll(database, around.scope) : std::vector<Finding>{};
    const std::vector<Finding> left = around.findings(database);
    const int exitCode = exitCodeOf(left);

    // What cannot be opened again is not written.
    const bool writes = options.repair && exitCode != refused;
    if (writes)
        save(database, options.out);
    if (context.json) {
        nlohmann::ordered_json result{{"file", options.file}, {"findings", jsonOf(left)}};
        if (options.repair) {
            result["repaired"] = jsonOf(repaired);
            result["out"] = writes ? nlohmann::ordered_json(options.out) : nullptr;
        }
        fmt::print("{}\n", jsonText(result));
        return exitCode;
    }
    print(repaired, "repaired");
    print(left);
    if (writes) {
        fmt::print("{}: {} repaired, {} left\n", options.out, repaired.size(), left.size());
    } else if (options.repair) {
        fmt::print("{}: not written, {} repaired, {} left\n", options.out, repaired.size(),
                   left.size());
    } else if (left.empty()) {
        fmt::print("{}: nothing to find fault with\n", options.file);
    }
    return exitCode;
}

} // namespace

void addDatabaseLint(CLI::App& database, Context& context) {
    CLI::App* command =
        database.add_subcommand("lint", "What a person should look at; exit code 1 for warnings "
                                        "alone, 2 for errors");
    auto options = std::make_shared<LintOptions>();
    command->add_option("FILE", options->file, "Signature database (.sigdb), or its JSON")
        ->required()
        ->type_name("");
    command
        ->add_option("--model", options->models,
                     "Model whose codes must have an entry, and whose scaling files must suit the "
                     "database; may be given more than once")
        ->type_name("MODEL")
        ->expected(1)
        ->take_all();
    command->add_option("--band", options->band, "Band that spectra must cover, um")
        ->type_name("MIN-MAX");
    command
        ->add_option("--project", options->project,
                     "Project whose models, bands and states the database must suit")
        ->type_name("PROJECT");
    command->add_flag("--repair", options->repair,
                      "Repair what can be repaired without deleting anything");
    command->add_option("--out", options->out, "Where the repaired database goes (.sigdb or .json)")
        ->type_name("FILE");
    command->add_flag("--accept-changes", options->acceptChanges,
                      "Take entries that were changed outside this program");
    command->callback([&context, options] {
        context.work = [&context, options] { return lint(*options, context); };
    });
}

} // namespace smat::batch
