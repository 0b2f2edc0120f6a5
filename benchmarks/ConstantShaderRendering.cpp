#include "benchmarks/ConstantShaderRendering.h"

#include <cmath>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/GraphicsContext>
#include <osg/Program>
#include <osg/State>
#include <osgUtil/SceneView>

#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/view/CameraFrame.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/opengl/FloatTarget.h"
#include "irsg/render/opengl/OffscreenContext.h"

namespace irsg::bench {

namespace {

osg::ref_ptr<osg::Geode> geodeOf(const Mesh& mesh) {
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    for (const Mesh::Part& part : mesh.parts) {
        osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
        for (const Float3& vertex : part.vertices)
            vertices->push_back(toOsg(vertex));
        osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setVertexArray(vertices);
        geometry->addPrimitiveSet(
            new osg::DrawElementsUInt(GL_TRIANGLES, part.triangles.begin(), part.triangles.end()));
        geometry->getOrCreateStateSet()->setMode(
            GL_CULL_FACE, part.culled ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
        geode->addDrawable(geometry);
    }
    return geode;
}

} // namespace

struct ConstantShaderRendering::Impl {
    OffscreenContext& context = OffscreenContext::shared();
    std::shared_ptr<const Model> model;
    Sensor sensor;
    osg::ref_ptr<osg::State> state; // OpenSceneGraph's own, of the same context
    osg::ref_ptr<osgUtil::SceneView> view;
    std::unique_ptr<FloatTarget> target;
    std::vector<float> samples;
};

ConstantShaderRendering::ConstantShaderRendering(std::shared_ptr<const Model> model,
                                                 const Sensor& sensor, const Viewpoint& viewpoint)
    : impl_(std::make_unique<Impl>()) {
    Impl& p = *impl_;
    p.model = std::move(model);
    p.sensor = sensor;
    p.context.run([&] {
        p.state = new osg::State;
        p.state->setContextID(osg::GraphicsContext::createNewContextID());
        p.state->initializeExtensionProcs();
        p.target = std::make_unique<FloatTarget>(std::vector<int>{4});
        p.target->reserve(sensor.width_px, sensor.height_px);

        osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(
            osg::Shader::VERTEX,
            "#version 330 compatibility\n"
            "void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }"));
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                           "#version 330 compatibility\n"
                                           "layout(location = 0) out vec4 colour;\n"
                                           "void main() { colour = vec4(1.0); }"));

        const CameraFrame camera(sensor, viewpoint);
        const Pose origin;
        p.view = new osgUtil::SceneView;
        p.view->setDefaults();
        p.view->setState(p.state);
        p.view->setSceneData(geodeOf(*p.model->mesh()));
        p.view->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        p.view->setViewport(0, 0, sensor.width_px, sensor.height_px);
        p.view->setViewMatrix(toOsg(camera.eyeFromModel(origin)));
        const DepthRange depth = *camera.depthOf(p.model->bounds(), origin);
        p.view->setProjectionMatrixAsPerspective(
            degrees(2.0 * std::atan(0.5 * sensor.height_px * sensor.pixelPitch())),
            static_cast<double>(sensor.width_px) / sensor.height_px, depth.near_m, depth.far_m);
        p.view->setClearColor(osg::Vec4(0, 0, 0, 0));
        p.view->setDrawBufferValue(GL_COLOR_ATTACHMENT0);
        p.view->getGlobalStateSet()->setAttributeAndModes(
            program, osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE);
        p.view->init();
    });
}

ConstantShaderRendering::~ConstantShaderRendering() {
    impl_->context.run([&] {
        impl_->view = nullptr;
        impl_->target = nullptr;
        impl_->state = nullptr;
    });
}

int ConstantShaderRendering::draw() {
    Impl& p = *impl_;
    p.context.run([&] {
        p.target->bind(p.sensor.width_px, p.sensor.height_px);
        p.view->cull();
        p.view->draw();
        p.target->read(0, p.sensor.width_px, p.sensor.height_px, p.samples);
    });
    int covered = 0;
    for (std::size_t i = 0; i < p.samples.size(); i += 4)
        covered += p.samples[i] > 0.0f;
    return covered;
}

} // namespace irsg::bench
