#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include <osg/Texture>
#include <osg/Vec2>
#include <osg/Vec3>

namespace smat {

/// A corner of a ground: where it is, m, and its place in the picture.
struct GroundCorner {
    osg::Vec3 place_m;
    osg::Vec2 inPicture;
};

/// Squares of two triangles each, `cells` a side, with a picture that lies beside the file.
struct GroundSheet {
    std::string picture;
    osg::Texture::WrapMode wrap = osg::Texture::CLAMP_TO_EDGE;
    int cells = 1;
    /// That in column i and row j, from 0 to `cells`.
    std::function<GroundCorner(int i, int j)> corner;
    /// Whether the square between this corner and the next is there; without one, all are.
    std::function<bool(int i, int j)> isThere = {};
};

/// Writes a ground as .osgb. Throws InputError where the file cannot be written.
void writeTexturedGround(const std::filesystem::path& file, std::span<const GroundSheet> sheets);

} // namespace smat
