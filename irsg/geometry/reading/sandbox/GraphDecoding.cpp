#include <cstring>
#include <optional>

#include <osg/Billboard>
#include <osg/Geode>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Sequence>
#include <osg/Switch>
#include <osgSim/MultiSwitch>

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

std::vector<std::string> getTexts(ByteSource& source) {
    std::vector<std::string> texts(source.getCount(8));
    for (std::string& text : texts)
        text = source.getText();
    return texts;
}

std::vector<bool> getFlags(ByteSource& source) {
    std::vector<bool> flags(source.getCount(1));
    for (std::size_t i = 0; i < flags.size(); ++i)
        flags[i] = source.getFlag();
    return flags;
}

class GraphDecoder {
  public:
    GraphDecoder(ByteSource& source, const std::string& name)
        : source_(source), name_(name), states_(getStates(source)), extent_(name) {}

    osg::ref_ptr<osg::Node> get() {
        const std::size_t count = source_.getCount(20);
        if (count == 0)
            throw DamagedBytes("a graph of nothing");
        nodes_.reserve(count);
        while (nodes_.size() < count)
            getNode();
        return nodes_.back();
    }
    int misfits() const { return misfits_; }

  private:
    void getNode() {
        const auto kind = source_.get<NodeKind>();
        const std::string name = source_.getText();
        const std::vector<std::string> descriptions = getTexts(source_);
        const auto mask = source_.get<std::uint32_t>();
        const auto variance = source_.get<std::uint8_t>();
        if (variance > osg::Object::UNSPECIFIED)
            throw DamagedBytes("a node that changes in no known way");
        const auto state = source_.get<std::int32_t>();
        if (state < -1 || state >= static_cast<std::int32_t>(states_.size()))
            throw DamagedBytes("a node in a state that is not there");
        std::optional<IrCodes> codes;
        if (source_.getFlag())
            codes = source_.get<IrCodes>();
        children_.resize(source_.getCount(4));
        for (auto& child : children_)
            child = source_.getIndex(nodes_.size());

        const osg::ref_ptr<osg::Node> node = make(kind);
        node->setName(name);
        if (!descriptions.empty())
            node->setDescriptions(descriptions);
        node->setNodeMask(mask);
        node->setDataVariance(static_cast<osg::Object::DataVariance>(variance));
        if (state >= 0)
            node->setStateSet(states_[static_cast<std::size_t>(state)]);
        if (codes)
            setCodes(*node, *codes);
        extent_.add(*node, children_);
        nodes_.push_back(node);
    }

    void adopt(osg::Group& group) {
        for (const auto child : children_)
            group.addChild(nodes_[child]);
    }

    osg::ref_ptr<osg::Node> make(NodeKind kind) {
        if (kind == NodeKind::geometry) {
            if (!children_.empty())
                throw DamagedBytes("a geometry with nodes below it");
            return getGeometry(source_, name_, misfits_);
        }
        return makeGroup(kind);
    }

    osg::ref_ptr<osg::Group> makeGroup(NodeKind kind) {
        osg::ref_ptr<osg::Group> group;
        switch (kind) {
        case NodeKind::group:
        case NodeKind::geode:
            group = kind == NodeKind::group ? new osg::Group : new osg::Geode;
            adopt(*group);
            return group;
        case NodeKind::transform: {
            const bool absolute = source_.getFlag();
            osg::ref_ptr<osg::MatrixTransform> transform =
                new osg::MatrixTransform(getNumbers<osg::Matrixd>(source_));
            if (absolute)
                transform->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
            adopt(*transform);
            return transform;
        }
        case NodeKind::joint: {
            const osg::ref_ptr<osgSim::DOFTransform> node = getJoint(source_);
            adopt(*node);
            return node;
        }
        case NodeKind::lod:
            return makeLod();
        case NodeKind::switching: {
            osg::ref_ptr<osg::Switch> node = new osg::Switch;
            adopt(*node);
            const auto flags = getFlagsOfChildren();
            for (unsigned int i = 0; i < flags.size(); ++i)
                node->setValue(i, flags[i]);
            return node;
        }
        case NodeKind::multiSwitch:
            return makeMultiSwitch();
        case NodeKind::sequence: {
            osg::ref_ptr<osg::Sequence> node = new osg::Sequence;
            adopt(*node);
            for (unsigned int i = 0; i < children_.size(); ++i)
                node->setTime(i, source_.get<double>());
            return node;
        }
        case NodeKind::billboard:
            return makeBillboard();
        case NodeKind::geometry:
            break;
        }
        throw DamagedBytes("a node of no kind");
    }

