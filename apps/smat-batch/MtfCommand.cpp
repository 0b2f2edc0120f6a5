#include "apps/smat-batch/MtfCommand.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "irsg/scene/scattering/SceneScattering.h"

namespace smat::batch {

namespace {

int info(const std::string& file, const Context& context) {
    const std::vector<std::string> lines = irsg::describeMtf(file);
    if (context.json) {
        fmt::print("{}\n", nlohmann::ordered_json{{"file", file}, {"lines", lines}}.dump(1));
        return done;
    }
    fmt::print("{}\n", file);
    for (const std::string& line : lines) {
        fmt::print("  {}\n", line);
    }
    return done;
}

} // namespace

void addMtfCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("mtf", "How droplets spread light: databases for scattering");
    command->require_subcommand(1);
    CLI::App* infoCommand = command->add_subcommand("info", "Header, axes and gains of a database");
    auto file = std::make_shared<std::string>();
    infoCommand->add_option("FILE", *file, "MTF database")->required()->type_name("");
    infoCommand->callback(
        [&context, file] { context.work = [&context, file] { return info(*file, context); }; });
    addMtfBuildCommand(*command, context);
}

} // namespace smat::batch
