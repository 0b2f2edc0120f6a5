// What stands about on the sample ship: panes, doors, rails, rigging, aerials, launchers.
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "tools/samples/CorvetteParts.h"

namespace smat::corvette {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;

/// A rod or rope along a path, m, of a few sides.
void addRope(FlightWriter& writer, const std::function<Vec3(double)>& path,
             std::span<const double> places, double radius, int sides = 3) {
    const double reach = 1e-3 * (places.back() - places.front());
    addPatch(
        writer,
        [&](double angle, double t) {
            const Vec3 axis = normalized(path(t + reach) - path(t - reach));
            const Vec3 across =
                normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}));
            return path(t) +
                   (across * std::cos(angle) + cross(axis, across) * std::sin(angle)) * radius;
        },
        edges(0.0, 2.0 * pi, 2.0 * pi / sides), places, rail);
}

void addRod(FlightWriter& writer, const Vec3& from, const Vec3& to, double radius, int sides = 3) {
    addRope(
        writer, [&](double t) { return from + (to - from) * t; }, std::array{0.0, 1.0}, radius,
        sides);
}

constexpr double railHeight_m = 1.05, wireRadius_m = 0.018, postRadius_m = 0.028, postPitch_m = 1.7;
constexpr std::array wires{0.34, 0.67, 1.0};

/// Posts and three wires along an edge, by a parameter in m.
void addRail(FlightWriter& writer, const std::function<Vec3(double)>& edge, double from,
             double to) {
    const auto places = edges(from, to, postPitch_m);
    for (const double place : places)
        addRod(writer, edge(place), edge(place) + Vec3{0, 0, railHeight_m}, postRadius_m);
    for (const double wire : wires)
        addRope(
            writer,
            [&](double t) {
                return edge(t) + Vec3{0, 0, railHeight_m * wire};
            },
            places, wireRadius_m);
}

/// A rail along the edges of a roof that are named: 0 front, 1 port, 2 back, 3 starboard.
void addRoofRail(FlightWriter& writer, const Block& block, std::span<const int> sides) {
    const auto corners = cornersAt(block, 1.0);
    const Vec3 middle = (corners[0] + corners[2]) * 0.5;
    for (const int side : sides) {
        // A hand inside of the edge.
        const Vec3 a = corners[static_cast<std::size_t>(side)];
        const Vec3 b = corners[static_cast<std::size_t>((side + 1) % 4)];
        const auto within = [&](const Vec3& corner) {
            return corner + (middle - corner) * (0.12 / length(middle - corner));
        };
        const Vec3 from = within(a), to = within(b);
        const double whole = length(to - from);
        addRail(
            writer, [&](double t) { return from + (to - from) * (t / whole); }, 0.0, whole);
    }
}

/// A plate a little before a wall of a block: 0 front, 1 port, 2 back, 3 starboard; from one part
/// of its length to another and from one part of its height to another.
void addPlate(FlightWriter& writer, const Block& block, int side, double from, double to,
              double low, double high, const FlightSurface& of) {
    const auto first = static_cast<std::size_t>(side), next = (first + 1) % 4;
    const auto at = [&](double along, double up) {
        const auto corners = cornersAt(block, up);
        return corners[first] + (corners[next] - corners[first]) * along;
    };
    const Vec3 out = normalized(cross(at(1, 0) - at(0, 0), at(0, 1) - at(0, 0)));
    const Vec3 before = out * 0.025;
    addQuad(writer, &of,
            {{at(from, low) + before, at(to, low) + before, at(to, high) + before,
              at(from, high) + before}});
}

void addPanes(FlightWriter& writer) {
    const auto row = [&](int side, int count) {
        for (int i = 0; i < count; ++i) {
            const double pitch = 0.96 / count, from = 0.02 + pitch * i;
            addPlate(writer, bridge, side, from + 0.08 * pitch, from + 0.92 * pitch, 0.46, 0.74,
                     glass);
        }
    };
    row(0, 9);
    row(1, 10);
    row(3, 10);
}

