#include "irsg/geometry/conversion/TexturedMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <osg/Geometry>
#include <osg/NodeVisitor>
#include <osg/Texture2D>
#include <osg/Transform>
#include <osg/TriangleIndexFunctor>

#include "irsg/core/Errors.h"
#include "irsg/geometry/conversion/OsgTexture.h"
#include "irsg/geometry/reading/LoadedGraph.h"
#include "irsg/geometry/reading/OpenableFiles.h"

namespace irsg {

namespace {

struct IndexList {
    std::vector<unsigned int>* into = nullptr;
    void operator()(unsigned int a, unsigned int b, unsigned int c) {
        into->insert(into->end(), {a, b, c});
    }
};

std::vector<osg::Vec3d> positionsOf(const osg::Array* array) {
    std::vector<osg::Vec3d> result;
    if (const auto* floats = dynamic_cast<const osg::Vec3Array*>(array))
        for (const osg::Vec3& v : *floats)
            result.emplace_back(v);
    else if (const auto* doubles = dynamic_cast<const osg::Vec3dArray*>(array))
        result.assign(doubles->begin(), doubles->end());
    return result;
}

std::vector<osg::Vec2> placesOf(const osg::Array* array) {
    std::vector<osg::Vec2> result;
    if (const auto* flat = dynamic_cast<const osg::Vec2Array*>(array))
        result.assign(flat->begin(), flat->end());
    else if (const auto* fine = dynamic_cast<const osg::Vec2dArray*>(array))
        for (const osg::Vec2d& v : *fine)
            result.emplace_back(v);
    else if (const auto* deep = dynamic_cast<const osg::Vec3Array*>(array))
        for (const osg::Vec3& v : *deep)
            result.emplace_back(v.x(), v.y());
    return result;
}

TextureWrap wrapOf(const osg::Texture& texture, osg::Texture::WrapParameter axis) {
    const osg::Texture::WrapMode mode = texture.getWrap(axis);
    return mode == osg::Texture::REPEAT   ? TextureWrap::repeat
           : mode == osg::Texture::MIRROR ? TextureWrap::mirror
                                          : TextureWrap::edge;
}

void include(BoundingBox& box, const osg::Vec3d& v) {
    box.min = {std::min(box.min.x, v.x()), std::min(box.min.y, v.y()), std::min(box.min.z, v.z())};
    box.max = {std::max(box.max.x, v.x()), std::max(box.max.y, v.y()), std::max(box.max.z, v.z())};
}

/// Gathers triangles by texture.
class Collector : public osg::NodeVisitor {
  public:
    struct Batch {
        std::vector<osg::Vec3d> vertices; ///< axes of the file, m
        std::vector<osg::Vec2> places;    ///< texture coordinates
        std::vector<unsigned int> triangles;
    };

    explicit Collector(const std::string& name)
        : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN), name_(name) {}

    void apply(osg::Node& node) override;
    void apply(osg::Transform& transform) override;
    void apply(osg::Drawable& drawable) override;

    std::map<const osg::Texture*, Batch> batches; ///< null: without a texture
    std::vector<const osg::Texture*> order;       ///< as they are met

  private:
    const osg::Texture* textureOf(const osg::StateSet* state) const;
    void addTriangles(osg::Geometry& geometry, Batch& batch);

