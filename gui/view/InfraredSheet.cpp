#include "gui/view/InfraredSheet.h"

#include <osg/StateSet>

#include "gui/view/ViewBackground.h"

namespace smat::gui {

InfraredSheet::InfraredSheet() : image_(new osg::Image), texture_(new osg::Texture2D) {
    texture_->setResizeNonPowerOfTwoHint(false);
    texture_->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture_->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    const auto square = makeUnitSquare();
    const osg::Vec2 corners[] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    square->setTexCoordArray(0, new osg::Vec2Array(4, corners));
    const osg::Vec4 white(1, 1, 1, 1);
    square->setColorArray(new osg::Vec4Array(1, &white), osg::Array::BIND_OVERALL);
    square->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture_);
    camera_ = makeBackdrop(square);
    camera_->setDataVariance(osg::Object::DYNAMIC);
}

bool InfraredSheet::setPicture(const QImage& picture, bool smooth) {
    const bool isOtherSize = picture.size() != picture_.size();
    if (isOtherSize)
        texture_->dirtyTextureObject();
    const auto filter = smooth ? osg::Texture::LINEAR : osg::Texture::NEAREST;
    texture_->setFilter(osg::Texture::MIN_FILTER, filter);
    texture_->setFilter(osg::Texture::MAG_FILTER, filter);
    image_->setImage(picture.width(), picture.height(), 1, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE,
                     const_cast<uchar*>(picture.constBits()), osg::Image::NO_DELETE, 4);
    if (texture_->getImage() == nullptr)
        texture_->setImage(image_);
    picture_ = picture;
    return isOtherSize;
}

} // namespace smat::gui
