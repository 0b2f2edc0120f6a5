#pragma once

#include <compare>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "irsg/gas/GasColumnBasis.h"
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

/// What lines of sight through the gases of an entity are weighted sums of.
struct GasColumnsOfEntity {
    GasColumnBasis basis;
    std::vector<int> numbers; ///< of its columns, see gasColumnNumber()
};
/// Of gases in closed meshes, whose lengths do not count. Wavelengths, of what is computed, say
/// which of a few wide bands the columns are made for. Computed once for equal gases of a mesh.
std::shared_ptr<const GasColumnsOfEntity> gasColumnsOf(const std::shared_ptr<const Mesh>& mesh,
                                                       const std::map<IrCodes, GasLayer>& gases,
                                                       const std::vector<double>& wavelengths_um);

/// What the walk through samples knows of a gas that a drawn row is the boundary of.
struct GasZone {
    GasZoneShape shape;
    std::shared_ptr<const GasColumnsOfEntity> columns;
    std::size_t gas = 0; ///< of the basis
    int firstRow = 0;    ///< drawn row of the entity's first gas: kinds of its gases are of that
    bool operator==(const GasZone&) const = default;
};

/// A line of sight through the gases of one entity: what stands in an OccluderStack for all gas of
/// the entity in front of something.
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
