#include "irsg/geometry/model/Painting.h"

#include <algorithm>
#include <functional>

#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/conversion/PaintedGrid.h"

namespace irsg {
namespace {

std::array<double, 9> written(const FaceMesh::Triangle& triangle, bool turned) {
    std::array<double, 9> places{};
    for (std::size_t k = 0; k < 3; ++k) {
        double* place = &places[3 * (turned ? 2 - k : k)];
        place[0] = triangle[k].x, place[1] = triangle[k].y, place[2] = triangle[k].z;
    }
    return places;
}

osg::Vec3d frontOf(const FaceMesh::Face& face) {
    return toOsg(face.normal) * (face.turned ? -1.0 : 1.0);
}

void addTo(std::vector<PaintedSurface>& surfaces, const GivenCodes& codes, const FaceMesh& mesh,
           const FaceMesh::Face& face) {
    // The last, since later surfaces win.
    auto surface = std::find_if(surfaces.rbegin(), surfaces.rend(),
                                [&](const PaintedSurface& one) { return one.codes == codes; });
    if (surface == surfaces.rend()) {
        surfaces.push_back({codes, {}});
        surface = surfaces.rbegin();
    }
    for (const auto& triangle : mesh.trianglesOf(face))
        surface->triangles.push_back(written(triangle, face.turned));
}

/// `given` tells what a face is painted with, of what it was.
std::vector<PaintedSurface> repainted(const std::vector<PaintedSurface>& before,
                                      const FaceMesh& mesh, const FaceNumbers& faces,
                                      const std::function<GivenCodes(const GivenCodes&)>& given) {
    const PaintedGrid grid(before);
    std::vector<bool> isChosen(mesh.faces().size());
    PaintedSurface own;
    for (const unsigned int f : faces) {
        isChosen.at(f) = true;
        for (const auto& triangle : mesh.trianglesOf(mesh.faces()[f]))
            own.triangles.push_back(written(triangle, mesh.faces()[f].turned));
    }

    // What lies on the faces goes, and what they take their codes from.
    std::vector<const std::array<double, 9>*> triangles;
    for (const PaintedSurface& surface : before)
        for (const auto& triangle : surface.triangles)
            triangles.push_back(&triangle);
    std::vector<bool> goes(triangles.size());
    const PaintedGrid chosen({own});
    for (std::size_t i = 0; i < triangles.size() && !chosen.empty(); ++i) {
        const auto& c = *triangles[i];
        const osg::Vec3d a(c[0], c[1], c[2]), b(c[3], c[4], c[5]), d(c[6], c[7], c[8]);
        osg::Vec3d normal = (b - a) ^ (d - a);
        normal.normalize();
        goes[i] = chosen.find((a + b + d) / 3.0, normal) >= 0;
    }
    std::vector<int> surfaceOf(mesh.faces().size(), -1);
    for (unsigned int f = 0; f < mesh.faces().size() && !grid.empty(); ++f) {
        const auto& face = mesh.faces()[f];
        surfaceOf[f] = grid.find(toOsg(face.point), frontOf(face));
        if (isChosen[f] && surfaceOf[f] >= 0)
            for (const unsigned int i : grid.holding(toOsg(face.point), frontOf(face)))
                goes[i] = true;
    }

    std::vector<PaintedSurface> after;
    std::size_t number = 0;
    for (const PaintedSurface& surface : before) {
        after.push_back({surface.codes, {}});
        for (const auto& triangle : surface.triangles)
            if (!goes[number++])
                after.back().triangles.push_back(triangle);
    }
    for (unsigned int f = 0; f < mesh.faces().size(); ++f) {
        const auto& face = mesh.faces()[f];
        const GivenCodes was =
            surfaceOf[f] < 0 ? GivenCodes() : before[static_cast<std::size_t>(surfaceOf[f])].codes;
        if (isChosen[f]) {
            if (const GivenCodes now = given(was); now != GivenCodes())
                addTo(after, now, mesh, face);
        } else if (surfaceOf[f] >= 0) {
            // Others that lay on what went keep their codes.
            const auto held = grid.holding(toOsg(face.point), frontOf(face));
            if (std::ranges::any_of(held, [&](unsigned int i) { return goes[i]; }))
                addTo(after, was, mesh, face);
        }
    }
    std::erase_if(after, [](const PaintedSurface& surface) { return surface.triangles.empty(); });
    return after;
}

} // namespace

std::vector<PaintedSurface> painted(const std::vector<PaintedSurface>& before, const FaceMesh& mesh,
                                    const FaceNumbers& faces, const GivenCodes& codes) {
    return repainted(before, mesh, faces, [&](const GivenCodes& was) {
        return GivenCodes{codes.temperature ? codes.temperature : was.temperature,
                          codes.material ? codes.material : was.material};
    });
}

std::vector<PaintedSurface> erased(const std::vector<PaintedSurface>& before, const FaceMesh& mesh,
                                   const FaceNumbers& faces) {
    return repainted(before, mesh, faces, [](const GivenCodes&) { return GivenCodes(); });
}

} // namespace irsg
