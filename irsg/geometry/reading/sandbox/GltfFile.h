#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <osg/Matrixd>
#include <osg/Vec3d>

namespace irsg {

/// What a file of glTF 2.0 (.gltf, .glb) says of itself, read without the library that reads its
/// geometry: what that gives is held against it.
struct GltfFile {
    /// Faces of one material in a mesh.
    struct Primitive {
        std::size_t vertices = 0, faces = 0; ///< faces: triangles, or lines, or points
        /// Of its positions, where stated.
        std::optional<osg::Vec3d> least, most;
        /// Texture coordinates are numbers that the library does not scale.
        bool scaledPlaces = false;
    };
    struct Mesh {
        std::string name;
        std::vector<Primitive> primitives;
    };
    struct Node {
        std::string name;
        osg::Matrixd transform; ///< for row vectors, in double as the text has it
        std::optional<std::size_t> mesh;
        std::vector<std::size_t> children;
    };
    std::vector<Mesh> meshes;
    std::vector<Node> nodes;
    std::vector<std::size_t> roots; ///< of the scene that is shown
    std::size_t materials = 0;
    std::vector<std::string> remarks; ///< what is in the file and makes no difference here
};

/// Reads the JSON with the lengths of chunks and buffers, whose bytes are at `place`. Throws
/// InputError, with the key path, for another version, a buffer that is missing, not opened
/// (OpenableFiles.h) or shorter than it says, accessors beyond their buffer, references to what is
/// not there, nodes in a circle or with two parents, and what only an extension could read.
GltfFile readGltfFile(const std::filesystem::path& place, const std::filesystem::path& file);

/// A reference in a .gltf, with its %20 as blanks.
std::string decodedUri(const std::string& uri);

} // namespace irsg
