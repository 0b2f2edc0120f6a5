#include "irsg/geometry/conversion/SurfaceMesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include "irsg/geometry/conversion/OsgValues.h"
#include "irsg/geometry/reading/Triangulation.h"

namespace irsg {
namespace {

/// A zero has one sign, so that equal places are one vertex.
Float3 withOneZero(const osg::Vec3d& v) {
    const osg::Vec3 rounded(v);
    return {rounded.x() + 0.0f, rounded.y() + 0.0f, rounded.z() + 0.0f};
}

template <typename Vector>
bool areSame(const Vector& a, const Vector& b) {
    return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

/// Of all bits of a vertex: each word is multiplied in, and what is above folded down.
std::size_t hashOf(const Float3& p, const Float3& n, unsigned int colour) {
    std::array<std::uint64_t, 4> words{};
    std::memcpy(words.data(), p.data(), sizeof p);
    std::memcpy(reinterpret_cast<char*>(words.data()) + sizeof p, n.data(), sizeof n);
    words[3] = colour;
    std::uint64_t hash = 0;
    for (const std::uint64_t word : words) {
        hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
}

/// Without what a growing array has to spare, but for one vertex: rays read a little beyond
/// the last.
template <typename Element>
void trim(std::vector<Element>& array) {
    std::vector<Element> same;
    same.reserve(array.size() + 1);
    same.insert(same.end(), array.begin(), array.end());
    array.swap(same);
}

} // namespace

void SurfaceMesh::VertexTable::grow() {
    const std::vector<Slot> before =
        std::exchange(slots_, std::vector<Slot>(std::max<std::size_t>(1024, 2 * slots_.size())));
    shift_ = 32 - std::countr_zero(slots_.size());
    // Slots follow their hashes, so that all are taken over from end to end.
    for (const Slot& one : before)
        if (one.number != 0)
            slots_[freeFor(one.hash)] = one;
}

std::size_t SurfaceMesh::VertexTable::freeFor(std::uint32_t hash) const {
    std::size_t slot = hash >> shift_;
    while (slots_[slot].number != 0)
        slot = (slot + 1) & (slots_.size() - 1);
    return slot;
}

unsigned int SurfaceMesh::ColourNumbers::of(const osg::Vec4& colour) {
    Bits bits{};
    std::memcpy(bits.data(), colour.ptr(), sizeof bits);
    if (numbers_.empty() || bits != last_) {
        const auto next = static_cast<unsigned int>(numbers_.size());
        lastNumber_ = numbers_.try_emplace(bits, next).first->second;
        last_ = bits;
    }
    return lastNumber_;
}

SurfaceMesh::VertexTable::Vertex::Vertex(const PolygonCorner& corner, unsigned int ofColour)
    : place(withOneZero(corner.position)),
      normal(withOneZero(corner.normal)),
      colour(ofColour),
      hash(static_cast<std::uint32_t>(hashOf(place, normal, colour))) {}

void SurfaceMesh::VertexTable::prepare(const Vertex& vertex) const {
    if (!slots_.empty())
        __builtin_prefetch(&slots_[vertex.hash >> shift_]);
}

unsigned int SurfaceMesh::VertexTable::index(Part& part, const Vertex& vertex) {
    if (2 * part.vertices.size() >= slots_.size())
        grow();
    std::size_t slot = vertex.hash >> shift_;
    for (; slots_[slot].number != 0; slot = (slot + 1) & (slots_.size() - 1)) {
        const unsigned int known = slots_[slot].number - 1;
        if (slots_[slot].hash == vertex.hash && areSame(part.vertices[known], vertex.place) &&
            areSame(part.normals[known], vertex.normal) && part.colourOf[known] == vertex.colour)
            return known;
    }
    part.vertices.push_back(vertex.place);
    part.normals.push_back(vertex.normal);
    part.colourOf.push_back(vertex.colour);
    part.bounds.include(toVec3(vertex.place));
    slots_[slot] = {static_cast<unsigned int>(part.vertices.size()), vertex.hash};
    return slots_[slot].number - 1;
}

void SurfaceMesh::add(const Mesh::Kind& kind, std::vector<PolygonCorner>& corners) {
    const auto cut = triangulate(corners);
    if (cut.triangles.empty()) {
        ++degenerate_;
        return;
    }
    folded_ += cut.folded;

    // Each corner gets a unit normal; together they must face as the polygon does.
    osg::Vec3d sum;
    bool made = false;
    for (auto& corner : corners) {
        const double size = corner.normal.length();
        const bool usable = std::isfinite(size) && size > 1e-12;
        corner.normal = usable ? corner.normal / size : cut.normal;
        made = made || !usable;
        sum += corner.normal;
    }
    normalsMade_ += made;
    if (sum * cut.normal < 0.0) {
        ++normalsTurned_;
        for (auto& corner : corners)
            corner.normal = -corner.normal;
    }

    Part& part = parts_[kind];
    VertexTable& table = tables_[kind];
    ++part.polygons;
    part.area_m2 += cut.area;
    ofPolygon_.clear();
    for (const PolygonCorner& corner : corners) {
        ofPolygon_.emplace_back(corner, colours_.of(corner.colour));
        table.prepare(ofPolygon_.back());
    }
    for (const auto& triangle : cut.triangles) {
        part.polygonOf.push_back(polygons_);
        for (const auto corner : triangle)
            part.triangles.push_back(table.index(part, ofPolygon_[corner]));
    }
    ++polygons_;
}

void SurfaceMesh::setLayers(const std::vector<int>& layers) {
    const std::map<Mesh::Kind, Part> before = std::exchange(parts_, {});
    tables_.clear();
    for (const auto& [kind, part] : before) {
        unsigned int last = polygons_;
        for (std::size_t i = 0; i < part.polygonOf.size(); ++i) {
            const unsigned int polygon = part.polygonOf[i];
            Mesh::Kind to = kind;
            if (layers[polygon] >= 0)
                to.layer = layers[polygon];
            Part& into = parts_[to];
            VertexTable& table = tables_[to];
            into.polygonOf.push_back(polygon);
            std::array<osg::Vec3d, 3> places;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t vertex = part.triangles[3 * i + k];
                PolygonCorner corner;
                corner.position = places[k] = toOsg(part.vertices[vertex]);
                corner.normal = toOsg(part.normals[vertex]);
                into.triangles.push_back(table.index(into, {corner, part.colourOf[vertex]}));
            }
            into.area_m2 += 0.5 * ((places[1] - places[0]) ^ (places[2] - places[0])).length();
            into.polygons += polygon != std::exchange(last, polygon);
        }
    }
}

std::vector<Mesh::Part> SurfaceMesh::take() {
    std::vector<Mesh::Part> parts;
    tables_.clear();
    for (auto& [kind, part] : parts_) {
        part.polygonOf = {};
        part.colourOf = {};
    }
    for (auto& [kind, part] : parts_) {
        trim(part.vertices);
        trim(part.normals);
        trim(part.triangles);
        static_cast<Mesh::Kind&>(part) = kind;
        parts.push_back(static_cast<Mesh::Part&&>(part));
    }
    parts_.clear();
    return parts;
}

} // namespace irsg
