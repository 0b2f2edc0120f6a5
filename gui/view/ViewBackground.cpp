#include "gui/view/ViewBackground.h"

#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/PolygonMode>

namespace smat::gui {

osg::ref_ptr<osg::Geometry> makeUnitSquare() {
    osg::ref_ptr<osg::Geometry> square = new osg::Geometry;
    square->setUseDisplayList(false);
    square->setUseVertexBufferObjects(true);
    const osg::Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    square->setVertexArray(new osg::Vec3Array(4, corners));
    square->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    return square;
}

osg::ref_ptr<osg::Camera> makeBackdrop(osg::Geometry* unitSquare) {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(unitSquare);

    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setProjectionMatrixAsOrtho2D(0, 1, 0, 1);
    camera->setViewMatrix(osg::Matrix::identity());
    camera->setClearMask(0);
    camera->setRenderOrder(osg::Camera::NESTED_RENDER);
    camera->setCullingActive(false);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->addChild(geode);
    auto* state = camera->getOrCreateStateSet();
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF | osg::StateAttribute::PROTECTED);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0, 1, false));
    state->setAttribute(new osg::PolygonMode, osg::StateAttribute::PROTECTED);
    state->setRenderBinDetails(-100, "RenderBin");
    return camera;
}

osg::ref_ptr<osg::Camera> makeViewBackground(bool dark) {
    const osg::Vec4 above =
        dark ? osg::Vec4(0.20F, 0.23F, 0.28F, 1) : osg::Vec4(0.80F, 0.86F, 0.93F, 1);
    const osg::Vec4 below =
        dark ? osg::Vec4(0.11F, 0.12F, 0.15F, 1) : osg::Vec4(0.97F, 0.98F, 0.99F, 1);
    const osg::Vec4 colors[] = {below, below, above, above};
    const auto sheet = makeUnitSquare();
    sheet->setColorArray(new osg::Vec4Array(4, colors), osg::Array::BIND_PER_VERTEX);
    return makeBackdrop(sheet);
}

} // namespace smat::gui
