#include <memory>
#include <set>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PlacingOptions.h"
#include "irsg/core/Errors.h"
#include "irsg/geometry/model/ModelConverter.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::batch {

namespace {

struct ConvertOptions {
    std::string in, out, zones;
    std::shared_ptr<PlacingOptions> placing;
};

/// Materials of a database that are gas.
std::set<int> gasesOf(const std::string& database) {
    std::set<int> gases;
    for (const auto& [index, material] : irsg::loadSignatureFile(database).database.materials)
        if (material.isGas())
            gases.insert(index);
    if (gases.empty())
        throw irsg::InputError(
            {database, "materials", "no gas",
             "materials with a gasPressure_atm above 0, whose meshes are closed"});
    return gases;
}

long total(const std::map<irsg::IrCodes, long>& polygons) {
    long sum = 0;
    for (const auto& [codes, count] : polygons)
        sum += count;
    return sum;
}

int convert(const ConvertOptions& options, Context& context) {
    const irsg::ModelPlacing placing = options.placing->over({}).placing;
    irsg::ConversionReport report;
    {
        const StageTimer::Scope scope(&context.timer, "convert");
        report = irsg::convertModel(
            options.in, options.out, {},
            {options.zones.empty() ? std::set<int>() : gasesOf(options.zones), placing});
    }
    if (context.json) {
        nlohmann::ordered_json codes = nlohmann::ordered_json::array();
        for (const auto& [pair, count] : report.polygonsRead) {
            const auto written = report.polygonsWritten.find(pair);
            codes.push_back({{"temperature", pair.temperature},
                             {"material", pair.material},
                             {"polygons_read", count},
                             {"polygons_written",
                              written == report.polygonsWritten.end() ? 0 : written->second}});
            if (const auto added = report.facesThatClose.find(pair);
                added != report.facesThatClose.end())
                codes.back()["polygons_that_close"] = added->second;
        }
        fmt::print("{}\n",
                   jsonText(nlohmann::ordered_json{{"in", options.in},
                                                   {"out", options.out},
                                                   {"drawables_read", report.drawablesRead},
                                                   {"drawables_written", report.drawablesWritten},
                                                   {"codes", codes},
                                                   {"placing", placingJson(report.placing)},
                                                   {"remarks", report.remarks}}));
        return done;
    }
    fmt::print("{} -> {}: {} pairs of codes, {} polygons in {} drawables ({} polygons in {} as "
               "read)\n",
               options.in, options.out, report.polygonsWritten.size(),
               total(report.polygonsWritten), report.drawablesWritten, total(report.polygonsRead),
               report.drawablesRead);
    for (const auto& [pair, count] : report.facesThatClose)
        fmt::print("  closed: material {} and temperature {}, with {} faces\n", pair.material,
                   pair.temperature, count);
    for (const std::string& remark : report.remarks)
        fmt::print("  note: {}\n", remark);
    return done;
}

} // namespace

void addConvertCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand(
        "convert", "Writes a model as .osgt, .osgb, .ive, .osg or .osgx and keeps its codes");
    auto options = std::make_shared<ConvertOptions>();
    command->add_option("IN", options->in, "Model to read")->required()->type_name("");
    command->add_option("OUT", options->out, "Model to write")->required()->type_name("");
    command
        ->add_option("--zones", options->zones,
                     "Signature database: open meshes of its gas materials are closed, so that "
                     "shells become zones of gas")
        ->type_name("FILE.sigdb");
    options->placing =
        std::make_shared<PlacingOptions>(*command, PlacingOptions::Kind::axesAndUnit);
    command->callback([&context, options] {
        context.work = [&context, options] { return convert(*options, context); };
    });
}

} // namespace smat::batch
