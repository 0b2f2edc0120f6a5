#pragma once

#include <QImage>
#include <osg/Camera>
#include <osg/Image>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace smat::gui {

/// A picture that fills the view behind everything else.
class InfraredSheet {
  public:
    InfraredSheet();

    osg::Camera* node() const { return camera_; }
    /// Its first row is the top one. A picture of fewer pixels than the view is smoothed. True
    /// where the texture of the one before is of no use any more.
    bool setPicture(const QImage& picture, bool smooth);

  private:
    QImage picture_; ///< whose bits the texture is made of
    osg::ref_ptr<osg::Image> image_;
    osg::ref_ptr<osg::Texture2D> texture_;
    osg::ref_ptr<osg::Camera> camera_;
};

} // namespace smat::gui
