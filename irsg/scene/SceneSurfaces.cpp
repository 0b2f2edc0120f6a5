#include "irsg/scene/SceneSurfaces.h"

#include <algorithm>

#include "irsg/core/Errors.h"

namespace irsg {

std::vector<SurfaceItem> surfaceItems(const std::vector<Entity>& entities, const SurfaceRows& rows,
                                      PreparedEntities& prepared) {
    std::vector<SurfaceItem> items;
    for (int e = 0; e < static_cast<int>(entities.size()); ++e) {
        int piece = 0;
        for (const RenderItem& item : prepared.of(entities[static_cast<std::size_t>(e)]).items) {
            const auto key = std::ranges::lower_bound(rows.keys(), SurfaceKey{e, item.codes});
            if (key == rows.keys().end() || *key != SurfaceKey{e, item.codes})
                throw LogicError("a surface was drawn that the model did not announce");
            const auto drawn = static_cast<int>(key - rows.keys().begin());
            items.push_back({item.geometry.get(), item.modelFromLocal, e, piece++, drawn,
                             rows.isTransparent(drawn), item.cullsBackFaces, item.layer});
        }
    }
    return items;
}

} // namespace irsg
