#include "irsg/geometry/conversion/ModelNames.h"

#include <algorithm>

#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/geometry/reading/NoFaces.h"

namespace irsg {

ModelNames namesOf(const std::filesystem::path& model, const ModelCodes& codes) {
    LoadedGraph loaded = loadGraphAsIs(model, LoadPurpose::infrared);
    ModelNames names;
    if (!codes.empty())
        names.remarks = giveCodes(loaded.node, codes, model.string());
    names.names = namesIn(*loaded.node, model.string(), &names.parts);
    // As Model::load, so that nobody takes an empty list for a model.
    const auto isDrawn = [](const auto& ofKind) {
        return std::ranges::any_of(ofKind,
                                   [](const auto& named) { return named.second.area > 0.0; });
    };
    if (std::ranges::none_of(names.names, isDrawn))
        refuseWithoutFaces(model.string(), loaded.remarks);
    return names;
}

} // namespace irsg
