#include "tools/samples/SampleCorvette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/samples/CorvetteParts.h"
#include "tools/samples/GasZones.h"

namespace smat::corvette {

using irsg::Vec3;

namespace {

constexpr double pi = std::numbers::pi;

/// Half the breadth at the water and at the deck, and the deck's height, by distance from the bow.
const Curve atWater{{0.0, 0.05}, {6.0, 1.0},  {16.0, 3.3}, {28.0, 4.9},
                    {42.0, 5.3}, {60.0, 5.2}, {72.0, 4.7}};
const Curve atDeck{{0.0, 0.10}, {4.0, 2.1},  {12.0, 4.5}, {24.0, 5.8},
                   {42.0, 6.0}, {60.0, 5.9}, {72.0, 5.5}};
const Curve deckHeight{{0.0, 6.6}, {14.0, 5.4}, {28.0, 4.6}, {46.0, 4.2}, {72.0, 4.2}};
constexpr double draught_m = 0.4, stemRake_m = 4.2;

} // namespace

double deckAt(double y) {
    return deckHeight(bow_m - y);
}

Vec3 hullAt(double station, double up, double side) {
    const double z = -draught_m + (deckHeight(station) + draught_m) * up;
    // The stem leans forward, less and less towards midships.
    const double lean = stemRake_m * up * std::max(0.0, 1.0 - station / 26.0);
    const double breadth =
        atWater(station) + (atDeck(station) - atWater(station)) * std::pow(up, 1.6);
    return {side * breadth, bow_m - stemRake_m - station * (1.0 - stemRake_m / length_m) + lean, z};
}

namespace {

/// The engine rooms, and how far it is from one step of the plates' warmth to the next.
constexpr std::array rooms_m{34.0, 56.0};
constexpr double warmStep_m = 1.2;

const FlightSurface* plateAt(double station) {
    const double within = std::min(station - rooms_m[0], rooms_m[1] - station);
    if (within < 0.0)
        return &hull;
    const auto step = static_cast<std::size_t>(within / warmStep_m);
    return step < warmHull.size() ? &warmHull[step] : &engineRoom;
}

void addHull(FlightWriter& writer) {
    std::vector<double> rooms;
    for (std::size_t i = 0; i <= warmHull.size(); ++i) {
        const double within = warmStep_m * static_cast<double>(i);
        rooms.insert(rooms.end(), {rooms_m[0] + within, rooms_m[1] - within});
    }
    const auto stations = edges(0.0, length_m, 1.5, rooms);
    const std::array waterline{0.14};
    const auto heights = edges(0.0, 1.0, 0.1, waterline);
    const auto kind = [](double station, double up) {
        return up < 0.14 ? &strip : plateAt(station);
    };
    // Starboard: outwards is up cross aft; on the port side the other way round.
    addPatch(
        writer, [](double up, double s) { return hullAt(s, up, 1.0); }, heights, stations,
        [&](double up, double s) { return kind(s, up); });
    addPatch(
        writer, [](double s, double up) { return hullAt(s, up, -1.0); }, stations, heights, kind);
    const auto across = edges(-1.0, 1.0, 0.25);
    addPatch(
        writer,
        [](double s, double side) {
            return hullAt(s, 1.0, 1.0) * (0.5 + 0.5 * side) +
                   hullAt(s, 1.0, -1.0) * (0.5 - 0.5 * side);
        },
        stations, across, deck);
    addPatch(
        writer,
        [](double up, double side) {
            return hullAt(length_m, up, 1.0) * (0.5 - 0.5 * side) +
                   hullAt(length_m, up, -1.0) * (0.5 + 0.5 * side);
        },
        heights, across, [&](double up, double) { return up < 0.14 ? &strip : &hull; });
}

} // namespace

void addQuad(FlightWriter& writer, const FlightSurface* of, const std::array<Vec3, 4>& corners) {
    if (of == nullptr)
        return;
    const Vec3 normal = normalized(cross(corners[1] - corners[0], corners[2] - corners[0]));
    std::array<FlightVertex, 4> vertices;
    for (std::size_t i = 0; i < 4; ++i)
        vertices[i] = {corners[i], normal};
    writer.addFace(*of, vertices);
}

std::array<Vec3, 4> cornersAt(const Block& block, double up) {
    const double front = block.front - block.inFront * up, back = block.back + block.inBack * up;
    const double half = block.halfWidth - block.inSide * up;
    const double z = block.foot + (block.top - block.foot) * up;
    return {{{block.x + half, front, z},
             {block.x - half, front, z},
             {block.x - half, back, z},
             {block.x + half, back, z}}};
}

namespace {

/// The walls of a block between two heights, from outside.
void addWalls(FlightWriter& writer, const Block& block, double from, double to,
              const Faces& faces) {
    const auto low = cornersAt(block, from), high = cornersAt(block, to);
    addQuad(writer, faces.front, {{low[0], low[1], high[1], high[0]}});
    addQuad(writer, faces.side, {{low[1], low[2], high[2], high[1]}});
    addQuad(writer, faces.back, {{low[2], low[3], high[3], high[2]}});
    addQuad(writer, faces.side, {{low[3], low[0], high[0], high[3]}});
}

void addTop(FlightWriter& writer, const Block& block, const FlightSurface& of) {
    const auto top = cornersAt(block, 1.0);
    addQuad(writer, &of, top);
}

} // namespace

void addBlock(FlightWriter& writer, const Block& block, const Faces& faces) {
    addWalls(writer, block, 0.0, 1.0, faces);
    if (faces.top != nullptr)
        addTop(writer, block, *faces.top);
}

void addTurned(FlightWriter& writer, const Vec3& from, const Vec3& to, const Curve& radius,
               const FlightSurface& of, int around, int along) {
    const Vec3 axis = normalized(to - from);
    const Vec3 across =
        normalized(cross(axis, std::abs(axis.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{0, 1, 0}));
    const Vec3 other = cross(axis, across);
    addPatch(
        writer,
        [&](double v, double u) {
            return from + (to - from) * u +
                   (across * std::cos(v) + other * std::sin(v)) * radius(u);
        },
        edges(0.0, 2.0 * pi, 2.0 * pi / around), roundedEdges(0.0, 1.0, along), of);
}

void addBall(FlightWriter& writer, const Vec3& centre, const Vec3& radii, const FlightSurface& of) {
    addPatch(
        writer,
        [&](double v, double u) {
            return centre + Vec3{radii.x * std::sin(u) * std::cos(v),
                                 radii.y * std::sin(u) * std::sin(v), -radii.z * std::cos(u)};
        },
        edges(0.0, 2.0 * pi, pi / 10), edges(0.0, pi, pi / 10), of);
}

namespace {

void addHouses(FlightWriter& writer) {
    const Faces walls{&house, &house, &house, &roof};
    addBlock(writer, mainHouse, walls);
    addBlock(writer, bridge, walls);
    addBlock(writer, {8.4, 2.6, 2.4, 10.2, 14.4, 1.6, 1.2, 1.5}, walls);
    addBlock(writer, hangar, walls);
    // The door of the hangar, a hand before its wall.
    addQuad(writer, &door,
            {{{3.1, -18.55, 4.4}, {3.0, -18.55, 8.6}, {-3.0, -18.55, 8.6}, {-3.1, -18.55, 4.4}}});
}

void addMast(FlightWriter& writer) {
    const Curve thin{{0.0, 0.30}, {1.0, 0.12}};
    addTurned(writer, {0, 5.3, 14.4}, {0, 5.1, 21.5}, thin, mast, 14);
    const Curve yard{{0.0, 0.05}, {0.5, 0.09}, {1.0, 0.05}};
    addTurned(writer, {-2.4, 5.2, 18.3}, {2.4, 5.2, 18.3}, yard, mast, 8);
    addTurned(writer, {-1.6, 5.2, 16.6}, {1.6, 5.2, 16.6}, yard, mast, 8);
    addBlock(writer, {5.85, 5.55, 1.5, 15.2, 15.8, 0.0, 0.0, 0.1}, {&mast, &mast, &mast, &mast});
    addBall(writer, {0, 9.8, 11.1}, {1.0, 1.0, 1.05}, dome);
    for (const double side : {1.0, -1.0}) {
        addBall(writer, {3.1 * side, 3.6, 10.8}, {0.6, 0.6, 0.7}, dome);
        // Life rafts in their canisters.
        for (const double y : {-11.5, -13.2, -14.9}) {
            const Curve drum{{0.0, 0.0}, {0.04, 0.30}, {0.5, 0.34}, {0.96, 0.30}, {1.0, 0.0}};
            addTurned(writer, {5.15 * side, y, 4.75}, {5.15 * side, y + 1.3, 4.75}, drum, raft, 12,
                      10);
        }
    }
}

void addGun(FlightWriter& writer) {
    const double y = 22.5, z = deckAt(22.5) - 0.1;
    const Curve ring{{0.0, 1.25}, {1.0, 1.2}};
    addTurned(writer, {0, y, z}, {0, y, z + 0.55}, ring, gun, 24, 2);
    addBlock(writer, {y + 1.7, y - 1.7, 1.25, z + 0.5, z + 2.3, 1.5, 0.5, 0.55},
             {&gun, &gun, &gun, &gun});
    const Curve barrel{{0.0, 0.14}, {0.3, 0.10}, {1.0, 0.075}};
    addTurned(writer, {0, y + 0.6, z + 1.6}, {0, y + 5.1, z + 2.2}, barrel, gun, 12, 4);
    // A smaller one on the roof of the hangar.
    addTurned(writer, {0, -15.5, 9.2}, {0, -15.5, 10.4}, Curve{{0.0, 0.75}, {1.0, 0.45}}, gun, 18,
              3);
    addBall(writer, {0, -15.5, 10.7}, {0.5, 0.5, 0.6}, dome);
}

/// A funnel: its casing, a dark rim, and the uptake inside, which is open.
void addFunnel(FlightWriter& writer, double side) {
    const Block outside{-3.2, -8.2, 1.25, 7.2, 12.2, 1.1, 0.5, 0.35, 2.7 * side};
    constexpr double warmFrom = 0.3, topFrom = 0.86;
    const auto walls = [&](double from, double to, const FlightSurface& of) {
        addWalls(writer, outside, from, to, {&of, &of, &of, nullptr});
    };
    walls(0.0, warmFrom, casing);
    const double step = (topFrom - warmFrom) / static_cast<double>(warmCasing.size());
    for (std::size_t i = 0; i < warmCasing.size(); ++i)
        walls(warmFrom + step * static_cast<double>(i),
              warmFrom + step * static_cast<double>(i + 1), warmCasing[i]);
    walls(topFrom, 1.0, soot);
    const auto rim = cornersAt(outside, 1.0);
    constexpr double wall = 0.16;
    std::array<Vec3, 4> edge = rim, floor = rim;
    for (std::size_t i = 0; i < 4; ++i) {
        edge[i].x += rim[i].x > outside.x ? -wall : wall;
        edge[i].y += i < 2 ? -wall : wall;
        floor[i] = edge[i] - Vec3{0, 0, 2.4};
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        addQuad(writer, &soot, {{rim[i], rim[next], edge[next], edge[i]}});
        addQuad(writer, &uptake, {{edge[i], edge[next], floor[next], floor[i]}});
    }
    addQuad(writer, &uptake, floor);
}

/// The gas over a funnel, which the wind bends aft, and that in it.
void addPlume(FlightWriter& writer, double side) {
    const irsg::BentJet jet = corvetteJet(side);
    const irsg::BentJet::Flow flow = jet.flow();
    const auto vector = [](const irsg::GasVector& v) { return Vec3{v[0], v[1], v[2]}; };
    const Vec3 place = vector(jet.place_m), along = vector(jet.along);
    const Vec3 across = normalized(cross(along, vector(jet.wind_m_s)));
    const auto axis = [&](double along_m) {
        const irsg::BentJet::Section at = flow.axisAt(along_m);
        return AxisPlace{vector(at.place_m), vector(at.along)};
    };
    addGasZones(writer, irsg::plumeZones(flow.table, corvetteZones), axis, across, firstGas, gas,
                side);
    constexpr double deep_m = 2.35, radius_m = 0.65;
    constexpr std::int32_t index = firstGas + static_cast<std::int32_t>(corvetteZones);
    addGasTube(writer, {{-deep_m, radius_m}, {-0.002, radius_m}},
               [&](double along_m) {
                   return AxisPlace{place + along * along_m, along};
               },
               across, {"inner", {index, index}, false, gas});
}

} // namespace
} // namespace smat::corvette

namespace smat {

FlightWriter corvetteModel() {
    using namespace corvette;
    FlightWriter writer("corvet");
    addHull(writer);
    addHouses(writer);
    addMast(writer);
    addGun(writer);
    addFittings(writer);
    for (const double side : {1.0, -1.0}) {
        addFunnel(writer, side);
        addPlume(writer, side);
    }
    return writer;
}

irsg::BentJet corvetteJet(double side) {
    irsg::BentJet jet;
    jet.nozzle.diameter_m = 1.3;
    jet.nozzle.temperature_K = 547.0;
    jet.nozzle.velocity_m_s = 18.0;
    jet.nozzle.fuelAirRatio = 0.02;
    jet.nozzle.air_K = 286.0;
    jet.nozzle.endsAt = 0.15;
    jet.place_m = {2.7 * side, -6.0, 12.2};
    jet.along = {0.0, 0.0, 1.0};
    jet.wind_m_s = {0.0, -4.0, 0.0};
    return jet;
}

} // namespace smat
