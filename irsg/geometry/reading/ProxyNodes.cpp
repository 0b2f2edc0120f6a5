#include "irsg/geometry/reading/ProxyNodes.h"

#include <set>

#include <osg/Group>
#include <osg/NodeVisitor>

namespace irsg {

namespace {

class ProxyCollector : public osg::NodeVisitor {
  public:
    ProxyCollector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::ProxyNode& node) override {
        if (seen_.insert(&node).second)
            found.push_back(&node);
        traverse(node);
    }
    std::vector<osg::ref_ptr<osg::ProxyNode>> found;

  private:
    std::set<const osg::ProxyNode*> seen_;
};

} // namespace

std::vector<osg::ref_ptr<osg::ProxyNode>> proxiesOf(osg::Node& graph) {
    ProxyCollector proxies;
    graph.accept(proxies);
    return proxies.found;
}

void removeProxies(osg::Node& graph) {
    for (const auto& proxy : proxiesOf(graph)) {
        osg::ref_ptr<osg::Group> group = new osg::Group;
        group->setName(proxy->getName());
        group->setStateSet(proxy->getStateSet());
        group->setNodeMask(proxy->getNodeMask());
        for (unsigned int i = 0; i < proxy->getNumChildren(); ++i)
            group->addChild(proxy->getChild(i));
        while (proxy->getNumParents() > 0)
            proxy->getParent(0)->replaceChild(proxy, group);
    }
}

} // namespace irsg
