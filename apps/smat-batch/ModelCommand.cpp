#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PlacingOptions.h"
#include "irsg/geometry/mesh/MeshSurfaces.h"
#include "irsg/geometry/model/Model.h"
#include "irsg/geometry/model/PlacingGuess.h"

namespace smat::batch {

namespace {

nlohmann::ordered_json guessJson(const irsg::PlacingGuess& guess) {
    auto json = placingJson(guess.placing);
    json["reasons"] = guess.reasons;
    return json;
}

/// What all surfaces of a model have together.
struct Surfaces {
    std::size_t all = 0, closed = 0;
    std::size_t facets = 0, twoSided = 0, twoSidedOfClosed = 0;
    std::size_t openEdges = 0, flippedEdges = 0;

    explicit Surfaces(const irsg::Mesh& mesh) {
        for (const irsg::MeshSurface& one : irsg::surfacesOf(mesh)) {
            ++all;
            closed += one.isClosed() ? 1 : 0;
            facets += one.facets;
            twoSided += one.twoSidedFacets;
            twoSidedOfClosed += one.isClosed() ? one.twoSidedFacets : 0;
            openEdges += one.openEdges;
            flippedEdges += one.flippedEdges;
        }
    }
    nlohmann::ordered_json json() const {
        return {{"count", all},
                {"closed", closed},
                {"triangles", facets},
                {"two_sided_triangles", twoSided},
                {"two_sided_triangles_of_closed", twoSidedOfClosed},
                {"open_edges", openEdges},
                {"flipped_edges", flippedEdges}};
    }
    void print() const {
        fmt::print("  surfaces: {}, of which {} closed; {} open edges\n", all, closed, openEdges);
        if (twoSided > 0)
            fmt::print(
                "    {} of {} triangles are seen from both sides, {} of them on closed surfaces, "
                "whose inside keeps its light\n",
                twoSided, facets, twoSidedOfClosed);
        if (flippedEdges > 0)
            fmt::print("    at {} edges two triangles turn their fronts to different sides\n",
                       flippedEdges);
    }
};

int modelInfo(const std::string& file, const irsg::ModelOptions& options, Context& context) {
    std::shared_ptr<irsg::Model> model;
    irsg::PlacingGuess guess;
    {
        const StageTimer::Scope scope(&context.timer, "load");
        model = irsg::Model::load(file, options);
        guess = irsg::placingGuess(file);
    }
    const irsg::BoundingBox& box = model->bounds();
    if (context.json) {
        nlohmann::ordered_json codes = nlohmann::ordered_json::array();
        for (const auto& [pair, use] : model->codes()) {
            codes.push_back({{"temperature", pair.temperature},
                             {"material", pair.material},
                             {"faces", use.faces},
                             {"area_m2", use.area_m2}});
        }
        fmt::print("{}\n",
                   jsonText(nlohmann::ordered_json{{"file", file},
                                                   {"min_m", {box.min.x, box.min.y, box.min.z}},
                                                   {"max_m", {box.max.x, box.max.y, box.max.z}},
                                                   {"codes", codes},
                                                   {"surfaces", Surfaces(*model->mesh()).json()},
                                                   {"placing", placingJson(model->placing())},
                                                   {"guess", guessJson(guess)},
                                                   {"remarks", model->remarks()}}));
        return done;
    }
    int faces = 0;
    double area_m2 = 0.0;
    fmt::print("{}\n", file);
    fmt::print(
        "  x {:.4g} to {:.4g} m (starboard), y {:.4g} to {:.4g} m (nose), z {:.4g} to {:.4g} "
        "m (up)\n",
        box.min.x, box.max.x, box.min.y, box.max.y, box.min.z, box.max.z);
    fmt::print("  {:>12} {:>12} {:>8} {:>14}\n", "temperature", "material", "faces", "area m2");
    for (const auto& [pair, use] : model->codes()) {
        fmt::print("  {:>12} {:>12} {:>8} {:>14.6g}\n", pair.temperature, pair.material, use.faces,
                   use.area_m2);
        faces += use.faces;
        area_m2 += use.area_m2;
    }
    fmt::print("  {:>25} {:>8} {:>14.6g}\n", "all", faces, area_m2);
    Surfaces(*model->mesh()).print();
    const auto& axes = irsg::modelAxisNames();
    const auto placed = [&](const irsg::ModelPlacing& as) {
        return fmt::format("up {}, nose {}, unit {} m", axes[static_cast<std::size_t>(*as.up)],
                           axes[static_cast<std::size_t>(*as.nose)], *as.unit_m);
    };
    fmt::print("  placed: {}\n", placed(model->placing()));
    fmt::print("  guess: {}\n", placed(guess.placing));
    for (const std::string& reason : guess.reasons)
        fmt::print("    {}\n", reason);
    for (const std::string& remark : model->remarks())
        fmt::print("  note: {}\n", remark);
    return done;
}

} // namespace

void addModelCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("model", "Looks into a model");
    command->require_subcommand(1);
    CLI::App* infoCommand =
        command->add_subcommand("info", "Size, codes, faces, areas and surfaces");
    auto file = std::make_shared<std::string>();
    infoCommand->add_option("FILE", *file, "Model")->required()->type_name("");
    auto placing = std::make_shared<PlacingOptions>(*infoCommand);
    infoCommand->callback([&context, file, placing] {
        context.work = [&context, file, placing] {
            return modelInfo(*file, placing->over({}), context);
        };
    });
    addModelCodesCommand(*command, context);
}

} // namespace smat::batch
