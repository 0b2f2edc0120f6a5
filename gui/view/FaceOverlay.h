#pragma once

#include <osg/Group>
#include <osg/ref_ptr>

#include "gui/view/DisplayScene.h"

namespace smat::gui {

/// How the faces of a scene are drawn over its picture.
struct OverlayLook {
    FaceSelection selection;
    /// The picture below is infrared: nothing has drawn the model's depths yet.
    bool overInfrared = false;
    /// Edges of all faces over an infrared picture; the visible display has its own.
    bool wireframe = false;
    double devicePixelRatio = 1.0;
    bool operator==(const OverlayLook&) const = default;
};

/// Fills the `marks` of the models of a scene anew.
void fillMarks(DisplayScene& scene, const OverlayLook& look);

} // namespace smat::gui