    const std::string& name_;
    osg::Matrixd matrix_;
    const osg::Texture* texture_ = nullptr;
};

const osg::Texture* Collector::textureOf(const osg::StateSet* state) const {
    if (!state)
        return texture_;
    const auto* own = dynamic_cast<const osg::Texture*>(
        state->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    return own && own->getImage(0) ? own : texture_;
}

void Collector::apply(osg::Node& node) {
    const osg::Texture* outer = std::exchange(texture_, textureOf(node.getStateSet()));
    traverse(node);
    texture_ = outer;
}

void Collector::apply(osg::Transform& transform) {
    const osg::Matrixd outer = matrix_;
    transform.computeLocalToWorldMatrix(matrix_, this);
    apply(static_cast<osg::Node&>(transform));
    matrix_ = outer;
}

void Collector::apply(osg::Drawable& drawable) {
    osg::Geometry* geometry = drawable.asGeometry();
    if (!geometry)
        return;
    const osg::Texture* texture = textureOf(geometry->getStateSet());
    if (placesOf(geometry->getTexCoordArray(0)).empty())
        texture = nullptr;
    if (!batches.contains(texture))
        order.push_back(texture);
    addTriangles(*geometry, batches[texture]);
}

void Collector::addTriangles(osg::Geometry& geometry, Batch& batch) {
    const std::vector<osg::Vec3d> positions = positionsOf(geometry.getVertexArray());
    std::vector<osg::Vec2> places = placesOf(geometry.getTexCoordArray(0));
    std::vector<unsigned int> triangles;
    osg::TriangleIndexFunctor<IndexList> indices;
    indices.into = &triangles;
    geometry.accept(indices);
    if (triangles.empty())
        return;

    const unsigned int last = *std::ranges::max_element(triangles);
    if (last >= positions.size() || (!places.empty() && last >= places.size()))
        throw InputError({name_, "geometry '" + geometry.getName() + "'",
                          "a face with vertex " + std::to_string(last),
                          "indices below the number of its vertices and texture coordinates, " +
                              std::to_string(positions.size()) + " and " +
                              std::to_string(places.size())});
    places.resize(positions.size());
    const auto first = static_cast<unsigned int>(batch.vertices.size());
    for (const osg::Vec3d& position : positions) {
        const osg::Vec3d vertex = position * matrix_;
        if (!std::isfinite(vertex.x() + vertex.y() + vertex.z()))
            throw InputError({name_, "geometry '" + geometry.getName() + "'",
                              "a vertex that is not finite", "finite coordinates"});
        batch.vertices.push_back(vertex);
    }
    batch.places.insert(batch.places.end(), places.begin(), places.end());
    for (const unsigned int index : triangles)
        batch.triangles.push_back(first + index);
}

TextureImage read(const osg::Texture& texture, const std::filesystem::path& folder,
                  const std::string& name) {
    // From the file itself where there is one: plug-ins may apply a gamma.
    const osg::Image& image = *texture.getImage(0);
    if (!image.getFileName().empty()) {
        const std::filesystem::path named(image.getFileName());
        for (const auto& file : {named, folder / named, folder / named.filename()}) {
            std::error_code ignored;
            if (!refusalOf(file.string(), FileKind::picture) &&
                std::filesystem::is_regular_file(file, ignored))
                return readTexture(file);
        }
    }
    return textureOf(image, name + ", texture '" + image.getFileName() + "'");
}

} // namespace

TexturedMesh texturedMesh(const LoadedGraph& graph, const std::filesystem::path& folder,
                          const std::string& name) {
    Collector collector(name);
    graph.node->accept(collector);
    constexpr double huge = std::numeric_limits<double>::max();
    BoundingBox box{{huge, huge, huge}, {-huge, -huge, -huge}};
    for (const auto& [texture, batch] : collector.batches)
        for (const unsigned int index : batch.triangles)
            include(box, batch.vertices[index]);
    if (!box.valid())
        throw InputError({name, "", "a model without faces", "a terrain of triangles"});

    // Floats keep their digits about the middle.
    TexturedMesh made;
    const Vec3 middle = made.middle_m = box.centre();
    std::vector<Mesh::Part> parts;
    for (const osg::Texture* texture : collector.order) {
        const Collector::Batch& batch = collector.batches.at(texture);
        if (batch.triangles.empty())
            continue;
        Mesh::Part& part = parts.emplace_back();
        for (const osg::Vec3d& v : batch.vertices) {
            const osg::Vec3 place(v - osg::Vec3d(middle.x, middle.y, middle.z));
            part.vertices.push_back({place.x(), place.y(), place.z()});
            part.bounds.include(toVec3(part.vertices.back()));
        }
        for (const osg::Vec2& place : batch.places)
            part.texturePlaces.push_back({place.x(), place.y()});
        part.triangles = batch.triangles;
        if (texture) {
            made.textureOf.push_back(static_cast<int>(made.textures.size()));
            made.textures.push_back({read(*texture, folder, name),
                                     wrapOf(*texture, osg::Texture::WRAP_S),
                                     wrapOf(*texture, osg::Texture::WRAP_T)});
        } else {
            made.textureOf.push_back(-1);
            made.remarks.push_back(std::to_string(batch.triangles.size() / 3) +
                                   " triangles without a texture add no radiance");
        }
    }
    auto mesh = std::make_shared<Mesh>(meshOf(std::move(parts)));
    mesh->bounds = {box.min - middle, box.max - middle};
    made.mesh = std::move(mesh);
    return made;
}

} // namespace irsg
