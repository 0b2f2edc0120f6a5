#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/AtmosphereEditing.h"
#include "apps/smat-batch/AtmosphereInfo.h"
#include "apps/smat-batch/AtmosphereProviders.h"
#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"

namespace smat::batch {

namespace {

using nlohmann::ordered_json;

int atmosphereFileInfo(const std::string& file, Context& context) {
    const StageTimer::Scope scope(&context.timer, "load");
    if (context.json)
        fmt::print("{}\n", jsonText(atmosphereInfo(file)));
    else
        printAtmosphereInfo(file);
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
        result.update(factsOf(table));
        fmt::print("{}\n", jsonText(result));
        return done;
    }
    for (const std::string& warning : table.warnings())
        warn(warning);
    fmt::print("{}: {} run{}, {} wavenumbers\n", out, table.runs().size(),
               table.runs().size() == 1 ? "" : "s", table.runs().front().wavenumbers_per_cm.size());
    for (const std::string& span : table.spans())
        fmt::print("  {}\n", span);
    return done;
}

/// `atmosphere new` and `atmosphere set`.
void addEditing(CLI::App& command, Context& context) {
    struct Wanted {
        std::string file, out;
        std::vector<std::string> assignments;
    };
    auto wanted = std::make_shared<Wanted>();
    CLI::App* make =
        command.add_subcommand("new", "Writes a file of AtmosphereSmart: the report's defaults "
                                      "with IrradianceMode 2, except for what is given");
    CLI::App* change = command.add_subcommand(
        "set", "Changes values in a file of AtmosphereSmart and keeps the rest of it");
    change->add_option("FILE", wanted->file, "File of AtmosphereSmart")->required()->type_name("");
    for (CLI::App* one : {make, change}) {
        one->add_option("NAME=VALUE", wanted->assignments,
                        "Parameters with their values; lists of numbers are quoted")
            ->required(one == change)
            ->type_name("");
        one->add_option("--out", wanted->out,
                        one == make ? "File to write" : "File to write instead")
            ->required(one == make)
            ->type_name("FILE");
    }
    make->callback([&context, wanted] {
        context.work = [wanted] {
            writeNewAtmosphere(wanted->assignments, wanted->out);
            return done;
        };
    });
    change->callback([&context, wanted] {
        context.work = [wanted] {
            changeAtmosphere(wanted->file, wanted->assignments, wanted->out);
            return done;
        };
    });
}

/// `atmosphere answers`.
void addProviders(CLI::App& command, Context& context) {
    struct Wanted {
        std::vector<std::string> atmospheres, bands = {"3-5"};
    };
    auto wanted = std::make_shared<Wanted>();
    CLI::App* answers = command.add_subcommand(
        "answers", "Shows which of several atmospheres provides each quantity in a band");
    answers
        ->add_option("ATMOSPHERE", wanted->atmospheres,
                     "Atmosphere or Environment files, the first choice first")
        ->required()
        ->type_name("");
    answers
        ->add_option("--band", wanted->bands, "Spectral band MIN-MAX; may be given more than once")
        ->type_name("um")
        ->capture_default_str();
    answers->callback([&context, wanted] {
        context.work = [&context, wanted] {
            return printAtmosphereProviders(wanted->atmospheres, wanted->bands, context);
        };
    });
}

} // namespace

void addAtmosphereCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("atmosphere", "Makes, changes, inspects and imports atmospheres");
    command->require_subcommand(1);

    CLI::App* infoCommand = command->add_subcommand(
        "info", "Band, quantities and origin of an atmosphere: its parameters, the axes and errors "
                "of a table, the list of an environment");
    auto file = std::make_shared<std::string>();
    infoCommand->add_option("FILE", *file, "Atmosphere or Environment")->required()->type_name("");
    infoCommand->callback([&context, file] {
        context.work = [&context, file] { return atmosphereFileInfo(*file, context); };
    });

    CLI::App* importCommand = command->add_subcommand(
        "import", "One table of MODTRAN results: tape7, tape7.scn, CSV and JSON");
    auto files = std::make_shared<std::vector<std::string>>();
    auto out = std::make_shared<std::string>();
    importCommand->add_option("FILES", *files, "Results of runs with one atmosphere")
        ->required()
        ->type_name("");
    importCommand->add_option("--out", *out, "Table to write (.smatatm)")
        ->required()
        ->type_name("FILE");
    importCommand->callback([&context, files, out] {
        context.work = [&context, files, out] { return import(*files, *out, context); };
    });
    addEditing(*command, context);
    addProviders(*command, context);
}

} // namespace smat::batch
