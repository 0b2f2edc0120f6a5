#pragma once

#include <string>
#include <vector>

#include <osg/Geometry>
#include <osg/Texture2D>
#include <osg/ref_ptr>

#include "irsg/render/background/Terrain.h"
#include "irsg/render/background/TextureImage.h"

namespace irsg {

/// What of a terrain is drawn.
struct Terrain::Impl {
    struct Texture {
        TextureImage image;
        osg::Texture::WrapMode wrapS = osg::Texture::REPEAT, wrapT = osg::Texture::REPEAT;
    };
    /// Triangles that share a texture: vertices about the middle of the model, m, texture
    /// coordinates of unit 0.
    struct Piece {
        osg::ref_ptr<osg::Geometry> geometry;
        int texture = -1; ///< index, -1 for none
    };

    std::string name;
    Pose pose;
    BoundingBox bounds{{1, 1, 1}, {-1, -1, -1}};
    std::vector<std::string> remarks;
    std::vector<Texture> textures;
    std::vector<Piece> pieces;
};

} // namespace irsg
