#include "tools/samples/SampleHelicopter.h"

#include <array>
#include <cmath>
#include <numbers>

#include "tools/samples/Patch.h"

namespace smat {
namespace {

using irsg::Vec3;

constexpr double pi = std::numbers::pi;

const FlightSurface paint{"Paint_Olive", {}, false, {92, 98, 72}};
const FlightSurface belly{"Paint_Grey", {}, false, {120, 122, 124}};
const FlightSurface glass{"Canopy", {}, false, {40, 52, 64}};
const FlightSurface blade{"Rotor_Blade", {}, true, {46, 46, 48}};
const FlightSurface hub{"Rotor_Hub_Steel", {}, false, {120, 120, 126}};
const FlightSurface cowl{"Engine_Cowling", {}, false, {104, 106, 96}};
const FlightSurface pipe{"Exhaust_Pipe", {}, true, {70, 60, 54}};
const FlightSurface skid{"Skid_Steel", {}, false, {84, 86, 90}};
const FlightSurface tyre{"Rubber_Foot", {}, false, {30, 30, 30}};

/// By distance from the nose, m: half the breadth, the lower and the upper edge of the cabin with
/// the tail boom behind it.
const Curve halfBreadth{{0.0, 0.02}, {0.25, 0.38}, {0.8, 0.66}, {1.6, 0.78}, {3.2, 0.76},
                        {4.2, 0.52}, {4.9, 0.24},  {6.5, 0.19}, {9.6, 0.12}};
const Curve lowEdge{{0.0, 0.62}, {0.25, 0.42}, {0.8, 0.24}, {1.8, 0.14}, {3.4, 0.20},
                    {4.3, 0.56}, {5.0, 0.92},  {6.5, 1.05}, {9.6, 1.22}};
const Curve highEdge{{0.0, 0.72}, {0.3, 0.98}, {0.9, 1.42}, {1.6, 1.70}, {2.6, 1.78},
                     {3.8, 1.70}, {4.5, 1.52}, {5.2, 1.44}, {9.6, 1.48}};
constexpr double length_m = 9.6, noseAt_m = 4.0;

/// A section that is a little squarer than an ellipse. `v` runs from 0 at the keel over starboard.
Vec3 hullAt(double station, double v) {
    const auto squarer = [](double s) { return std::copysign(std::pow(std::abs(s), 0.85), s); };
    const double low = lowEdge(station), high = highEdge(station), b = halfBreadth(station);
    const double z = 0.5 * (low + high) - 0.5 * (high - low) * squarer(std::cos(v));
    return {b * squarer(std::sin(v)), noseAt_m - station, z};
}

/// A tube around a line that bends: from, to and radii; `along` from 0 to 1.
void addTube(ModelWriter& writer, const std::array<Vec3, 4>& bend, double from_m, double to_m,
             const FlightSurface& surface, int rings, int segments) {
    const auto at = [&](double t) {
        const double s = 1.0 - t;
        return bend[0] * (s * s * s) + bend[1] * (3 * s * s * t) + bend[2] * (3 * s * t * t) +
               bend[3] * (t * t * t);
    };
    const auto shape = [&](double u, double v) {
        const Vec3 along = normalized(at(std::min(1.0, u + 1e-3)) - at(std::max(0.0, u - 1e-3)));
        const Vec3 side =
            normalized(cross(along, std::abs(along.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
        const Vec3 other = cross(side, along);
        const double radius = from_m + (to_m - from_m) * u;
        return at(u) + side * (radius * std::cos(v)) + other * (radius * std::sin(v));
    };
    addPatch(writer, shape, edges(0.0, 1.0, 1.0 / rings), edges(0.0, 2.0 * pi, 2.0 * pi / segments),
             surface);
}

/// A slim wing between two ends, with a lens for its section; `chord` lies along `forward`.
void addSlab(ModelWriter& writer, const Vec3& root, const Vec3& tip, const Vec3& forward,
             double rootChord_m, double tipChord_m, double thickness, const FlightSurface& surface,
             int cells) {
    const Vec3 span = tip - root;
    const Vec3 up = normalized(cross(forward, span));
    const auto shape = [&](double u, double v) {
        const double chord = rootChord_m + (tipChord_m - rootChord_m) * u;
        return root + span * u + forward * (0.5 * chord * std::cos(v)) +
               up * (0.5 * chord * thickness * std::sin(v));
    };
    addPatch(writer, shape, edges(0.0, 1.0, 1.0 / cells), edges(0.0, 2.0 * pi, pi / 8), surface);
}

void addCabin(GltfWriter& writer) {
    writer.object("Fuselage");
    // Panes: windscreen, doors and the windows over the pilots' feet, with frames between them.
    const auto surfaceAt = [](double u, double v) -> const FlightSurface* {
        const double side = std::abs(v - pi); // 0 on top, pi at the keel
        const bool isFrame = std::abs(side - 0.06) < 0.06 || (u > 1.42 && u < 1.56);
        const bool isScreen = u > 0.32 && u < 1.45 && side < 1.55;
        const bool isDoor = u > 1.55 && u < 2.55 && side > 0.55 && side < 1.45;
        const bool isChin = u > 0.25 && u < 0.75 && side > 1.9 && side < 2.5;
        if ((isScreen || isDoor || isChin) && !isFrame)
            return &glass;
        return side > 2.45 ? &belly : &paint;
    };
    addPatch(writer, hullAt, edges(0.0, length_m, 0.09), edges(0.0, 2.0 * pi, pi / 36), surfaceAt);

    writer.object("Engine");
    const auto cowling = [](double u, double v) {
        const double swell = std::sin(pi * u);
        return Vec3{0.46 * std::pow(swell, 0.5) * std::cos(v), 2.3 - 2.5 * u,
                    1.62 + 0.62 * std::pow(swell, 0.55) * std::sin(v)};
    };
    // Its front is outside: u runs aft, v from starboard over the top.
    addPatch(writer, cowling, roundedEdges(0.002, 0.998, 28), edges(0.0, pi, pi / 24), cowl);
    for (const double side : {1.0, -1.0})
        addTube(writer,
                {Vec3{0.30 * side, 0.55, 1.92}, Vec3{0.46 * side, 0.25, 1.98},
                 Vec3{0.56 * side, 0.0, 2.02}, Vec3{0.66 * side, -0.35, 2.04}},
                0.13, 0.12, pipe, 16, 28);
}

void addTail(GltfWriter& writer) {
    writer.object("Tail");
    addSlab(writer, {0.0, -5.05, 1.2}, {0.0, -5.75, 2.55}, {0, 1, 0}, 1.0, 0.55, 0.13, paint, 14);
    addSlab(writer, {0.0, -5.05, 1.3}, {0.0, -5.4, 0.75}, {0, 1, 0}, 0.8, 0.5, 0.13, paint, 8);
    for (const double side : {1.0, -1.0})
        addSlab(writer, {0.1 * side, -4.2, 1.36}, {1.05 * side, -4.3, 1.36}, {0, 1, 0}, 0.52, 0.4,
                0.13, paint, 12);
    writer.object("Tail_Rotor");
    addEllipsoid(writer, {-0.26, -5.45, 1.95}, {0.14, 0.09, 0.09}, hub, 10, 16);
    for (int i = 0; i < 2; ++i) {
        const double angle = 0.6 + pi * i;
        const Vec3 out{0.0, std::cos(angle), std::sin(angle)};
        addSlab(writer, Vec3{-0.32, -5.45, 1.95} + out * 0.08, Vec3{-0.32, -5.45, 1.95} + out * 0.8,
                {0.0, -std::sin(angle), std::cos(angle)}, 0.16, 0.13, 0.12, blade, 8);
    }
}

void addRotor(GltfWriter& writer) {
    writer.object("Main_Rotor");
    const Vec3 top{0.0, 1.05, 2.72};
    addTube(writer, {Vec3{0.0, 1.05, 2.1}, Vec3{0.0, 1.05, 2.3}, Vec3{0.0, 1.05, 2.5}, top}, 0.09,
            0.07, hub, 6, 20);
    addEllipsoid(writer, top, {0.22, 0.22, 0.12}, hub, 12, 20);
    for (int i = 0; i < 4; ++i) {
        const double angle = pi / 7 + 0.5 * pi * i;
        const Vec3 out{std::cos(angle), std::sin(angle), 0.02};
        addSlab(writer, top + out * 0.18, top + out * 4.9, {-std::sin(angle), std::cos(angle), 0.0},
                0.27, 0.25, 0.11, blade, 24);
    }
}

void addSkids(GltfWriter& writer) {
    writer.object("Landing_Gear");
    for (const double side : {1.0, -1.0}) {
        const double x = 0.98 * side;
        addTube(
            writer,
            {Vec3{x, 3.6, -0.22}, Vec3{x, 3.0, -0.46}, Vec3{x, 1.0, -0.45}, Vec3{x, -0.1, -0.45}},
            0.045, 0.045, skid, 24, 14);
        for (const double y : {2.5, 0.6})
            addTube(writer,
                    {Vec3{0.3 * side, y, 0.22}, Vec3{0.6 * side, y, 0.05},
                     Vec3{0.85 * side, y, -0.1}, Vec3{x, y, -0.44}},
                    0.04, 0.035, skid, 14, 14);
        addEllipsoid(writer, {x, -0.1, -0.45}, {0.06, 0.08, 0.06}, tyre, 8, 12);
    }
}

} // namespace

GltfWriter helicopterModel() {
    GltfWriter writer("smat-samples", 0.01);
    addCabin(writer);
    addTail(writer);
    addRotor(writer);
    addSkids(writer);
    return writer;
}

} // namespace smat
