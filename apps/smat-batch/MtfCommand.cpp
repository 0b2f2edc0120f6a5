#include "apps/smat-batch/MtfCommand.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Output.h"
#include "irsg/scene/scattering/SceneScattering.h"

namespace smat::batch {

nlohmann::ordered_json mtfAsJson(const std::string& file) {
    const irsg::MtfSummary summary = irsg::describeMtf(file);
    using Json = nlohmann::ordered_json;
    Json fields = Json::array(), curves = Json::array();
    for (const auto& field : summary.fields) {
        fields.push_back({{"name", field.name},
                          {"value", field.value ? Json(*field.value) : Json()},
                          {"unit", field.unit}});
    }
    for (const auto& curve : summary.curves) {
        curves.push_back({{"optical_depth", curve.opticalDepth},
                          {"mtf_zero", curve.gain},
                          {"mtf_highest_frequency", curve.direct}});
    }
    return {{"file", file}, {"fields", fields}, {"curves", curves}, {"notes", summary.remarks}};
}

namespace {

int mtfInfo(const std::string& file, const Context& context) {
    if (context.json) {
        fmt::print("{}\n", jsonText(mtfAsJson(file)));
        return done;
    }
    fmt::print("{}\n", file);
    for (const std::string& line : irsg::describeMtf(file).lines)
        fmt::print("  {}\n", line);
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
        [&context, file] { context.work = [&context, file] { return mtfInfo(*file, context); }; });
    addMtfBuildCommand(*command, context);
}

} // namespace smat::batch
