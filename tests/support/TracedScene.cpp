#include "tests/support/TracedScene.h"

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg::test {

std::vector<TracedTriangle> tracedOf(const Scene& scene, const Band& band) {
    std::vector<TracedTriangle> traced;
    for (std::size_t e = 0; e < scene.entities.size(); ++e) {
        const Entity& entity = scene.entities[e];
        for (const Mesh::Part& part : entity.model->mesh()->parts) {
            const Material* material = materialEntry(entity, part.codes.material);
            const TemperatureEntry* temperature = temperatureEntry(entity, part.codes.temperature);
            if (material == nullptr || temperature == nullptr) {
                throw LogicError("a facet has no material or no temperature");
            }
            if (material->transmissivity.minimum() >= 1.0) {
                continue;
            }
            if (!material->isOpaque() || !material->emissivity.isConstant() ||
                material->nAngleFactor != 0.0 || !material->surfaceModel.empty()) {
                throw LogicError("the path tracer takes grey, opaque and even surfaces alone");
            }
            const double emissivity = material->emissivity.at(1.0);
            TracedTriangle triangle;
            triangle.isTwoSided = !part.culled;
            triangle.emitted_W_m2_sr =
                emissivity * bandRadiance_W_m2_sr(band, temperature->terms.base_K);
            triangle.reflectivity = 1.0 - emissivity;
            triangle.body = static_cast<int>(e);
            for (std::size_t i = 0; i + 2 < part.triangles.size(); i += 3) {
                for (std::size_t k = 0; k < 3; ++k) {
                    triangle.corners_m[k] =
                        entity.pose.toWorld(toVec3(part.vertices[part.triangles[i + k]]));
                }
                traced.push_back(triangle);
            }
        }
    }
    return traced;
}

double skinOfModel_m(const Model& model) {
    return 2e-7 * model.bounds().diagonal_m();
}

} // namespace irsg::test
