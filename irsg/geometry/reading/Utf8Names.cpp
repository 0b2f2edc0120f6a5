#include "irsg/geometry/reading/Utf8Names.h"

#include <set>

#include <osg/NodeVisitor>
#include <osg/StateSet>

#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

class Renaming : public osg::NodeVisitor {
  public:
    Renaming() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }

    void apply(osg::Node& node) override {
        if (!seen_.insert(&node).second)
            return;
        rename(node);
        if (osg::StateSet* const state = node.getStateSet();
            state != nullptr && seen_.insert(state).second) {
            rename(*state);
            for (const auto& [type, attribute] : state->getAttributeList())
                rename(*attribute.first);
        }
        traverse(node);
    }

    int count = 0;

  private:
    void rename(osg::Object& object) {
        if (isUtf8(object.getName()))
            return;
        object.setName(utf8Text(object.getName()));
        ++count;
    }

    std::set<const osg::Object*> seen_;
};

} // namespace

int nameInUtf8(osg::Node& graph) {
    Renaming renaming;
    graph.accept(renaming);
    return renaming.count;
}

} // namespace irsg
