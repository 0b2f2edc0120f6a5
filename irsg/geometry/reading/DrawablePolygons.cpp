#include "irsg/geometry/reading/DrawablePolygons.h"

#include <array>
#include <cmath>
#include <optional>

#include <osg/Geometry>

#include "irsg/core/Errors.h"

namespace irsg {
namespace {

using VertexNumbers = std::array<double, 4>;

template <typename Array>
VertexNumbers components(const osg::Array& array, unsigned int index, double scale = 1.0) {
    const auto& value = static_cast<const Array&>(array)[index];
    VertexNumbers element{0, 0, 0, 1};
    for (int i = 0; i < Array::ElementDataType::num_components; ++i)
        element[static_cast<std::size_t>(i)] = scale * static_cast<double>(value[i]);
    return element;
}

/// An element of an array of 2 to 4 numbers, integers scaled to 1; nothing for other types.
std::optional<VertexNumbers> elementOf(const osg::Array& array, unsigned int index) {
    switch (array.getType()) {
    case osg::Array::Vec2ArrayType:
        return components<osg::Vec2Array>(array, index);
    case osg::Array::Vec3ArrayType:
        return components<osg::Vec3Array>(array, index);
    case osg::Array::Vec4ArrayType:
        return components<osg::Vec4Array>(array, index);
    case osg::Array::Vec2dArrayType:
        return components<osg::Vec2dArray>(array, index);
    case osg::Array::Vec3dArrayType:
        return components<osg::Vec3dArray>(array, index);
    case osg::Array::Vec4dArrayType:
        return components<osg::Vec4dArray>(array, index);
    case osg::Array::Vec3bArrayType:
        return components<osg::Vec3bArray>(array, index, 1.0 / 127);
    case osg::Array::Vec3sArrayType:
        return components<osg::Vec3sArray>(array, index, 1.0 / 32767);
    case osg::Array::Vec4ubArrayType:
        return components<osg::Vec4ubArray>(array, index, 1.0 / 255);
    default:
        return std::nullopt;
    }
}

/// An attribute that may belong to each vertex, each primitive set or the whole drawable.
std::optional<VertexNumbers> bound(const osg::Array* array, unsigned int vertex, unsigned int set) {
    if (!array || array->getNumElements() == 0)
        return std::nullopt;
    const auto binding = array->getBinding();
    const unsigned int index = binding == osg::Array::BIND_PER_VERTEX          ? vertex
                               : binding == osg::Array::BIND_PER_PRIMITIVE_SET ? set
                                                                               : 0;
    const bool used = binding == osg::Array::BIND_PER_VERTEX ||
                      binding == osg::Array::BIND_OVERALL ||
                      binding == osg::Array::BIND_PER_PRIMITIVE_SET;
    return used && index < array->getNumElements() ? elementOf(*array, index) : std::nullopt;
}

class Polygons {
  public:
    Polygons(const osg::Geometry& geometry, const std::string& name,
             const std::function<void(std::vector<PolygonCorner>&)>& each)
        : geometry_(geometry), name_(name), each_(each) {}

    long run() {
        for (set_ = 0; set_ < geometry_.getNumPrimitiveSets(); ++set_) {
            const auto& primitives = *geometry_.getPrimitiveSet(set_);
            unsigned int first = 0;
            if (const auto* lengths = dynamic_cast<const osg::DrawArrayLengths*>(&primitives)) {
                for (const auto length : *lengths) {
                    const auto count = static_cast<unsigned int>(std::max(length, 0));
                    sequence(primitives, first, count);
                    first += count;
                }
            } else {
                sequence(primitives, 0, primitives.getNumIndices());
            }
        }
        return passed_;
    }

  private:
    void sequence(const osg::PrimitiveSet& primitives, unsigned int first, unsigned int count) {
        const auto at = [&](unsigned int i) { return primitives.index(first + i); };
        std::vector<unsigned int> whole;
        switch (primitives.getMode()) {
        case GL_TRIANGLES:
            for (unsigned int i = 0; i + 2 < count; i += 3)
                polygon({at(i), at(i + 1), at(i + 2)});
            break;
        case GL_TRIANGLE_STRIP:
            for (unsigned int i = 0; i + 2 < count; ++i)
                if (i % 2 == 0)
                    polygon({at(i), at(i + 1), at(i + 2)});
                else
                    polygon({at(i + 1), at(i), at(i + 2)});
            break;
        case GL_TRIANGLE_FAN:
            for (unsigned int i = 1; i + 1 < count; ++i)
                polygon({at(0), at(i), at(i + 1)});
            break;
        case GL_QUADS:
            for (unsigned int i = 0; i + 3 < count; i += 4)
                polygon({at(i), at(i + 1), at(i + 2), at(i + 3)});
            break;
        case GL_QUAD_STRIP:
            for (unsigned int i = 0; i + 3 < count; i += 2)
                polygon({at(i), at(i + 1), at(i + 3), at(i + 2)});
            break;
        case GL_POLYGON:
            for (unsigned int i = 0; i < count; ++i)
                whole.push_back(at(i));
            polygon(whole);
            break;
        default:
            passed_ += std::max(1u, primitives.getNumPrimitives());
        }
    }

    void polygon(const std::vector<unsigned int>& vertices) {
        corners_.clear();
        for (const auto vertex : vertices)
            corners_.push_back(corner(vertex));
        if (corners_.size() >= 3)
            each_(corners_);
        else
            ++passed_;
    }

    PolygonCorner corner(unsigned int vertex) const {
        const auto* positions = geometry_.getVertexArray();
        const auto where = [&] { return "vertex " + std::to_string(vertex); };
        if (!positions || vertex >= positions->getNumElements())
            throw InputError({name_, where(),
                              "an array of " +
                                  std::to_string(positions ? positions->getNumElements() : 0) +
                                  " vertices",
                              "a vertex for each index"});
        const auto position = elementOf(*positions, vertex);
        if (!position)
            throw InputError({name_, "", std::string("vertices of type ") + positions->className(),
                              "two to four numbers a vertex"});
        PolygonCorner corner;
        corner.vertex = vertex;
        for (std::size_t i = 0; i < 3; ++i) {
            const double value = (*position)[i];
            if (!(std::abs(value) <= 1e9))
                throw InputError({name_, where(), "coordinate " + std::to_string(value),
                                  "a finite number within 1e9"});
            corner.position[static_cast<int>(i)] = value;
        }
        if (const auto normal = bound(geometry_.getNormalArray(), vertex, set_))
            corner.normal.set((*normal)[0], (*normal)[1], (*normal)[2]);
        if (const auto colour = bound(geometry_.getColorArray(), vertex, set_))
            for (int i = 0; i < 4; ++i)
                corner.colour[i] = static_cast<float>((*colour)[static_cast<std::size_t>(i)]);
        if (const auto place = bound(geometry_.getTexCoordArray(0), vertex, set_))
            corner.onTexture.set((*place)[0], (*place)[1]);
        return corner;
    }

    const osg::Geometry& geometry_;
    const std::string& name_;
    const std::function<void(std::vector<PolygonCorner>&)>& each_;
    std::vector<PolygonCorner> corners_;
    unsigned int set_ = 0;
    long passed_ = 0;
};

} // namespace

long forEachPolygon(const osg::Geometry& geometry, const std::string& name,
                    const std::function<void(std::vector<PolygonCorner>&)>& each) {
    return Polygons(geometry, name, each).run();
}

} // namespace irsg
