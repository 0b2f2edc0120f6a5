#include "irsg/geometry/conversion/GeometryCollector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <osg/Billboard>
#include <osg/Camera>
#include <osg/CullFace>
#include <osg/FrontFace>
#include <osg/Geometry>
#include <osg/LOD>
#include <osg/PolygonOffset>
#include <osg/Sequence>
#include <osg/Transform>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/reading/IrCodes.h"

namespace irsg {
namespace {

long polygonsOf(osg::Node& node) {
    long sum = 0;
    for (const auto& [codes, count] : polygonCounts(node))
        sum += count;
    return sum;
}

/// The LOD a child of a group is, directly or below its own transform.
const osg::LOD* lodOf(const osg::Node* node) {
    while (node) {
        if (const auto* lod = dynamic_cast<const osg::LOD*>(node))
            return lod;
        const auto* transform = node->asTransform();
        node = transform && transform->getNumChildren() == 1 ? transform->getChild(0) : nullptr;
    }
    return nullptr;
}

bool inMetres(const osg::LOD& lod) {
    return lod.getRangeMode() == osg::LOD::DISTANCE_FROM_EYE_POINT;
}

/// Where the finest child begins: the least distance, or minus the most pixels.
double start(const osg::LOD& lod, unsigned int child) {
    return inMetres(lod) ? lod.getMinRange(child) : -lod.getMaxRange(child);
}

double finest(const osg::LOD& lod) {
    double least = HUGE_VAL;
    for (unsigned int i = 0; i < std::min(lod.getNumRanges(), lod.getNumChildren()); ++i)
        least = std::min(least, start(lod, i));
    return least;
}

class RangeCollector : public osg::NodeVisitor {
  public:
    RangeCollector() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::LOD& lod) override {
        if (inMetres(lod))
            for (const auto& range : lod.getRangeList())
                ranges.emplace_back(range.first, range.second);
        traverse(lod);
    }
    std::vector<std::pair<double, double>> ranges;
};

/// n' = n M^-T, up to a positive factor, for row vectors: the matrix of cofactors with the sign of
/// the determinant. It needs no inverse and keeps normals outward under mirroring.
osg::Vec3d transformNormal(const osg::Matrixd& m, const osg::Vec3d& n) {
    const osg::Vec3d r0(m(0, 0), m(0, 1), m(0, 2)), r1(m(1, 0), m(1, 1), m(1, 2)),
        r2(m(2, 0), m(2, 1), m(2, 2));
    const osg::Vec3d transformed = (r1 ^ r2) * n.x() + (r2 ^ r0) * n.y() + (r0 ^ r1) * n.z();
    return r0 * (r1 ^ r2) < 0.0 ? -transformed : transformed;
}

} // namespace

bool mirrors(const osg::Matrixd& m) {
    const osg::Vec3d r0(m(0, 0), m(0, 1), m(0, 2)), r1(m(1, 0), m(1, 1), m(1, 2)),
        r2(m(2, 0), m(2, 1), m(2, 2));
    return r0 * (r1 ^ r2) < 0.0;
}

GeometryCollector::GeometryCollector(SurfaceMesh& mesh, const Matrix4& toModel,
                                     const std::string& name, const ModelOptions& options)
    : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN),
      mesh_(mesh),
      matrix_(toOsg(toModel)),
      name_(name),
      forceTwoSided_(options.forceTwoSided),
      cuts_(options.cutsTextureAlpha) {
    setNodeMaskOverride(~0u);
}

void GeometryCollector::collect(osg::Node& graph) {
    RangeCollector ranges;
    graph.accept(ranges);
    ranges_ = ranges.ranges;
    total_ = polygonsOf(graph);
    graph.accept(*this);
}

template <typename Visit>
void GeometryCollector::within(osg::Node& node, Visit visit) {
    if (node.getNodeMask() == 0) {
        hidden_ += polygonsOf(node);
        return;
    }
    const auto before = state_;
    update(node.getStateSet());
    visit();
    state_ = before;
}

