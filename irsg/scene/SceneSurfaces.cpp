#include "irsg/scene/SceneSurfaces.h"

#include <algorithm>

#include "irsg/core/Errors.h"

namespace irsg {

std::vector<SurfaceItem> surfaceItems(const std::vector<Entity>& entities,
                                      const SurfaceRows& rows) {
    std::vector<SurfaceItem> items;
    for (int e = 0; e < static_cast<int>(entities.size()); ++e) {
        const Mesh& mesh = *entities[static_cast<std::size_t>(e)].model->mesh();
        for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
            const SurfaceKey wanted{e, mesh.partOf(mesh.pieces[i]).codes};
            const auto key = std::ranges::lower_bound(rows.keys(), wanted);
            if (key == rows.keys().end() || *key != wanted)
                throw LogicError("a surface was drawn that the model did not announce");
            const auto row = static_cast<int>(key - rows.keys().begin());
            items.push_back({e, i, row, rows.isTransparent(row)});
        }
    }
    return items;
}

} // namespace irsg
