#pragma once

#include <filesystem>
#include <functional>

#include <osg/Image>

#include "irsg/geometry/reading/LoadedGraph.h"

namespace irsg {

/// Reads a picture that a material names; throws InputError where that fails.
using PictureReading = std::function<osg::ref_ptr<osg::Image>(const std::filesystem::path&)>;

/// Reads a Wavefront object with its material libraries, in time proportional to its size: y is up
/// in the file and z in what is returned. Faces without normals get their own; faces of more than
/// four corners are cut into triangles. Lines, points and free forms are left out and told, as are
/// words that the format does not have. Pictures are read by `picture`, where there is one. Throws
/// InputError for numbers that are none, faces of vertices that there are not, and a line that ends
/// within a face, each with its line.
LoadedGraph readObj(const std::filesystem::path& file, const PictureReading& picture);

/// The files that a Wavefront object names and that are there.
struct ObjFiles {
    std::vector<std::filesystem::path> libraries, pictures;
};
/// Found by the lines that name libraries of materials, and by those libraries. Throws nothing: of
/// what cannot be read readObj() speaks.
ObjFiles filesOfObj(const std::filesystem::path& file);

} // namespace irsg
