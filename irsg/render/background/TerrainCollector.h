#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <osg/Matrixd>
#include <osg/NodeVisitor>

#include "irsg/render/background/TerrainImpl.h"

namespace irsg {

/// Walks the graph of a terrain as an eye at no distance would see it (highest levels of detail,
/// switches as they stand) and gathers its triangles by texture.
class TerrainCollector : public osg::NodeVisitor {
  public:
    /// `folder`: where textures of the file lie; `name` is used in messages.
    TerrainCollector(const std::filesystem::path& folder, const std::string& name);
    /// Fills in everything but the name and the remarks of the loader. Throws InputError.
    void collect(osg::Node& graph, const Vec3& position_m, Terrain::Impl& parts);

    void apply(osg::Node& node) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Drawable& drawable) override;

  private:
    struct Batch {
        std::vector<osg::Vec3d> vertices; ///< axes of the file, m
        std::vector<osg::Vec2> places;    ///< texture coordinates
        std::vector<unsigned int> triangles;
    };
    const osg::Texture* textureOf(const osg::StateSet* state) const;
    void addTriangles(osg::Geometry& geometry, Batch& batch);
    TextureImage read(const osg::Texture& texture) const;

    std::filesystem::path folder_;
    std::string name_;
    osg::Matrixd matrix_;
    const osg::Texture* texture_ = nullptr;
    std::map<const osg::Texture*, Batch> batches_; ///< null: without a texture
    std::vector<const osg::Texture*> order_;       ///< as they are met
};

} // namespace irsg
