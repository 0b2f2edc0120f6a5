#pragma once

#include <memory>
#include <optional>

#include <QImage>
#include <QRectF>
#include <QSize>
#include <QSurfaceFormat>
#include <osg/Camera>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

#include "gui/view/DisplayScene.h"
#include "gui/view/FaceOverlay.h"
#include "gui/view/InfraredSheet.h"
#include "irsg/geometry/view/Pose.h"

class QOpenGLContext;

namespace smat::gui {

/// Where a camera of the drawing stands, and how much of the scene it sees.
struct RenderingAim {
    irsg::Viewpoint from;
    double horizontalFieldOfView_rad = 0.035;
    double aspect = 1.0; ///< width to height
};

/// What OpenSceneGraph draws in a view: the models or the infrared picture, marks over their faces
/// and the other camera's picture in a corner. The context of the view is to be current where it
/// begins, draws and lets go.
class SceneDrawing {
  public:
    SceneDrawing();

    /// Of the widget that it draws in.
    static QSurfaceFormat surfaceFormat();
    /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 …", of a context that is current.
    static QString rendererOf(QOpenGLContext& context);

    /// Starts anew in the context that is current.
    void begin(const QSize& pixels, bool dark);
    /// Lets go of what it has in the context that it began in.
    void end(const DisplayScene& scene);
    /// Lets go of a scene that makes way for another one.
    void forget(const DisplayScene& scene);
    void setBackground(bool dark);
    void setWireframe(bool on);
    void setPicture(const InfraredPicture& picture);
    /// Puts together what is drawn of a scene: over an infrared picture its marks alone.
    void arrange(DisplayScene& scene, const OverlayLook& look, bool hasInset);
    /// Whether the size is another one.
    bool resize(const QSize& pixels);
    void draw(unsigned framebuffer, const RenderingAim& aim);
    /// The picture in the corner, in pixels of the window from its bottom left corner.
    void aimInset(const RenderingAim& aim, const QRectF& pixels);

  private:
    void arrangeInset(const DisplayScene& scene);

    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<osgViewer::GraphicsWindowEmbedded> window_;
    QSize pixels_; ///< of the window
    osg::ref_ptr<osg::Group> root_ = new osg::Group;
    osg::ref_ptr<osg::Camera> background_; ///< null before the first beginning
    osg::ref_ptr<osg::Camera> inset_;      ///< of the other camera's picture
    InfraredSheet sheet_;
    std::optional<OverlayLook> marked_; ///< as the scene's marks are now
    bool hasGlObjectsToDelete_ = false; ///< GL objects wait to be deleted
};

} // namespace smat::gui
