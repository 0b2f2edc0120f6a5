#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "irsg/gas/PlumeTable.h"
#include "tools/samples/ModelWriter.h"

namespace smat {

/// A place of a plume's axis, m, and the unit vector along which it goes on.
struct AxisPlace {
    irsg::Vec3 place, along;
};
/// By the distance along it, m.
using PlumeAxis = std::function<AxisPlace(double along_m)>;

/// Writes a closed mesh of rings of `around` vertices, one ring after the other: `lid` is the
/// middle of the first, `tip` ends the last.
void addClosedRings(ModelWriter& writer, const FlightSurface& of, std::vector<FlightVertex> rings,
                    std::size_t around, const FlightVertex& lid, const FlightVertex& tip);
/// By how much a polygon of so many corners is wider than a round of the same area.
double widerThanRound(std::size_t corners);
/// The share of its radius that gas has at a place of its length, where 1 is the end of the table
/// that cuts it off: it goes round there, so that no edge is seen.
double roundedEnd(double place);
/// Writes gas about an axis as a closed mesh: an outline of (x, r), x ascending, r above 0, with
/// flat ends. `across` is the normal to the plane in which the axis bends; where it bends within
/// less than the radius, rings turn about their inner places.
void addGasTube(ModelWriter& writer, const std::vector<std::array<double, 2>>& outline_m,
                const PlumeAxis& axis, const irsg::Vec3& across, const FlightSurface& of);
/// Writes zones of a plume within each other, the first from outside with the indices `first`, the
/// next with one more. Zones that the table cuts off at its end go round there. They stay on
/// starboard (x > 0) where `side` is above 0, on the port side where it is below.
void addGasZones(ModelWriter& writer, const std::vector<irsg::PlumeZone>& zones,
                 const PlumeAxis& axis, const irsg::Vec3& across, std::int32_t first,
                 const Look& look, double side = 0.0);

/// Writes a table as `smat-batch plume` reads it.
void savePlumeTable(const irsg::PlumeTable& table, const std::filesystem::path& file);

} // namespace smat
