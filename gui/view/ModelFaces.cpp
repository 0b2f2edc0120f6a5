#include "gui/view/ModelFaces.h"

#include <algorithm>

#include <osg/CullFace>
#include <osg/Geometry>
#include <osg/KdTree>
#include <osg/LightModel>
#include <osg/Material>
#include <osg/PolygonOffset>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include "gui/view/FaceMarks.h"
#include "irsg/geometry/conversion/OsgValues.h"

namespace smat::gui {

bool FaceSelection::holds(int ofModel, const irsg::IrCodes& codes) const {
    return !empty() && (!model || *model == ofModel) &&
           (!temperature || *temperature == codes.temperature) &&
           (!material || *material == codes.material);
}

namespace {

osg::ref_ptr<osg::Vec3Array> arrayOf(const std::vector<irsg::Float3>& values) {
    osg::ref_ptr<osg::Vec3Array> array = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    array->reserve(values.size());
    for (const irsg::Float3& value : values)
        array->push_back(irsg::toOsg(value));
    return array;
}

} // namespace

ModelFaces::ModelFaces(const irsg::Model& model) : geode_(new osg::Geode), bounds_(model.bounds()) {
    for (const irsg::Mesh::Part& part : model.mesh()->parts) {
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(arrayOf(part.vertices));
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, part.triangles.begin(), part.triangles.end()));
        geode_->addDrawable(geometry);
        surfaces_.push_back({part, arrayOf(part.normals)});
    }
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
        if (surface.kind.culled &&
            normal.x() * direction.x + normal.y() * direction.y + normal.z() * direction.z > 0.0)
            continue;
        const osg::Vec3d& p = found.localIntersectionPoint;
        hits.push_back({surface.kind.codes, {p.x(), p.y(), p.z()}, found.ratio * reach_m});
    }
    return hits;
}

osg::ref_ptr<osg::Group> ModelFaces::marked(int model, const FaceSelection& selection,
                                            double devicePixelRatio) const {
    std::vector<const osg::Geometry*> wanted;
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        if (selection.holds(model, surfaces_[i].kind.codes))
            wanted.push_back(geometry(i));
    return wanted.empty() ? nullptr : makeFaceMarks(wanted, devicePixelRatio);
}

osg::ref_ptr<osg::Group> ModelFaces::colored(const CodeColors& colors) const {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
        const osg::Geometry& face = *geometry(i);
        const QColor color = colors.of(surfaces_[i].kind.codes);
        const osg::Vec4 rgba(color.redF(), color.greenF(), color.blueF(), 1.0F);
        osg::ref_ptr<osg::Geometry> copy = new osg::Geometry;
        copy->setUseDisplayList(false);
        copy->setUseVertexBufferObjects(true);
        copy->setVertexArray(const_cast<osg::Array*>(face.getVertexArray()));
        copy->setNormalArray(surfaces_[i].normals);
        copy->setColorArray(new osg::Vec4Array(1, &rgba), osg::Array::BIND_OVERALL);
        for (unsigned int k = 0; k < face.getNumPrimitiveSets(); ++k)
            copy->addPrimitiveSet(const_cast<osg::PrimitiveSet*>(face.getPrimitiveSet(k)));
        auto* state = copy->getOrCreateStateSet();
        if (surfaces_[i].kind.culled)
            state->setAttributeAndModes(new osg::CullFace);
        // What lies over another face in its plane.
        if (const auto layer = static_cast<float>(surfaces_[i].kind.layer); layer > 0.0F)
            state->setAttributeAndModes(new osg::PolygonOffset(-layer, -layer));
        geode->addDrawable(copy);
    }
    auto* state = geode->getOrCreateStateSet();
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::AMBIENT_AND_DIFFUSE);
    state->setAttribute(material);
    state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    osg::ref_ptr<osg::LightModel> bothSides = new osg::LightModel;
    bothSides->setTwoSided(true);
    state->setAttribute(bothSides);
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(geode);
    return group;
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
