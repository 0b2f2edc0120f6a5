#include "irsg/geometry/mesh/Mesh.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace irsg {

std::size_t Mesh::facets() const {
    std::size_t corners = 0;
    for (const Part& part : parts)
        corners += part.triangles.size();
    return corners / 3;
}

Mesh meshOf(std::vector<Mesh::Part> parts) {
    Mesh mesh;
    mesh.parts = std::move(parts);
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
        const Mesh::Part& part = mesh.parts[i];
        mesh.pieces.push_back({i, 0, part.triangles.size(), part.bounds});
        mesh.bounds.include(part.bounds);
    }
    mesh.sphere.centre_m = mesh.bounds.centre();
    double square_m2 = 0.0;
    for (const Mesh::Part& part : mesh.parts)
        for (const Float3& vertex : part.vertices) {
            const Vec3 arm = toVec3(vertex) - mesh.sphere.centre_m;
            square_m2 = std::max(square_m2, dot(arm, arm));
        }
    mesh.sphere.radius_m = std::sqrt(square_m2) * (1.0 + 1e-9);
    return mesh;
}

} // namespace irsg
