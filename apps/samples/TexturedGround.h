#pragma once

#include <filesystem>
#include <functional>
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

/// Writes a ground of `cells` x `cells` squares, each of two triangles, with a picture that lies
/// beside the file, as .osgb. `corner` gives that in column i and row j, from 0 to `cells`. Throws
/// InputError where the file cannot be written.
void writeTexturedGround(const std::filesystem::path& file, const std::string& picture,
                         osg::Texture::WrapMode wrap, int cells,
                         const std::function<GroundCorner(int i, int j)>& corner);

} // namespace smat