void GeometryCollector::update(const osg::StateSet* state) {
    if (!state)
        return;
    const auto mode = state->getMode(GL_CULL_FACE);
    if ((mode & osg::StateAttribute::INHERIT) == 0)
        state_.culling = (mode & osg::StateAttribute::ON) != 0;
    if (const auto* face = dynamic_cast<const osg::CullFace*>(
            state->getAttribute(osg::StateAttribute::CULLFACE))) {
        state_.front = face->getMode() == osg::CullFace::FRONT;
        state_.both = face->getMode() == osg::CullFace::FRONT_AND_BACK;
    }
    if (const auto* face = dynamic_cast<const osg::FrontFace*>(
            state->getAttribute(osg::StateAttribute::FRONTFACE)))
        state_.clockwise = face->getMode() == osg::FrontFace::CLOCKWISE;
    if (const auto* offset = dynamic_cast<const osg::PolygonOffset*>(
            state->getAttribute(osg::StateAttribute::POLYGONOFFSET)))
        state_.layer = std::clamp(static_cast<int>(std::lround(-offset->getFactor())), 0, 256);
    state_.texture.update(*state);
}

void GeometryCollector::apply(osg::Node& node) {
    within(node, [&] { traverse(node); });
}

void GeometryCollector::apply(osg::Group& group) {
    within(group, [&] {
        const auto coarser = coarserSiblings(group);
        const auto before = coarser_;
        coarser_.insert(coarser.begin(), coarser.end());
        traverse(group);
        coarser_ = before;
    });
}

void GeometryCollector::apply(osg::Transform& transform) {
    const auto before = matrix_;
    transform.computeLocalToWorldMatrix(matrix_, nullptr);
    apply(static_cast<osg::Group&>(transform));
    matrix_ = before;
}

void GeometryCollector::apply(osg::Camera& camera) {
    others_ += 1;
    hidden_ += polygonsOf(camera);
}

void GeometryCollector::apply(osg::LOD& lod) {
    within(lod, [&] {
        lods_.insert(&lod);
        if (coarser_.contains(&lod) || startsWhereAnotherEnds(lod)) {
            leftOut_.insert(&lod);
            leftOutPolygons_ += polygonsOf(lod);
            return;
        }
        const double best = finest(lod);
        for (unsigned int i = 0; i < lod.getNumChildren(); ++i) {
            auto& child = *lod.getChild(i);
            if (i < lod.getNumRanges() && start(lod, i) > best)
                leftOutPolygons_ += polygonsOf(child);
            else
                child.accept(*this);
        }
    });
}

std::set<const osg::LOD*> GeometryCollector::coarserSiblings(const osg::Group& group) const {
    // OpenFlight has one node a level; those that begin farther away stand in for the nearest.
    std::vector<const osg::LOD*> lods;
    for (unsigned int i = 0; i < group.getNumChildren(); ++i)
        if (const auto* lod = lodOf(group.getChild(i)); lod && inMetres(*lod))
            lods.push_back(lod);
    double least = HUGE_VAL;
    for (const auto* lod : lods)
        least = std::min(least, finest(*lod));
    std::set<const osg::LOD*> coarser;
    for (const auto* lod : lods)
        if (finest(*lod) > least)
            coarser.insert(lod);
    return coarser;
}

bool GeometryCollector::startsWhereAnotherEnds(const osg::LOD& lod) const {
    const double begin = finest(lod);
    return inMetres(lod) && begin > 0.0 &&
           std::any_of(ranges_.begin(), ranges_.end(), [&](const auto& range) {
               return range.first < begin && std::abs(range.second - begin) <= 0.01 * begin;
           });
}

void GeometryCollector::apply(osg::Sequence& sequence) {
    within(sequence, [&] {
        ++sequences_;
        if (sequence.getNumChildren() > 0)
            sequence.getChild(0)->accept(*this);
    });
}

void GeometryCollector::apply(osg::Billboard& billboard) {
    ++billboards_;
    within(billboard, [&] {
        const auto before = matrix_;
        for (unsigned int i = 0; i < billboard.getNumDrawables(); ++i) {
            matrix_ = osg::Matrixd::translate(billboard.getPosition(i)) * before;
            billboard.getDrawable(i)->accept(*this);
        }
        matrix_ = before;
    });
}

