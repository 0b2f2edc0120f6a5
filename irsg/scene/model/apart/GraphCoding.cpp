#include "irsg/scene/model/apart/GraphCoding.h"

#include <map>
#include <optional>

#include <osg/Billboard>
#include <osg/Camera>
#include <osg/Geode>
#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Sequence>
#include <osg/Switch>
#include <osgSim/MultiSwitch>

#include "irsg/radiometry/Errors.h"
#include "irsg/scene/model/IrCodes.h"
#include "irsg/scene/model/apart/GeometryCoding.h"
#include "irsg/scene/model/apart/GraphExtent.h"
#include "irsg/scene/model/apart/StateCoding.h"

namespace irsg {

namespace {

enum class Kind : std::uint8_t {
    group,
    geode,
    transform,
    lod,
    switching,
    multiSwitch,
    sequence,
    billboard,
    geometry
};

Kind kindOf(osg::Node& node) {
    if (node.asGeometry())
        return Kind::geometry;
    if (dynamic_cast<osg::Billboard*>(&node))
        return Kind::billboard;
    if (dynamic_cast<osg::LOD*>(&node))
        return Kind::lod;
    if (dynamic_cast<osg::Sequence*>(&node))
        return Kind::sequence;
    if (dynamic_cast<osg::Switch*>(&node))
        return Kind::switching;
    if (dynamic_cast<osgSim::MultiSwitch*>(&node))
        return Kind::multiSwitch;
    if (node.asTransform())
        return Kind::transform;
    return node.asGeode() ? Kind::geode : Kind::group;
}

/// What hands nothing to a picture: cameras, and drawables without polygons.
bool isLeftOut(osg::Node& node) {
    return dynamic_cast<osg::Camera*>(&node) || (node.asDrawable() && !node.asGeometry());
}

void putFlags(ByteSink& sink, const std::vector<bool>& flags) {
    sink.putCount(flags.size());
    for (const bool flag : flags)
        sink.put(static_cast<std::uint8_t>(flag));
}

std::vector<bool> getFlags(ByteSource& source) {
    std::vector<bool> flags(source.getCount(1));
    for (std::size_t i = 0; i < flags.size(); ++i)
        flags[i] = source.getFlag();
    return flags;
}

class GraphEncoder {
  public:
    explicit GraphEncoder(const std::string& name) : name_(name) {}

