#include "gui/view/ModelFaces.h"

#include <algorithm>

#include <osg/Geometry>
#include <osg/KdTree>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "gui/view/FaceMarks.h"
#include "irsg/scene/model/IrCodes.h"

namespace smat::gui {

bool FaceSelection::holds(int ofModel, const irsg::IrCodes& codes) const {
    return !empty() && (!model || *model == ofModel) &&
           (!temperature || *temperature == codes.temperature) &&
           (!material || *material == codes.material);
}

ModelFaces::ModelFaces(const irsg::Model& model) : geode_(new osg::Geode), bounds_(model.bounds()) {
    class Copier : public osg::NodeVisitor {
      public:
        explicit Copier(ModelFaces& faces)
            : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), faces_(faces) {}
        void apply(osg::Geometry& geometry) override {
            const auto* state = geometry.getStateSet();
            const bool culled =
                state != nullptr && (state->getMode(GL_CULL_FACE) & osg::StateAttribute::ON) != 0;
            osg::ref_ptr<osg::Geometry> copy = new osg::Geometry;
            copy->setUseDisplayList(false);
            copy->setUseVertexBufferObjects(true);
            copy->setVertexArray(osg::clone(geometry.getVertexArray(), osg::CopyOp::DEEP_COPY_ALL));
            for (unsigned int i = 0; i < geometry.getNumPrimitiveSets(); ++i)
                copy->addPrimitiveSet(
                    osg::clone(geometry.getPrimitiveSet(i), osg::CopyOp::DEEP_COPY_ALL));
            faces_.geode_->addDrawable(copy);
            faces_.surfaces_.push_back({irsg::codesOf(geometry, {}), culled});
        }

      private:
        ModelFaces& faces_;
    };
    Copier copier(*this);
    model.graph()->accept(copier);
    osg::ref_ptr<osg::KdTreeBuilder> trees = new osg::KdTreeBuilder;
    geode_->accept(*trees);
}

std::vector<ModelFaces::Hit> ModelFaces::along(const irsg::Vec3& eye,
                                               const irsg::Vec3& direction) const {
    // From the eye to behind the farthest corner of the box.
    const double reach_m = irsg::length(bounds_.centre() - eye) + bounds_.diagonal_m() + 1e-3;
    const irsg::Vec3 end = eye + direction * reach_m;
    osg::ref_ptr<osgUtil::LineSegmentIntersector> line = new osgUtil::LineSegmentIntersector(
        osg::Vec3d(eye.x, eye.y, eye.z), osg::Vec3d(end.x, end.y, end.z));
    line->setPrecisionHint(osgUtil::Intersector::USE_DOUBLE_CALCULATIONS);
    osgUtil::IntersectionVisitor visitor(line);
    geode_->accept(visitor);

    std::vector<Hit> hits;
    for (const auto& found : line->getIntersections()) {
        const Surface& surface = surfaces_.at(geode_->getDrawableIndex(found.drawable));
        const osg::Vec3d normal = found.localIntersectionNormal;
        if (surface.culled &&
            normal.x() * direction.x + normal.y() * direction.y + normal.z() * direction.z > 0.0)
            continue;
        const osg::Vec3d& p = found.localIntersectionPoint;
        hits.push_back({surface.codes, {p.x(), p.y(), p.z()}, found.ratio * reach_m});
    }
    return hits;
}

osg::ref_ptr<osg::Group> ModelFaces::marked(int model, const FaceSelection& selection,
                                            double devicePixelRatio) const {
    std::vector<const osg::Geometry*> wanted;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        if (selection.holds(model, surfaces_[i].codes))
            wanted.push_back(geometry(i));
    return wanted.empty() ? nullptr : makeFaceMarks(wanted, devicePixelRatio);
}

osg::ref_ptr<osg::Group> ModelFaces::wireframe(double devicePixelRatio) const {
    std::vector<const osg::Geometry*> all;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        all.push_back(geometry(i));
    return makeWireframe(all, osg::Vec4(0.55F, 0.6F, 0.68F, 0.45F), devicePixelRatio);
}

const osg::Geometry* ModelFaces::geometry(std::size_t surface) const {
    return geode_->getDrawable(static_cast<unsigned int>(surface))->asGeometry();
}

} // namespace smat::gui