void GeometryCollector::apply(osg::Drawable& drawable) {
    within(drawable, [&] {
        const auto* geometry = drawable.asGeometry();
        if (!geometry) {
            ++others_;
            return;
        }
        if (state_.culling && state_.both) {
            nowhere_ += polygonsOf(drawable);
            return;
        }
        const std::vector<osg::Node*> path(getNodePath().begin(), getNodePath().end() - 1);
        const auto codes = codesOf(drawable, path);
        first_ = true;
        withoutArea_ += forEachPolygon(*geometry, name_, [&](std::vector<PolygonCorner>& corners) {
            addPolygon(drawable, path, codes, corners);
        });
        for (unsigned int i = 0; i < geometry->getNumPrimitiveSets(); ++i)
            if (geometry->getPrimitiveSet(i)->getMode() >= GL_TRIANGLES)
                drawn_ += geometry->getPrimitiveSet(i)->getNumPrimitives();
    });
}

void GeometryCollector::addPolygon(const osg::Drawable& drawable,
                                   const std::vector<osg::Node*>& path, const IrCodes& codes,
                                   std::vector<PolygonCorner>& corners) {
    for (auto& corner : corners) {
        corner.position = corner.position * matrix_;
        corner.normal = transformNormal(matrix_, corner.normal);
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(corner.position[axis]) <= 1e9))
                throw InputError({name_, "",
                                  "a transformation that leads to coordinate " +
                                      std::to_string(corner.position[axis]),
                                  "finite coordinates within 1e9 m"});
    }
    // The corners run counter-clockwise on the side that is the front.
    const bool turned = state_.clockwise != (state_.culling && state_.front);
    if (mirrors(matrix_) != turned)
        std::reverse(corners.begin(), corners.end());
    const Mesh::Kind kind{state_.layer, codes, state_.culling && !forceTwoSided_};
    if (each_)
        each_({kind, corners, drawable, path, turned, std::exchange(first_, false)});
    else if (const AlphaMask* covering = cuts_ ? mask() : nullptr) {
        ++cutPolygons_;
        cutAway_ += cutOut(*covering, corners, name_,
                           [&](std::vector<PolygonCorner>& part) { mesh_.add(kind, part); }) == 0;
    } else {
        mesh_.add(kind, corners);
    }
}

const AlphaMask* GeometryCollector::mask() {
    if (!state_.texture.isOn())
        return nullptr;
    const auto [known, isNew] = masks_.try_emplace(state_.texture);
    if (isNew) {
        known->second = AlphaMask::of(state_.texture);
        unreadable_ += state_.texture.isUnreadable();
    }
    return known->second.get();
}

std::vector<std::string> GeometryCollector::remarks() const {
    std::vector<std::string> remarks;
    const auto say = [&](long count, const std::string& text) {
        if (count > 0)
            remarks.push_back(std::to_string(count) + " " + text);
    };
    say(static_cast<long>(lods_.size()),
        "range LODs are overridden: the highest detail is drawn at every range, " +
            std::to_string(leftOutPolygons_) + " polygons of coarser levels are left out");
    say(hidden_, "hidden polygons stay hidden");
    say(total_ - drawn_ - hidden_ - leftOutPolygons_ - nowhere_, "polygons are switched off");
    say(nowhere_, "polygons are culled on both sides");
    say(cutPolygons_, "polygons are cut along the alpha of their texture, of which " +
                          std::to_string(cutAway_) + " vanish");
    say(unreadable_, "textures are compressed: their alpha is not read and cuts nothing");
    say(withoutArea_, "lines and points have no area and are left out");
    say(billboards_, "billboards do not turn towards the sensor");
    say(sequences_, "animations show their first frame");
    say(others_, "texts, cameras and other drawables without polygons are left out");
    say(mesh_.degenerate(), "polygons without area are left out");
    say(mesh_.folded(), "polygons cross themselves");
    say(mesh_.normalsMade(), "polygons get normals of their own in place of missing ones");
    say(mesh_.normalsTurned(), "polygons have normals that point away from their front: turned");
    return remarks;
}

} // namespace irsg
