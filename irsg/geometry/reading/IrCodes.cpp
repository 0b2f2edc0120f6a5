#include "irsg/geometry/reading/IrCodes.h"

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

std::optional<IrCodes> declaredCodes(const osg::Object& object) {
    const auto* list = dynamic_cast<const osgSim::ShapeAttributeList*>(object.getUserData());
    const auto* temperature = attribute(list, "IRColor");
    const auto* material = attribute(list, "IRMaterial");
    if (temperature || material)
        return IrCodes{temperature ? integerOf(*temperature) : 0,
                       material ? integerOf(*material) : 0};
    if (!object.getUserDataContainer())
        return std::nullopt;
    IrCodes values;
    const bool first = object.getUserValue(temperatureValue, values.temperature);
    const bool second = object.getUserValue(materialValue, values.material);
    return first || second ? std::optional(values) : std::nullopt;
}

IrCodes codesOf(const osg::Drawable& drawable, const std::vector<osg::Node*>& path) {
    if (const auto codes = declaredCodes(drawable))
        return *codes;
    for (auto node = path.rbegin(); node != path.rend(); ++node)
        if (const auto codes = declaredCodes(**node))
            return *codes;
    return {};
}

void setCodes(osg::Object& object, const IrCodes& codes) {
    osg::ref_ptr<osgSim::ShapeAttributeList> list = new osgSim::ShapeAttributeList;
    list->push_back(osgSim::ShapeAttribute("IRColor", codes.temperature));
    list->push_back(osgSim::ShapeAttribute("IRMaterial", codes.material));
    object.setUserDataContainer(nullptr);
    object.setUserData(list);
}

std::map<IrCodes, long> polygonCounts(osg::Node& graph) {
    PolygonCounter counter;
    graph.accept(counter);
    return counter.counts;
}

} // namespace irsg
