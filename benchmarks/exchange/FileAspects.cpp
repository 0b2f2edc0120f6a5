#include <algorithm>

#include "benchmarks/exchange/ExchangeCases.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/TracedScene.h"

namespace irsg::bench {

using test::ExchangeCase;

namespace {

std::shared_ptr<const Model> flat(const Model& model) {
    reference::Triangles triangles;
    for (const Mesh::Part& part : model.mesh()->parts)
        for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
            reference::Triangle triangle;
            triangle.codes = part.codes;
            triangle.cullsBackFaces = part.culled;
            for (std::size_t k = 0; k < 3; ++k)
                triangle.vertex[k] = toVec3(part.vertices[part.triangles[i + k]]);
            const Vec3 twice = cross(triangle.vertex[1] - triangle.vertex[0],
                                     triangle.vertex[2] - triangle.vertex[0]);
            if (!(length(twice) > 0.0))
                continue;
            std::ranges::fill(triangle.normal, normalized(twice));
            triangles.push_back(triangle);
        }
    return reference::modelOf(triangles, model.name());
}

} // namespace

std::vector<ExchangeCase> FileAspects::of(const std::filesystem::path& file) const {
    ModelOptions options;
    options.forceTwoSided = isTwoSided;
    std::shared_ptr<const Model> model = Model::load(file, options);
    if (!hasOwnNormals)
        model = flat(*model);
    std::vector<ExchangeCase> cases;
    for (int aspect = 0; aspect < 8; ++aspect) {
        ExchangeCase one =
            test::seenFrom(file.filename().string(),
                           std::to_string(model->mesh()->facets()) + " triangles, " +
                               std::to_string(45 * aspect) + "°",
                           {test::greyEntity(model, 0.7, 330.0)}, 45.0 * aspect, elevation_deg);
        one.skin_m = test::skinOfModel_m(*model);
        if (!isEmissionAlone) {
            one.sun = {.azimuth_rad = radians(60.0), .elevation_rad = radians(40.0)};
            one.sun_W_m2 = 15.0;
            one.sky_W_m2_sr = 0.5;
            one.ground_W_m2_sr = 1.5;
        }
        cases.push_back(std::move(one));
    }
    return cases;
}

} // namespace irsg::bench
