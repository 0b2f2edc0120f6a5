#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "irsg/geometry/conversion/TextureImage.h"
#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

struct LoadedGraph;

/// What a graph shows by its textures: a mesh about its own middle, m, with a part for each texture
/// of unit 0; vertices and places on the texture, no normals, colours, codes or culling.
struct TexturedMesh {
    struct Texture {
        TextureImage image;
        TextureWrap wrapS = TextureWrap::repeat, wrapT = TextureWrap::repeat;
    };

    std::shared_ptr<const Mesh> mesh;
    std::vector<int> textureOf; ///< by part: index into the textures, -1 for none
    std::vector<Texture> textures;
    Vec3 middle_m; ///< where the origin of the mesh lies, in the axes of the file
    std::vector<std::string> remarks;
};

/// Of a graph as an eye at no distance would see it (highest levels of detail, switches as they
/// stand). `folder`: where textures of the file lie; `name` is used in messages. Throws InputError
/// for a graph without faces, a texture that cannot be read and coordinates that are not finite.
TexturedMesh texturedMesh(const LoadedGraph& graph, const std::filesystem::path& folder,
                          const std::string& name);

} // namespace irsg
