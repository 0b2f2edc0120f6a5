#include "irsg/geometry/conversion/ModelNames.h"

#include "irsg/geometry/conversion/CodedGraph.h"
#include "irsg/geometry/conversion/ModelLoader.h"

namespace irsg {

ModelNames namesOf(const std::filesystem::path& model, const ModelCodes& codes) {
    LoadedGraph loaded = loadGraphAsIs(model, LoadPurpose::infrared);
    ModelNames names;
    if (!codes.empty())
        names.remarks = giveCodes(loaded.node, codes, model.string());
    names.names = namesIn(*loaded.node, model.string());
    return names;
}

} // namespace irsg
