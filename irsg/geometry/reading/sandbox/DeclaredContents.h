#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/reading/FileAxes.h"

namespace irsg {

/// What a file says of itself, read without the library that reads its geometry: what that gives is
/// held against it.
struct DeclaredContents {
    FileAxes axes;
    /// Polygons of three corners or more with every copy that is placed.
    std::optional<double> placedPolygons;
    /// Corners of polygons, each mesh once however often it is placed.
    std::optional<std::uint64_t> corners;
    std::vector<std::string> remarks; ///< what the file has and places nowhere
    /// The file in the form that the library reads, where that is narrower than the format: of
    /// .dae with no more blanks than lists and words need, of .x with materials in their places.
    std::optional<std::string> text;
};

/// Of .fbx, as text or binary. Throws InputError for records that are longer than what is left, a
/// list without its end, brackets that stay open and a version that is not read.
DeclaredContents readFbxFile(const std::filesystem::path& place, const std::filesystem::path& file);

/// Of .dae. Throws InputError for a text that is no whole XML, lists of polygons that are shorter
/// than they say, references to what is not there and nodes in a circle.
DeclaredContents readColladaFile(const std::filesystem::path& place,
                                 const std::filesystem::path& file);

/// Of .x, as text; nothing of a binary one. The text that it returns says the same in words that
/// Assimp reads rightly.
DeclaredContents readXFile(const std::filesystem::path& place, const std::filesystem::path& file);

} // namespace irsg
