#include "irsg/scene/model/IrCodes.h"

#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/ValueObject>
#include <osgSim/ShapeAttribute>

namespace irsg {
namespace {

constexpr const char* temperatureValue = "<UA:IRC>";
constexpr const char* materialValue = "<UA:IRM>";

const osgSim::ShapeAttribute* attribute(const osgSim::ShapeAttributeList* list,
                                        const std::string& name) {
    if (list)
        for (const auto& entry : *list)
            if (entry.getName() == name)
                return &entry;
    return nullptr;
}

int integerOf(const osgSim::ShapeAttribute& entry) {
    return entry.getType() == osgSim::ShapeAttribute::DOUBLE ? static_cast<int>(entry.getDouble())
                                                             : entry.getInt();
}

/// Codes an object states itself; false where it states none.
bool ownCodes(const osg::Object& object, IrCodes& codes) {
    const auto* list = dynamic_cast<const osgSim::ShapeAttributeList*>(object.getUserData());
    const auto* temperature = attribute(list, "IRColor");
    const auto* material = attribute(list, "IRMaterial");
    if (temperature || material) {
        codes = {temperature ? integerOf(*temperature) : 0, material ? integerOf(*material) : 0};
        return true;
    }
    if (!object.getUserDataContainer())
        return false;
    IrCodes values;
    const bool first = object.getUserValue(temperatureValue, values.temperature);
    const bool second = object.getUserValue(materialValue, values.material);
    if (first || second)
        codes = values;
    return first || second;
}

class PolygonCounter : public osg::NodeVisitor {
  public:
    PolygonCounter() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Drawable& drawable) override {
        const auto* geometry = drawable.asGeometry();
        if (!geometry)
            return;
        // Nodes above the drawable, itself not included.
        const auto& path = getNodePath();
        const auto codes = codesOf(drawable, {path.begin(), path.end() - 1});
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i) {
            const auto* set = geometry->getPrimitiveSet(i);
            if (set->getMode() >= GL_TRIANGLES)
                counts[codes] += set->getNumPrimitives();
        }
    }

    std::map<IrCodes, long> counts;
};

} // namespace

IrCodes codesOf(const osg::Drawable& drawable, const std::vector<osg::Node*>& path) {
    IrCodes codes;
    if (ownCodes(drawable, codes))
        return codes;
    for (auto node = path.rbegin(); node != path.rend(); ++node)
        if (ownCodes(**node, codes))
            return codes;
    return {};
}

void setCodes(osg::Drawable& drawable, const IrCodes& codes) {
    osg::ref_ptr<osgSim::ShapeAttributeList> list = new osgSim::ShapeAttributeList;
    list->push_back(osgSim::ShapeAttribute("IRColor", codes.temperature));
    list->push_back(osgSim::ShapeAttribute("IRMaterial", codes.material));
    drawable.setUserDataContainer(nullptr);
    drawable.setUserData(list);
}

std::map<IrCodes, long> polygonCounts(osg::Node& graph) {
    PolygonCounter counter;
    graph.accept(counter);
    return counter.counts;
}

} // namespace irsg
