#include "gui/view/FaceOverlay.h"

#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/PolygonOffset>

#include "gui/view/FaceMarks.h"

namespace smat::gui {
namespace {

/// The depths of all faces and nothing else, so that marks are hidden as the picture shows it.
osg::ref_ptr<osg::Group> depthsOf(const ModelFaces& faces) {
    osg::ref_ptr<osg::Group> depths = new osg::Group;
    depths->addChild(faces.geode());
    auto* state = depths->getOrCreateStateSet();
    state->setAttribute(new osg::ColorMask(false, false, false, false));
    state->setAttribute(new osg::PolygonMode, osg::StateAttribute::PROTECTED);
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setRenderBinDetails(-10, "RenderBin");
    return depths;
}

} // namespace

void fillMarks(DisplayScene& scene, const OverlayLook& look) {
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        DisplayModel& model = scene.models[i];
        model.marks->removeChildren(0, model.marks->getNumChildren());
        if (!model.faces)
            continue;
        const bool isChosen = look.chosen.geometry && look.chosen.model == static_cast<int>(i);
        if (look.codes && !look.overInfrared)
            model.marks->addChild(model.faces->colored(*look.codes));
        if (look.overInfrared && (!look.selection.empty() || isChosen))
            model.marks->addChild(depthsOf(*model.faces));
        if (look.overInfrared && look.wireframe)
            model.marks->addChild(model.faces->wireframe(look.devicePixelRatio));
        if (const auto marked =
                model.faces->marked(static_cast<int>(i), look.selection, look.devicePixelRatio))
            model.marks->addChild(marked);
        if (isChosen)
            model.marks->addChild(
                makeFaceMarks({look.chosen.geometry.get()}, look.devicePixelRatio));
    }
}

} // namespace smat::gui