    std::vector<bool> getFlagsOfChildren() {
        auto flags = getFlags(source_);
        if (flags.size() != children_.size())
            throw DamagedBytes("a switch of other nodes than its own");
        return flags;
    }

    osg::ref_ptr<osg::Group> makeLod() {
        osg::ref_ptr<osg::LOD> lod = new osg::LOD;
        adopt(*lod);
        const auto mode = source_.get<std::int32_t>(), centre = source_.get<std::int32_t>();
        lod->setRangeMode(mode == osg::LOD::PIXEL_SIZE_ON_SCREEN
                              ? osg::LOD::PIXEL_SIZE_ON_SCREEN
                              : osg::LOD::DISTANCE_FROM_EYE_POINT);
        lod->setCenter(getNumbers<osg::Vec3d>(source_));
        if (centre != osg::LOD::USER_DEFINED_CENTER &&
            centre != osg::LOD::UNION_OF_BOUNDING_SPHERE_AND_USER_DEFINED)
            lod->setCenterMode(osg::LOD::USE_BOUNDING_SPHERE_CENTER);
        lod->setRadius(static_cast<float>(source_.get<double>()));
        for (unsigned int i = 0; i < children_.size(); ++i) {
            const auto least = source_.get<float>();
            lod->setRange(i, least, source_.get<float>());
        }
        return lod;
    }

    osg::ref_ptr<osg::Group> makeMultiSwitch() {
        osg::ref_ptr<osgSim::MultiSwitch> node = new osgSim::MultiSwitch;
        adopt(*node);
        const auto active = source_.get<std::uint32_t>();
        const auto sets = static_cast<unsigned int>(source_.getCount(8));
        for (unsigned int i = 0; i < sets; ++i)
            node->setValueList(i, getFlagsOfChildren());
        if (active < sets)
            node->setActiveSwitchSet(active);
        return node;
    }

    osg::ref_ptr<osg::Group> makeBillboard() {
        osg::ref_ptr<osg::Billboard> node = new osg::Billboard;
        const auto mode = source_.get<std::int32_t>();
        if (mode >= osg::Billboard::POINT_ROT_EYE && mode <= osg::Billboard::AXIAL_ROT)
            node->setMode(static_cast<osg::Billboard::Mode>(mode));
        node->setAxis(getNumbers<osg::Vec3f>(source_));
        node->setNormal(getNumbers<osg::Vec3f>(source_));
        for (const auto child : children_) {
            osg::Drawable* drawable = nodes_[child]->asDrawable();
            if (!drawable)
                throw DamagedBytes("a billboard of something else than drawables");
            node->addDrawable(drawable, getNumbers<osg::Vec3f>(source_));
        }
        return node;
    }

    ByteSource& source_;
    const std::string& name_;
    std::vector<osg::ref_ptr<osg::StateSet>> states_;
    std::vector<osg::ref_ptr<osg::Node>> nodes_;
    std::vector<std::uint32_t> children_; ///< of the node that is read
    GraphExtent extent_;
    int misfits_ = 0;
};

} // namespace

osg::ref_ptr<osg::Node> getGraph(ByteSource& source, const std::string& name,
                                 std::vector<std::string>& remarks) {
    GraphDecoder decoder(source, name);
    osg::ref_ptr<osg::Node> graph = decoder.get();
    if (decoder.misfits() > 0)
        remarks.push_back(std::to_string(decoder.misfits()) +
                          " drawables had normals, colours or texture coordinates for some of "
                          "their vertices only: removed");
    return graph;
}

} // namespace irsg
