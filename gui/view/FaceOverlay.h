#pragma once

#include <memory>

#include <osg/Geometry>
#include <osg/Group>
#include <osg/ref_ptr>

#include "gui/view/DisplayScene.h"

namespace smat::gui {

/// Faces of a model of the project by themselves; none without a geometry.
struct ChosenFaces {
    int model = 0;
    osg::ref_ptr<osg::Geometry> geometry;
    bool operator==(const ChosenFaces&) const = default;
};

/// How the faces of a scene are drawn over its picture.
struct OverlayLook {
    FaceSelection selection;
    /// Single faces of a model, in model axes, marked as those are.
    ChosenFaces chosen;
    /// The visible display shows codes in place of the file's colours; null for these.
    std::shared_ptr<const CodeColors> codes;
    /// Counts what the faces were.
    long revision = 0;
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