void addDoors(FlightWriter& writer) {
    for (const int side : {1, 3}) {
        // Along port one goes aft, along starboard forward.
        const auto place = [&](double behindStack, double width) {
            const double from = behindStack, to = behindStack + width;
            return side == 1 ? std::array{from, to} : std::array{1.0 - to, 1.0 - from};
        };
        for (const double at : {0.16, 0.55, 0.93}) {
            const auto [from, to] = place(at, 0.035);
            addPlate(writer, mainHouse, side, from, to, 0.06, 0.68, door);
        }
        for (const double at : {0.66, 0.745, 0.83}) {
            const auto [from, to] = place(at, 0.065);
            addPlate(writer, mainHouse, side, from, to, 0.45, 0.86, grating);
        }
        const auto [from, to] = place(0.1, 0.09);
        addPlate(writer, hangar, side, from, to, 0.02, 0.42, door);
        const auto [vent, ventTo] = place(0.55, 0.22);
        addPlate(writer, hangar, side, vent, ventTo, 0.62, 0.84, grating);
    }
    addPlate(writer, hangar, 2, 0.06, 0.13, 0.02, 0.42, door);
}

/// Plates at the bow that keep the sea off the deck.
void addBulwark(FlightWriter& writer) {
    const Curve height{{0.0, 1.18}, {7.0, 1.15}, {9.0, 1.0}};
    for (const double side : {1.0, -1.0})
        addPatch(
            writer,
            [&](double a, double b) {
                const double station = side > 0.0 ? b : a, up = side > 0.0 ? a : b;
                return hullAt(station, 1.0 + (height(station) - 1.0) * up, side);
            },
            side > 0.0 ? edges(0.0, 1.0, 0.5) : edges(0.0, 9.0, 0.75),
            side > 0.0 ? edges(0.0, 9.0, 0.75) : edges(0.0, 1.0, 0.5), bulwark);
}

void addRails(FlightWriter& writer) {
    const auto edge = [](double side) {
        return [side](double station) {
            const Vec3 at = hullAt(station, 1.0, side);
            return Vec3{at.x - 0.1 * side, at.y, at.z};
        };
    };
    for (const double side : {1.0, -1.0})
        addRail(writer, edge(side), 9.0, length_m - 0.15);
    addRail(
        writer,
        [&](double x) {
            return Vec3{x, hullAt(length_m, 1.0, 1.0).y + 0.12, 4.2};
        },
        -5.4, 5.4);
    addRoofRail(writer, mainHouse, std::array{1, 3});
    addRoofRail(writer, bridge, std::array{0, 1, 2, 3});
    addRoofRail(writer, hangar, std::array{0, 1, 2, 3});
}

void addRigging(FlightWriter& writer) {
    constexpr double rope = 0.016;
    const Vec3 top{0, 5.1, 21.3};
    addRod(writer, top, {0, 33.0, 6.9}, rope);
    addRod(writer, {0, 5.1, 20.4}, {0, -10.3, 14.9}, rope);
    for (const double side : {1.0, -1.0}) {
        for (const double out : {2.3, 1.5})
            addRod(writer, {out * side, 5.2, out > 2.0 ? 18.3 : 16.6},
                   {(out + 1.2) * side, 3.0, 10.2}, rope);
        addRod(writer, {0, 5.15, 20.0}, {3.6 * side, 8.5, 10.2}, rope);
        addRod(writer, {0, -10.3, 14.8}, {4.2 * side, -16.0, 9.2}, rope);
        // Whips.
        for (const Vec3 foot : {Vec3{4.2, -17.8, 9.2}, Vec3{3.7, 2.4, 10.2}, Vec3{4.3, -9.9, 9.2}})
            addTurned(writer, {foot.x * side, foot.y, foot.z},
                      {(foot.x + 1.1) * side, foot.y - 0.4, foot.z + 6.0},
                      Curve{{0.0, 0.05}, {1.0, 0.012}}, mast, 5, 2);
    }
    // A pole aft with a yard and a dish, and staffs for flags.
    addTurned(writer, {0, -10.3, 9.2}, {0, -10.3, 15.0}, Curve{{0.0, 0.2}, {1.0, 0.09}}, mast, 10,
              3);
    addRod(writer, {-1.6, -10.3, 13.6}, {1.6, -10.3, 13.6}, 0.05, 5);
    addBall(writer, {0, -9.75, 12.2}, {0.75, 0.22, 0.5}, mast);
    addRod(writer, {0, bow_m - 0.6, 6.6}, {0, bow_m - 0.1, 9.0}, 0.035, 5);
    addRod(writer, {0, -35.6, 4.2}, {0, -36.3, 7.2}, 0.035, 5);
    // The steps of the mast's top: sensors on a cross.
    addRod(writer, {-0.9, 5.15, 20.1}, {0.9, 5.15, 20.1}, 0.04, 5);
    for (const double side : {1.0, -1.0})
        addBall(writer, {0.95 * side, 5.15, 20.25}, {0.16, 0.16, 0.22}, dome);
}

