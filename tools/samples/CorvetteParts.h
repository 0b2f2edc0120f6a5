#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tools/samples/FlightWriter.h"
#include "tools/samples/Patch.h"

/// What the parts of the ship share: samples/corvette/README.md has the list of its codes.
namespace smat::corvette {

/// A grey with a little blue.
inline constexpr Look shade(int red) {
    return {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(red + 4),
            static_cast<std::uint8_t>(red + 10)};
}
inline const FlightSurface hull{"hull", {1, 7}, false, shade(128)};
inline const FlightSurface bulwark{"bulwark", {1, 7}, true, shade(128)};
inline const FlightSurface strip{"strip", {2, 8}, false, shade(70)};
inline const FlightSurface engineRoom{"machine", {3, 7}, false, shade(128)};
/// Between hull and engine rooms, from the colder to the warmer.
inline const std::array<FlightSurface, 4> warmHull{{{"hull1", {16, 7}, false, shade(128)},
                                                    {"hull2", {17, 7}, false, shade(128)},
                                                    {"hull3", {18, 7}, false, shade(128)},
                                                    {"hull4", {19, 7}, false, shade(128)}}};
inline const FlightSurface deck{"deck", {4, 9}, false, shade(84)};
inline const FlightSurface house{"house", {5, 1}, false, shade(150)};
inline const FlightSurface roof{"roof", {6, 1}, false, shade(150)};
inline const FlightSurface glass{"window", {7, 2}, false, shade(40)};
/// Gas: temperature and material of the outermost zone; zones within and the gas in the funnels
/// follow.
inline constexpr std::int32_t firstGas = 61;
inline constexpr Look gas{200, 200, 200, 0.8};
inline const FlightSurface casing{"casing", {9, 1}, false, shade(140)};
/// Between casing and top of a funnel, upwards; the upper half is sooted.
inline const std::vector<FlightSurface> warmCasing = [] {
    constexpr int count = 18;
    constexpr std::int32_t first = 41;
    std::vector<FlightSurface> all;
    for (int i = 0; i < count; ++i) {
        const bool clean = 2 * i < count;
        all.push_back({"fun" + std::to_string(i + 1),
                       {first + i, clean ? 1 : 12},
                       false,
                       clean ? shade(140) : shade(90 - 3 * (i - count / 2))});
    }
    return all;
}();
inline const FlightSurface uptake{"uptake", {10, 4}, true, shade(60)};
inline const FlightSurface mast{"mast", {11, 1}, false, shade(120)};
inline const FlightSurface dome{"dome", {12, 11}, false, shade(220)};
inline const FlightSurface gun{"gun", {13, 1}, false, shade(120)};
inline const FlightSurface soot{"soot", {14, 12}, false, shade(50)};
inline const FlightSurface door{"door", {15, 1}, false, shade(160)};
inline const FlightSurface raft{"raft", {12, 11}, false, shade(230)};
inline const FlightSurface rail{"rail", {26, 1}, false, shade(150)};
inline const FlightSurface grating{"grating", {27, 12}, false, shade(50)};

/// The bow is at y = bow_m; stations count from there to the stern, m.
inline constexpr double bow_m = 36.0, length_m = 72.0;

/// A place of the hull by its station, from 0 below the water to 1 at the deck, `side` +1
/// starboard.
irsg::Vec3 hullAt(double station, double up, double side);
/// The height of the deck at a place along y.
double deckAt(double y);

/// A block with sloped sides on a rectangle.
struct Block {
    double front, back;             ///< y of its foot
    double halfWidth;               ///< of its foot
    double foot, top;               ///< z
    double inFront, inBack, inSide; ///< how far its top is drawn in
    double x = 0.0;                 ///< of its middle
};

struct Faces {
    const FlightSurface *front, *back, *side, *top; ///< null where there is none
};

inline constexpr Block mainHouse{14.0, -9.5, 5.0, 4.1, 7.2, 1.6, 0.2, 0.5};
inline constexpr Block bridge{12.6, 2.0, 4.6, 7.2, 10.2, 0.9, 0.5, 0.6};
inline constexpr Block hangar{-9.5, -18.5, 4.9, 4.1, 9.2, 0.3, 0.0, 0.45};

/// The corners of a block at a height from 0 (foot) to 1 (top): starboard front, port front, port
/// back, starboard back.
std::array<irsg::Vec3, 4> cornersAt(const Block& block, double up);
void addQuad(FlightWriter& writer, const FlightSurface* of,
             const std::array<irsg::Vec3, 4>& corners);
void addBlock(FlightWriter& writer, const Block& block, const Faces& faces);
/// A surface of revolution about an axis from `from` to `to`, by its radius from 0 to 1 along it.
void addTurned(FlightWriter& writer, const irsg::Vec3& from, const irsg::Vec3& to,
               const Curve& radius, const FlightSurface& of, int around = 16, int along = 6);
void addBall(FlightWriter& writer, const irsg::Vec3& centre, const irsg::Vec3& radii,
             const FlightSurface& of);

/// Panes, doors, gratings, bulwark, rails, rigging, aerials, launchers, and what else stands about.
void addFittings(FlightWriter& writer);

} // namespace smat::corvette
