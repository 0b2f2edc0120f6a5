#include "irsg/geometry/conversion/CodeSafeMerge.h"

#include <map>
#include <set>
#include <vector>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/Uniform>
#include <osgUtil/Optimizer>

#include "irsg/geometry/reading/IrCodes.h"
#include "irsg/geometry/reading/Triangulation.h"

namespace irsg {
namespace {

constexpr const char* uniformName = "irsgCodes";

bool fits(const osg::Array* array, unsigned int vertices) {
    return !array || array->getBinding() != osg::Array::BIND_PER_VERTEX ||
           array->getNumElements() == vertices;
}

/// Removes arrays of another length than the vertices: they would be read beyond their end.
bool removeMisfits(osg::Geometry& geometry) {
    const auto vertices =
        geometry.getVertexArray() ? geometry.getVertexArray()->getNumElements() : 0;
    bool removed = false;
    if (!fits(geometry.getNormalArray(), vertices))
        geometry.setNormalArray(nullptr), removed = true;
    if (!fits(geometry.getColorArray(), vertices))
        geometry.setColorArray(nullptr), removed = true;
    for (unsigned int unit = 0; unit < geometry.getNumTexCoordArrays(); ++unit) {
        const auto* array = geometry.getTexCoordArray(unit);
        if (array && array->getNumElements() != vertices)
            geometry.setTexCoordArray(unit, nullptr), removed = true;
    }
    return removed;
}

/// Numbers of vertices of each polygon of a set of quads or polygons.
std::vector<std::vector<unsigned int>> polygonsOf(const osg::PrimitiveSet& set) {
    std::vector<unsigned int> lengths;
    if (const auto* several = dynamic_cast<const osg::DrawArrayLengths*>(&set))
        lengths.assign(several->begin(), several->end());
    else if (set.getMode() == GL_QUADS)
        lengths.assign(set.getNumIndices() / 4, 4);
    else
        lengths.push_back(set.getNumIndices());
    std::vector<std::vector<unsigned int>> polygons;
    unsigned int at = 0;
    for (const unsigned int length : lengths) {
        polygons.emplace_back();
        for (unsigned int i = 0; i < length; ++i)
            polygons.back().push_back(set.index(at++));
    }
    return polygons;
}

/// Cuts quads and polygons that are not convex into triangles: a viewer would draw them wrongly.
/// The others stay whole, so that a face stays a face.
void cutConcave(osg::Geometry& geometry) {
    const auto* places = dynamic_cast<const osg::Vec3Array*>(geometry.getVertexArray());
    if (!places)
        return;
    osg::Geometry::PrimitiveSetList sets;
    std::vector<PolygonCorner> corners;
    for (const auto& set : geometry.getPrimitiveSetList()) {
        if (set->getMode() != GL_QUADS && set->getMode() != GL_POLYGON) {
            sets.push_back(set);
            continue;
        }
        osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
        osg::Geometry::PrimitiveSetList whole;
        for (const auto& polygon : polygonsOf(*set)) {
            corners.clear();
            for (const auto vertex : polygon)
                corners.emplace_back().position =
                    vertex < places->size() ? osg::Vec3d((*places)[vertex]) : osg::Vec3d();
            if (const auto cut = triangulate(corners); cut.convex || cut.folded)
                whole.push_back(
                    new osg::DrawElementsUInt(set->getMode(), polygon.begin(), polygon.end()));
            else
                for (const auto& triangle : cut.triangles)
                    for (const auto corner : triangle)
                        triangles->push_back(polygon[corner]);
        }
        if (triangles->empty()) {
            sets.push_back(set);
            continue;
        }
        sets.insert(sets.end(), whole.begin(), whole.end());
        sets.push_back(triangles);
    }
    geometry.setPrimitiveSetList(sets);
}

/// Visits each drawable once, hidden ones and unused levels of detail too.
class DrawableVisitor : public osg::NodeVisitor {
  public:
    DrawableVisitor() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) { setNodeMaskOverride(~0u); }
    void apply(osg::Drawable& drawable) final {
        if (seen_.insert(&drawable).second)
            once(drawable);
    }
    int count() const { return static_cast<int>(seen_.size()); }

  protected:
    virtual void once(osg::Drawable& drawable) = 0;

  private:
    std::set<const osg::Drawable*> seen_;
};

class Tagger : public DrawableVisitor {
  public:
    explicit Tagger(bool merge) : merge_(merge) {}
    int misfits = 0;
    std::set<osg::Geode*> geodes;

  protected:
    void once(osg::Drawable& drawable) override {
        const auto& path = getNodePath();
        const auto codes = codesOf(drawable, {path.begin(), path.end() - 1});
        if (auto* geometry = drawable.asGeometry())
            misfits += removeMisfits(*geometry);
        if (!merge_)
            return setCodes(drawable, codes);

        if (auto* geometry = drawable.asGeometry())
            cutConcave(*geometry);
        auto& uniform = uniforms_[codes];
        if (!uniform)
            uniform = new osg::Uniform(uniformName, codes.temperature, codes.material);
        osg::ref_ptr<osg::StateSet> state =
            drawable.getStateSet() ? osg::clone(drawable.getStateSet()) : new osg::StateSet;
        state->addUniform(uniform);
        drawable.setStateSet(state);
        drawable.setUserDataContainer(nullptr);
        if (path.size() > 1)
            if (auto* geode = path[path.size() - 2]->asGeode())
                geodes.insert(geode);
    }

  private:
    bool merge_;
    std::map<IrCodes, osg::ref_ptr<osg::Uniform>> uniforms_;
};

class Untagger : public DrawableVisitor {
  protected:
    void once(osg::Drawable& drawable) override {
        IrCodes codes;
        if (auto* state = drawable.getStateSet()) {
            if (const auto* uniform = state->getUniform(uniformName))
                uniform->get(codes.temperature, codes.material);
            tagged_.insert(state);
            if (state->getUniformList().size() == 1 && state->getModeList().empty() &&
                state->getAttributeList().empty() && state->getTextureAttributeList().empty())
                drawable.setStateSet(nullptr);
        }
        setCodes(drawable, codes);
    }

  public:
    /// State sets are shared, so the uniform goes when every drawable has been read.
    void removeUniforms() {
        for (const auto& state : tagged_)
            state->removeUniform(uniformName);
    }

  private:
    std::set<osg::ref_ptr<osg::StateSet>> tagged_;
};

} // namespace

MergeCounts mergeKeepingCodes(osg::Group& graph, bool merge, int& misfits) {
    Tagger tagger(merge);
    graph.accept(tagger);
    misfits += tagger.misfits;
    MergeCounts counts{tagger.count(), tagger.count()};
    if (!merge)
        return counts;

    // The codes of a mesh are on its geode, which the optimizer must see without them.
    for (auto* geode : tagger.geodes)
        geode->setUserDataContainer(nullptr);
    osgUtil::Optimizer optimizer;
    optimizer.optimize(&graph, osgUtil::Optimizer::STATIC_OBJECT_DETECTION |
                                   osgUtil::Optimizer::SHARE_DUPLICATE_STATE |
                                   osgUtil::Optimizer::MERGE_GEODES |
                                   osgUtil::Optimizer::MERGE_GEOMETRY);

    Untagger untagger;
    graph.accept(untagger);
    untagger.removeUniforms();
    counts.after = untagger.count();
    return counts;
}

} // namespace irsg
