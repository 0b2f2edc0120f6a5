#pragma once

#include <QMetaObject>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

#include "gui/view/FaceOverlay.h"
#include "gui/view/InfraredSheet.h"
#include "gui/view/SceneView.h"
#include "gui/view/ViewHud.h"

namespace smat::gui {

/// What of a view belongs to OpenSceneGraph.
struct SceneView::Impl {
    osg::ref_ptr<osgViewer::Viewer> viewer;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window;
    QSize pixels; ///< of the window
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::Camera> background;
    osg::ref_ptr<osg::Camera> inset; ///< of the other camera's picture
    InfraredSheet sheet;
    DisplayScene scene;
    std::optional<OverlayLook> marked; ///< as the scene's marks are now
    std::optional<ViewHud> hud;        ///< as it is on the screen
    bool hasGlObjectsToDelete = false; ///< GL objects wait to be deleted
    QMetaObject::Connection contextGoes;

    void arrangeInset(bool visible);
};

} // namespace smat::gui
