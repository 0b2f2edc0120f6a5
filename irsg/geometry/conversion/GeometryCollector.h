#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <osg/Matrixd>
#include <osg/NodeVisitor>

#include "irsg/geometry/conversion/SurfaceMesh.h"
#include "irsg/geometry/conversion/TextureCut.h"
#include "irsg/geometry/view/Matrix4.h"

namespace irsg {

/// Whether a transformation turns what runs counter-clockwise round.
bool mirrors(const osg::Matrixd& matrix);

/// A polygon that is drawn, with what stands over it.
struct DrawnPolygon {
    const Mesh::Kind& kind;
    std::vector<PolygonCorner>& corners; ///< in model axes, counter-clockwise from the front
    const osg::Drawable& drawable;
    const std::vector<osg::Node*>& path; ///< ends with the node above the drawable
    bool turned = false; ///< its state makes the other side the front than its corners do
    bool first = false;  ///< of the drawable at this place
};

/// Walks a loaded graph as a sensor at no distance would see it and adds every polygon to a mesh,
/// in model axes: transforms are multiplied out in double (a mirroring one turns the polygon
/// round), the highest level of detail is taken at every range, switches show their present
/// children, hidden nodes stay hidden.
class GeometryCollector : public osg::NodeVisitor {
  public:
    /// `toModel` leads from the axes of the file to those of the model. `name` is used in messages.
    /// Of `options` the placing is left alone.
    GeometryCollector(SurfaceMesh& mesh, const Matrix4& toModel, const std::string& name,
                      const ModelOptions& options);
    using Each = std::function<void(const DrawnPolygon&)>;
    /// Has the polygons go here, not into the mesh; whole, with what a texture cuts out of them.
    void giveTo(Each each) { each_ = std::move(each); }
    /// Throws InputError as forEachPolygon does.
    void collect(osg::Node& graph);
    /// What was overridden or left out, a sentence each.
    std::vector<std::string> remarks() const;

    void apply(osg::Node& node) override;
    void apply(osg::Group& group) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Camera& camera) override;
    void apply(osg::LOD& lod) override;
    void apply(osg::Sequence& sequence) override;
    void apply(osg::Billboard& billboard) override;
    void apply(osg::Drawable& drawable) override;

  private:
    struct State {
        bool culling = false, front = false, both = false, clockwise = false;
        int layer = 0; ///< subface level, from the polygon offset the plug-in gives it
        TextureState texture;
    };
    /// Hidden nodes are counted and left; otherwise the node's state counts while `visit` runs.
    template <typename Visit>
    void within(osg::Node& node, Visit visit);
    void update(const osg::StateSet* state);
    std::set<const osg::LOD*> coarserSiblings(const osg::Group& group) const;
    bool startsWhereAnotherEnds(const osg::LOD& lod) const;
    void addPolygon(const osg::Drawable& drawable, const std::vector<osg::Node*>& path,
                    const IrCodes& codes, std::vector<PolygonCorner>& corners);
    /// Of the texture that is on; null where it cuts nothing.
    const AlphaMask* mask();

    SurfaceMesh& mesh_;
    Each each_;
    osg::Matrixd matrix_;
    std::string name_;
    bool forceTwoSided_, cuts_;
    State state_;
    bool first_ = false; ///< no polygon of the drawable was given yet
    std::set<const osg::LOD*> coarser_;
    std::vector<std::pair<double, double>> ranges_; ///< of all LODs in the graph
    std::set<const osg::LOD*> lods_, leftOut_;
    long total_ = 0, drawn_ = 0, hidden_ = 0, leftOutPolygons_ = 0, nowhere_ = 0;
    std::map<TextureState, std::shared_ptr<const AlphaMask>> masks_; ///< null: nothing is cut
    long cutPolygons_ = 0, cutAway_ = 0, unreadable_ = 0;
    long withoutArea_ = 0, billboards_ = 0, sequences_ = 0, others_ = 0;
};

} // namespace irsg
