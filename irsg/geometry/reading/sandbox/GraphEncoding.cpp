#include <map>
#include <utility>

#include <osg/Billboard>
#include <osg/Camera>
#include <osg/Geode>
#include <osg/LOD>
#include <osg/Sequence>
#include <osg/Switch>
#include <osgSim/MultiSwitch>

#include "irsg/core/Errors.h"
#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/sandbox/GeometryCoding.h"
#include "irsg/geometry/reading/sandbox/GraphCoding.h"
#include "irsg/geometry/reading/sandbox/GraphExtent.h"
#include "irsg/geometry/reading/sandbox/JointCoding.h"
#include "irsg/geometry/reading/sandbox/NodeKind.h"
#include "irsg/geometry/reading/sandbox/NumberCoding.h"
#include "irsg/geometry/reading/sandbox/StateCoding.h"

namespace irsg {

namespace {

NodeKind kindOf(osg::Node& node) {
    if (node.asGeometry())
        return NodeKind::geometry;
    if (dynamic_cast<osg::Billboard*>(&node))
        return NodeKind::billboard;
    if (dynamic_cast<osg::LOD*>(&node))
        return NodeKind::lod;
    if (dynamic_cast<osg::Sequence*>(&node))
        return NodeKind::sequence;
    if (dynamic_cast<osg::Switch*>(&node))
        return NodeKind::switching;
    if (dynamic_cast<osgSim::MultiSwitch*>(&node))
        return NodeKind::multiSwitch;
    if (dynamic_cast<osgSim::DOFTransform*>(&node))
        return NodeKind::joint;
    if (node.asTransform())
        return NodeKind::transform;
    return node.asGeode() ? NodeKind::geode : NodeKind::group;
}

/// What hands nothing to a picture: cameras, and drawables without polygons.
bool isLeftOut(osg::Node& node) {
    return dynamic_cast<osg::Camera*>(&node) || (node.asDrawable() && !node.asGeometry());
}

void putTexts(ByteSink& sink, const std::vector<std::string>& texts) {
    sink.putCount(texts.size());
    for (const std::string& text : texts)
        sink.putText(text);
}

void putFlags(ByteSink& sink, const std::vector<bool>& flags) {
    sink.putCount(flags.size());
    for (const bool flag : flags)
        sink.put(static_cast<std::uint8_t>(flag));
}

class GraphEncoder {
  public:
    explicit GraphEncoder(const std::string& name)
        : name_(name), allowedLevels_(allowanceOf(name).levels) {}

    std::uint32_t put(osg::Node& node, int level) {
        if (const auto known = numbers_.find(&node); known != numbers_.end())
            return known->second;
        if (level > allowedLevels_)
            throw InputError({name_, "",
                              "a graph of more than " + std::to_string(allowedLevels_) + " levels",
                              "a model in fewer levels"});
        // Children first, so that every number that is written is known.
        std::vector<std::uint32_t> children, places;
        if (osg::Group* group = node.asGroup())
            for (unsigned int i = 0; i < group->getNumChildren(); ++i) {
                if (isLeftOut(*group->getChild(i))) {
                    ++leftOut_;
                    continue;
                }
                children.push_back(put(*group->getChild(i), level + 1));
                places.push_back(i);
            }
        const NodeKind kind = kindOf(node);
        sink_.put(kind);
        sink_.putText(node.getName());
        putTexts(sink_, node.getDescriptions());
        sink_.put(static_cast<std::uint32_t>(node.getNodeMask()));
        sink_.put(static_cast<std::uint8_t>(node.getDataVariance()));
        sink_.put(states_.number(node.getStateSet()));
        const auto codes = declaredCodes(node);
        sink_.put(static_cast<std::uint8_t>(codes.has_value()));
        if (codes)
            sink_.put(*codes);
        sink_.putCount(children.size());
        for (const auto child : children)
            sink_.put(child);
        putOwn(kind, node, places);
        const auto number = static_cast<std::uint32_t>(numbers_.size());
        numbers_.emplace(&node, number);
        return number;
    }

