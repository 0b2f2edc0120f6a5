#pragma once

#include <functional>

#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Image>
#include <osg/Texture2D>

#include "irsg/geometry/view/Vec3.h"

namespace irsg::test {

/// A square of linear grey values, the first at the lower left.
inline osg::ref_ptr<osg::Texture2D> textureOf(int side,
                                              const std::function<float(int, int)>& texel) {
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(side, side, 1, GL_LUMINANCE, GL_FLOAT);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            *reinterpret_cast<float*>(image->data(static_cast<unsigned int>(x),
                                                  static_cast<unsigned int>(y))) = texel(x, y);
        }
    }
    return new osg::Texture2D(image);
}

/// A rectangle with texture coordinates 0 to 1 from its first corner; null for no texture.
inline osg::ref_ptr<osg::Geode> sheet(const Vec3& corner, const Vec3& along, const Vec3& up,
                                      const osg::ref_ptr<osg::Texture2D>& texture) {
    const auto place = [](const Vec3& v) {
        return osg::Vec3(static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
    };
    const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    const osg::Vec3 vertices[] = {place(corner), place(corner + along), place(corner + along + up),
                                  place(corner + up)};
    const osg::Vec2 places[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    geometry->setVertexArray(new osg::Vec3Array(4, vertices));
    geometry->setTexCoordArray(0, new osg::Vec2Array(4, places));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 4));
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(geometry);
    if (texture) {
        geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    }
    return geode;
}

} // namespace irsg::test
