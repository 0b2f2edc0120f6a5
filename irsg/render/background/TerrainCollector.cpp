#include "irsg/render/background/TerrainCollector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <osg/Texture2D>
#include <osg/Transform>
#include <osg/TriangleIndexFunctor>

#include "irsg/core/Errors.h"
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

/// A border has no radiance of its own: what would fade into it ends with the edge.
osg::Texture::WrapMode wrapOf(const osg::Texture& texture, osg::Texture::WrapParameter axis) {
    const osg::Texture::WrapMode mode = texture.getWrap(axis);
    return mode == osg::Texture::REPEAT || mode == osg::Texture::MIRROR
               ? mode
               : osg::Texture::CLAMP_TO_EDGE;
}

void include(BoundingBox& box, const osg::Vec3d& v) {
    box.min = {std::min(box.min.x, v.x()), std::min(box.min.y, v.y()), std::min(box.min.z, v.z())};
    box.max = {std::max(box.max.x, v.x()), std::max(box.max.y, v.y()), std::max(box.max.z, v.z())};
}

} // namespace

TerrainCollector::TerrainCollector(const std::filesystem::path& folder, const std::string& name)
    : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN), folder_(folder), name_(name) {}

const osg::Texture* TerrainCollector::textureOf(const osg::StateSet* state) const {
    if (!state)
        return texture_;
    const auto* own = dynamic_cast<const osg::Texture*>(
        state->getTextureAttribute(0, osg::StateAttribute::TEXTURE));
    return own && own->getImage(0) ? own : texture_;
}

void TerrainCollector::apply(osg::Node& node) {
    const osg::Texture* outer = std::exchange(texture_, textureOf(node.getStateSet()));
    traverse(node);
    texture_ = outer;
}

void TerrainCollector::apply(osg::Transform& transform) {
    const osg::Matrixd outer = matrix_;
    transform.computeLocalToWorldMatrix(matrix_, this);
    apply(static_cast<osg::Node&>(transform));
    matrix_ = outer;
}

void TerrainCollector::apply(osg::Drawable& drawable) {
    osg::Geometry* geometry = drawable.asGeometry();
    if (!geometry)
        return;
    const osg::Texture* texture = textureOf(geometry->getStateSet());
    if (placesOf(geometry->getTexCoordArray(0)).empty())
        texture = nullptr;
    if (!batches_.contains(texture))
        order_.push_back(texture);
    addTriangles(*geometry, batches_[texture]);
}

void TerrainCollector::addTriangles(osg::Geometry& geometry, Batch& batch) {
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

TextureImage TerrainCollector::read(const osg::Texture& texture) const {
    // From the file itself where there is one: plug-ins may apply a gamma.
    const osg::Image& image = *texture.getImage(0);
    if (!image.getFileName().empty()) {
        const std::filesystem::path named(image.getFileName());
        for (const auto& file : {named, folder_ / named, folder_ / named.filename()}) {
            std::error_code ignored;
            if (!refusalOf(file.string(), FileKind::picture) &&
                std::filesystem::is_regular_file(file, ignored))
                return readTexture(file);
        }
    }
    return irsg::textureOf(image, name_ + ", texture '" + image.getFileName() + "'");
}

void TerrainCollector::collect(osg::Node& graph, const Vec3& position_m, Terrain::Impl& parts) {
    graph.accept(*this);
    constexpr double huge = std::numeric_limits<double>::max();
    BoundingBox box{{huge, huge, huge}, {-huge, -huge, -huge}};
    for (const auto& [texture, batch] : batches_)
        for (const unsigned int index : batch.triangles)
            include(box, batch.vertices[index]);
    if (!box.valid())
        throw InputError({name_, "", "a model without faces", "a terrain of triangles"});

    // Floats keep their digits about the middle.
    const Vec3 middle = box.centre();
    parts.pose.position_m = position_m + middle;
    parts.bounds = {box.min - middle, box.max - middle};
    for (const osg::Texture* texture : order_) {
        const Batch& batch = batches_.at(texture);
        if (batch.triangles.empty())
            continue;
        const osg::ref_ptr<osg::Vec3Array> vertices =
            new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
        for (const osg::Vec3d& v : batch.vertices)
            vertices->push_back(osg::Vec3(v - osg::Vec3d(middle.x, middle.y, middle.z)));
        const osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
        geometry->setUseDisplayList(false);
        geometry->setUseVertexBufferObjects(true);
        geometry->setUseVertexArrayObject(true);
        geometry->setVertexArray(vertices);
        geometry->setTexCoordArray(0, new osg::Vec2Array(batch.places.begin(), batch.places.end()),
                                   osg::Array::BIND_PER_VERTEX);
        geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES, batch.triangles.begin(),
                                                            batch.triangles.end()));
        int index = -1;
        if (texture) {
            index = static_cast<int>(parts.textures.size());
            parts.textures.push_back({read(*texture), wrapOf(*texture, osg::Texture::WRAP_S),
                                      wrapOf(*texture, osg::Texture::WRAP_T)});
        } else {
            parts.remarks.push_back(std::to_string(batch.triangles.size() / 3) +
                                    " triangles without a texture add no radiance");
        }
        parts.pieces.push_back({geometry, index});
    }
}

} // namespace irsg
