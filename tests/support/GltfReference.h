#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include <osg/BoundingBox>

namespace irsg::test {

/// What a file of glTF 2.0 has in its scene, by a reader that shares nothing with the program's:
/// every placed triangle, in double.
struct GltfReference {
    double area = 0.0;
    std::size_t triangles = 0;
    osg::BoundingBoxd bounds;
    std::map<std::string, double> areaOfMaterials; ///< by name
};

/// Throws std::exception for what it does not understand.
GltfReference readGltfReference(const std::filesystem::path& file);

} // namespace irsg::test