    void finish(ByteSink& sink, std::vector<std::string>& remarks) {
        states_.moveTo(sink);
        sink.putCount(numbers_.size());
        sink.append(std::move(sink_));
        if (leftOut_ > 0)
            remarks.push_back(std::to_string(leftOut_) +
                              " texts, cameras and other drawables without polygons are left out");
        std::string kinds;
        for (const std::string& kind : states_.leftOut())
            kinds += (kinds.empty() ? "" : ", ") + kind;
        if (!kinds.empty())
            remarks.push_back("states of these kinds are left out: " + kinds);
    }

  private:
    void putOwn(NodeKind kind, osg::Node& node, const std::vector<std::uint32_t>& places) {
        switch (kind) {
        case NodeKind::group:
        case NodeKind::geode:
            return;
        case NodeKind::transform: {
            osg::Matrixd matrix;
            const auto& transform = *node.asTransform();
            transform.computeLocalToWorldMatrix(matrix, nullptr);
            sink_.put(static_cast<std::uint8_t>(transform.getReferenceFrame() !=
                                                osg::Transform::RELATIVE_RF));
            return putNumbers(sink_, matrix);
        }
        case NodeKind::joint:
            return putJoint(sink_, dynamic_cast<osgSim::DOFTransform&>(node));
        case NodeKind::lod:
            return putLod(dynamic_cast<osg::LOD&>(node), places);
        case NodeKind::switching: {
            const auto& values = dynamic_cast<osg::Switch&>(node).getValueList();
            return putFlags(sink_, at(values, places, true));
        }
        case NodeKind::multiSwitch:
            return putMultiSwitch(dynamic_cast<osgSim::MultiSwitch&>(node), places);
        case NodeKind::sequence: {
            auto& sequence = dynamic_cast<osg::Sequence&>(node);
            for (const auto place : places)
                sink_.put(sequence.getTime(place));
            return;
        }
        case NodeKind::billboard:
            return putBillboard(dynamic_cast<osg::Billboard&>(node), places);
        case NodeKind::geometry: {
            auto& geometry = *node.asGeometry();
            if (geometry.containsDeprecatedData())
                geometry.fixDeprecatedData();
            return putGeometry(sink_, geometry, name_);
        }
        }
    }

    static std::vector<bool> at(const std::vector<bool>& values,
                                const std::vector<std::uint32_t>& places, bool otherwise) {
        std::vector<bool> flags;
        for (const auto place : places)
            flags.push_back(place < values.size() ? values[place] : otherwise);
        return flags;
    }

    void putLod(const osg::LOD& lod, const std::vector<std::uint32_t>& places) {
        sink_.put(static_cast<std::int32_t>(lod.getRangeMode()));
        sink_.put(static_cast<std::int32_t>(lod.getCenterMode()));
        putNumbers(sink_, osg::Vec3d(lod.getCenter()));
        sink_.put(static_cast<double>(lod.getRadius()));
        for (const auto place : places) {
            const bool stated = place < lod.getNumRanges();
            sink_.put(stated ? lod.getMinRange(place) : 0.0f);
            sink_.put(stated ? lod.getMaxRange(place) : 0.0f);
        }
    }

    void putMultiSwitch(const osgSim::MultiSwitch& node, const std::vector<std::uint32_t>& places) {
        const auto& sets = node.getSwitchSetList();
        sink_.put(static_cast<std::uint32_t>(node.getActiveSwitchSet()));
        sink_.putCount(sets.size());
        for (const auto& set : sets)
            putFlags(sink_, at(set, places, true));
    }

    void putBillboard(const osg::Billboard& node, const std::vector<std::uint32_t>& places) {
        sink_.put(static_cast<std::int32_t>(node.getMode()));
        putNumbers(sink_, node.getAxis());
        putNumbers(sink_, node.getNormal());
        const auto& positions = node.getPositionList();
        for (const auto place : places)
            putNumbers(sink_, place < positions.size() ? osg::Vec3(positions[place]) : osg::Vec3());
    }

    const std::string& name_;
    int allowedLevels_;
    ByteSink sink_;
    StateEncoder states_;
    std::map<const osg::Node*, std::uint32_t> numbers_;
    long leftOut_ = 0;
};

} // namespace

void putGraph(ByteSink& sink, osg::Node& graph, const std::string& name,
              std::vector<std::string>& remarks) {
    GraphEncoder encoder(name);
    encoder.put(graph, 0);
    encoder.finish(sink, remarks);
}

} // namespace irsg