    std::uint32_t put(osg::Node& node, int level) {
        if (const auto known = numbers_.find(&node); known != numbers_.end())
            return known->second;
        if (level > mostLevels)
            throw InputError({name_, "",
                              "a graph of more than " + std::to_string(mostLevels) + " levels",
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
        const Kind kind = kindOf(node);
        sink_.put(kind);
        sink_.putText(node.getName());
        sink_.put(static_cast<std::uint32_t>(node.getNodeMask()));
        sink_.put(states_.number(node.getStateSet()));
        const auto codes = statedCodes(node);
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
        states_.put(sink);
        sink.putCount(numbers_.size());
        sink.putBytes(sink_.bytes().data(), sink_.bytes().size());
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
    void putOwn(Kind kind, osg::Node& node, const std::vector<std::uint32_t>& places) {
        switch (kind) {
        case Kind::group:
        case Kind::geode:
            return;
        case Kind::transform: {
            osg::Matrixd matrix;
            const auto& transform = *node.asTransform();
            transform.computeLocalToWorldMatrix(matrix, nullptr);
            sink_.put(static_cast<std::uint8_t>(transform.getReferenceFrame() !=
                                                osg::Transform::RELATIVE_RF));
            return sink_.putBytes(matrix.ptr(), 16 * sizeof(double));
        }
        case Kind::lod:
            return putLod(dynamic_cast<osg::LOD&>(node), places);
        case Kind::switching: {
            const auto& values = dynamic_cast<osg::Switch&>(node).getValueList();
            return putFlags(sink_, at(values, places, true));
        }
        case Kind::multiSwitch:
            return putMultiSwitch(dynamic_cast<osgSim::MultiSwitch&>(node), places);
        case Kind::sequence: {
            auto& sequence = dynamic_cast<osg::Sequence&>(node);
            for (const auto place : places)
                sink_.put(sequence.getTime(place));
            return;
        }
        case Kind::billboard:
            return putBillboard(dynamic_cast<osg::Billboard&>(node), places);
        case Kind::geometry: {
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
        const osg::Vec3d centre = lod.getCenter();
        sink_.putBytes(centre.ptr(), 3 * sizeof(double));
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
        sink_.putBytes(node.getAxis().ptr(), 3 * sizeof(float));
        sink_.putBytes(node.getNormal().ptr(), 3 * sizeof(float));
        const auto& positions = node.getPositionList();
        for (const auto place : places) {
            const osg::Vec3 position =
                place < positions.size() ? osg::Vec3(positions[place]) : osg::Vec3();
            sink_.putBytes(position.ptr(), 3 * sizeof(float));
        }
    }

    const std::string& name_;
    ByteSink sink_;
    StateEncoder states_;
    std::map<const osg::Node*, std::uint32_t> numbers_;
    long leftOut_ = 0;
};

template <typename Vector>
Vector getVector(ByteSource& source) {
    Vector v;
    const std::string_view bytes = source.getBytes(Vector::num_components * sizeof v[0]);
    std::memcpy(v.ptr(), bytes.data(), bytes.size());
    return v;
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
        const auto kind = source_.get<Kind>();
        const std::string name = source_.getText();
        const auto mask = source_.get<std::uint32_t>();
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
        node->setNodeMask(mask);
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

    osg::ref_ptr<osg::Node> make(Kind kind) {
        if (kind == Kind::geometry) {
            if (!children_.empty())
                throw DamagedBytes("a geometry with nodes below it");
            return getGeometry(source_, name_, misfits_);
        }
        return makeGroup(kind);
    }

    osg::ref_ptr<osg::Group> makeGroup(Kind kind) {
        osg::ref_ptr<osg::Group> group;
        switch (kind) {
        case Kind::group:
        case Kind::geode:
            group = kind == Kind::group ? new osg::Group : new osg::Geode;
            adopt(*group);
            return group;
        case Kind::transform: {
            const bool absolute = source_.getFlag();
            osg::Matrixd matrix;
            const auto bytes = source_.getBytes(16 * sizeof(double));
            std::memcpy(matrix.ptr(), bytes.data(), bytes.size());
            osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(matrix);
            if (absolute)
                transform->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
            adopt(*transform);
            return transform;
        }
        case Kind::lod:
            return makeLod();
        case Kind::switching: {
            osg::ref_ptr<osg::Switch> node = new osg::Switch;
            adopt(*node);
            const auto flags = getFlagsOfChildren();
            for (unsigned int i = 0; i < flags.size(); ++i)
                node->setValue(i, flags[i]);
            return node;
        }
        case Kind::multiSwitch:
            return makeMultiSwitch();
        case Kind::sequence: {
            osg::ref_ptr<osg::Sequence> node = new osg::Sequence;
            adopt(*node);
            for (unsigned int i = 0; i < children_.size(); ++i)
                node->setTime(i, source_.get<double>());
            return node;
        }
        case Kind::billboard:
            return makeBillboard();
        case Kind::geometry:
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
        lod->setCenter(getVector<osg::Vec3d>(source_));
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
        osgSim::MultiSwitch::SwitchSetList sets(source_.getCount(8));
        for (auto& set : sets)
            set = getFlagsOfChildren();
        node->setSwitchSetList(sets);
        if (active < sets.size())
            node->setActiveSwitchSet(active);
        return node;
    }

    osg::ref_ptr<osg::Group> makeBillboard() {
        osg::ref_ptr<osg::Billboard> node = new osg::Billboard;
        const auto mode = source_.get<std::int32_t>();
        if (mode >= osg::Billboard::POINT_ROT_EYE && mode <= osg::Billboard::AXIAL_ROT)
            node->setMode(static_cast<osg::Billboard::Mode>(mode));
        node->setAxis(getVector<osg::Vec3f>(source_));
        node->setNormal(getVector<osg::Vec3f>(source_));
        for (const auto child : children_) {
            osg::Drawable* drawable = nodes_[child]->asDrawable();
            if (!drawable)
                throw DamagedBytes("a billboard of something else than drawables");
            node->addDrawable(drawable, getVector<osg::Vec3f>(source_));
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

void putGraph(ByteSink& sink, osg::Node& graph, const std::string& name,
              std::vector<std::string>& remarks) {
    GraphEncoder encoder(name);
    encoder.put(graph, 0);
    encoder.finish(sink, remarks);
}

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
