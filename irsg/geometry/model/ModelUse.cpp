#include "irsg/geometry/model/ModelUse.h"

namespace irsg {

ModelUse useOf(const Model& model) {
    ModelUse use;
    use.name = model.name();
    for (const auto& [codes, carried] : model.codes()) {
        use.temperatureFaces[codes.temperature] += carried.faces;
        use.materialFaces[codes.material] += carried.faces;
        use.temperaturesOfMaterial[codes.material].insert(codes.temperature);
    }
    for (const std::string& remark : model.remarks())
        if (remark.find("LOD") != std::string::npos)
            use.levelsOfDetail.push_back(remark);
    for (const SharedPlane& shared : model.sharedPlanes())
        use.sharedPlanes.push_back(toText(shared));
    return use;
}

} // namespace irsg