/// Tubes of missiles abeam between bridge and funnels, two to each side, and of torpedoes aft.
void addLaunchers(FlightWriter& writer) {
    const Curve tube{{0.0, 0.0},   {0.002, 0.36}, {0.03, 0.39},
                     {0.97, 0.39}, {0.998, 0.36}, {1.0, 0.0}};
    for (const double side : {1.0, -1.0})
        for (const double y : {0.9, 0.0}) {
            const double own = y + (side > 0.0 ? 0.0 : -2.0);
            addTurned(writer, {-2.2 * side, own, 7.75}, {2.6 * side, own, 9.05}, tube, gun, 14, 10);
        }
    addBlock(writer, {1.5, -2.6, 1.6, 7.15, 7.75, 0.1, 0.1, 0.1}, {&gun, &gun, &gun, &gun});
    const Curve thin{{0.0, 0.0}, {0.002, 0.2}, {0.5, 0.22}, {0.998, 0.2}, {1.0, 0.0}};
    for (const double side : {1.0, -1.0})
        for (const double z : {4.75, 5.2})
            addTurned(writer, {5.2 * side, -9.2, z}, {5.2 * side, -6.0, z}, thin, gun, 10, 6);
}

/// Bollards, capstan and breakwater on the forecastle, winches on the quarter.
void addDeckGear(FlightWriter& writer) {
    const Curve drum{{0.0, 0.24}, {0.5, 0.16}, {0.9, 0.26}, {1.0, 0.0}};
    const auto stand = [&](double x, double y, double size) {
        const double z = deckAt(y) - 0.03;
        addTurned(writer, {x, y, z}, {x, y, z + 0.75 * size}, drum, gun, 10, 5);
    };
    stand(0.0, 29.2, 1.6);
    for (const double side : {1.0, -1.0}) {
        for (const double y : {30.8, 26.8, 17.4})
            for (const double step : {0.0, 0.7})
                stand((y > 30.0 ? 1.3 : y > 20.0 ? 2.6 : 4.6) * side, y - step, 0.8);
        for (const double y : {-22.0, -33.5})
            for (const double step : {0.0, 0.7})
                stand(5.0 * side, y - step, 0.8);
        // Half of the breakwater.
        const double z = deckAt(26.0);
        const std::array<Vec3, 4> plate{{{0.0, 26.4, z - 0.1},
                                         {3.6 * side, 24.9, z - 0.2},
                                         {3.6 * side, 24.8, z + 0.6},
                                         {0.0, 26.3, z + 0.8}}};
        addQuad(writer, &bulwark, plate);
    }
}

} // namespace

void addFittings(FlightWriter& writer) {
    addPanes(writer);
    addDoors(writer);
    addBulwark(writer);
    addRails(writer);
    addRigging(writer);
    addLaunchers(writer);
    addDeckGear(writer);
}

} // namespace smat::corvette
