#pragma once

#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/radiance/OccluderStacks.h"

namespace irsg {

/// The closed meshes of a model that hold one gas.
struct GasZoneShape {
    double volume_m3 = 0.0;
    double longest_m = 0.0; ///< of the sphere about them: no line of sight goes farther in them
    /// Edges between two vertices that not as many faces go along in one sense as in the other:
    /// above 0 where a mesh is open, or some of its faces are turned over.
    int openEdges = 0;
    bool operator==(const GasZoneShape&) const = default;
};

/// Of the faces that carry these codes; computed once a mesh.
GasZoneShape gasZoneShape(const std::shared_ptr<const Mesh>& mesh, const IrCodes& codes);
/// Whether a place in the axes of the mesh, m, is in it.
bool isInGasZone(const Mesh& mesh, const IrCodes& codes, const Vec3& place_m);

/// What the walk through samples knows of a gas that a drawn row is the boundary of.
struct GasZone {
    GasZoneShape shape;
    /// Lengths between which radiance is taken as linear in the length, m, from 0 to beyond the
    /// longest: by squares at least, as what is thin is linear and lines grow as the square root.
    std::vector<double> knots_m;
    bool operator==(const GasZone&) const = default;
};
/// `zones`: gases of the same entity, which share the number of columns.
GasZone gasZone(const GasZoneShape& shape, std::size_t zones);

/// A line of sight through the gases of one entity at lengths that are knots: what stands in an
/// OccluderStack for all gas of the entity in front of something.
struct GasColumnKey {
    struct Stretch {
        IrCodes codes;
        double length_m = 0.0;
        auto operator<=>(const Stretch&) const = default;
    };
    std::vector<Stretch> stretches; ///< in order from the sensor
    /// Whose emission does not count: another kind of the same sample has it already.
    std::size_t before = 0;
    auto operator<=>(const GasColumnKey&) const = default;
};

/// Its number among materials of an entity, below all of theirs: the same wherever and whenever it
/// is asked for. Numbers are kept as long as the process.
int gasColumnNumber(const GasColumnKey& column);
inline bool isGasColumn(int material) {
    constexpr int highest = -(1 << 30);
    return material < highest;
}
/// LogicError for a number that was given to none.
const GasColumnKey& gasColumn(int number);
/// The column of an entity among the materials of a stack; null for none.
const OccluderMaterial* gasColumnOf(const std::vector<OccluderMaterial>& materials, int entity);

} // namespace irsg
