#include "tools/samples/LiftingSurface.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "tools/samples/Patch.h"

namespace smat {
namespace {

using irsg::Vec3;

/// Half the thickness of a NACA four-digit section with a closed end, parts of the chord.
double halfThickness(double x, double thickness) {
    return 5.0 * thickness *
           (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
            0.1036 * x * x * x * x);
}

double camberLine(double x, double camber) {
    constexpr double highest = 0.4;
    return x < highest ? camber / (highest * highest) * (2.0 * highest * x - x * x)
                       : camber / ((1.0 - highest) * (1.0 - highest)) *
                             (1.0 - 2.0 * highest + 2.0 * highest * x - x * x);
}

/// `around` from -1 (the end below) over 0 (the nose) to 1 (the end above).
Vec3 onSection(const Section& at, double around, double last) {
    const double x = last * around * around;
    const double y =
        camberLine(x, at.camber) + std::copysign(halfThickness(x, at.thickness), around);
    return at.nose + Vec3{0.0, -x * at.chord, 0.0} + at.up * (y * at.chord);
}

/// A control surface: a section of its own, as thick as the gap, a little lower.
Vec3 onFlap(const Section& at, double around, double hinge) {
    const double first = hinge + 0.018;
    const double x = around * around;
    const double whole = first + (1.0 - first) * x;
    const double limit = halfThickness(first, at.thickness);
    const double round = std::sqrt(
        std::max(0.0, 1.0 - (1.0 - std::min(1.0, x / 0.18)) * (1.0 - std::min(1.0, x / 0.18))));
    const double half =
        std::min(halfThickness(whole, at.thickness), 0.92 * limit) * (x < 0.18 ? round : 1.0);
    const double y = camberLine(whole, at.camber) + std::copysign(half, around);
    return at.nose + Vec3{0.0, -whole * at.chord, 0.0} + at.up * (y * at.chord);
}

std::vector<double> sectionEdges(int cells) {
    // Evenly in the root of the chord: closer at the nose.
    return edges(-1.0, 1.0, 1.0 / cells);
}

void put(FlightWriter& writer, bool mirrored, const Shape& shape, std::span<const double> us,
         std::span<const double> vs, const SurfaceAt& surfaceAt) {
    if (!mirrored)
        addPatch(
            writer, [&](double v, double u) { return shape(u, v); }, vs, us,
            [&](double v, double u) { return surfaceAt(u, v); });
    else
        addPatch(writer, shape, us, vs, surfaceAt);
}

/// Whether the chord is whole at this place of the span.
bool isFixed(const LiftingSurface& surface, double span) {
    for (const Flap& flap : surface.flaps)
        if (span > flap.from && span < flap.to)
            return false;
    return true;
}

} // namespace

void addLiftingSurface(FlightWriter& writer, const LiftingSurface& surface) {
    std::vector<double> marks;
    for (const Flap& flap : surface.flaps)
        marks.insert(marks.end(), {flap.from, flap.to});
    const auto spans = edges(surface.root, surface.tip, surface.step, marks);
    const auto around = sectionEdges(14);

    // What is fixed before the hinge, what is fixed behind it, and the walls of the gap.
    put(
        writer, surface.mirrored,
        [&](double span, double v) { return onSection(surface.section(span), v, surface.hinge); },
        spans, around,
        [&](double span, double v) {
            return surface.surfaceAt(span, surface.hinge * v * v, v > 0.0);
        });
    const auto behind = edges(surface.hinge, 1.0, 0.08);
    for (const double side : {1.0, -1.0}) {
        put(
            writer, surface.mirrored == (side > 0.0),
            [&](double span, double x) {
                return onSection(surface.section(span), side * std::sqrt(x), 1.0);
            },
            spans, behind,
            [&](double span, double x) {
                return isFixed(surface, span) ? surface.surfaceAt(span, x, side > 0.0) : nullptr;
            });
    }
    put(
        writer, surface.mirrored,
        [&](double span, double v) {
            const Section at = surface.section(span);
            return onSection(at, 1.0, surface.hinge) * (0.5 * (1.0 - v)) +
                   onSection(at, -1.0, surface.hinge) * (0.5 * (1.0 + v));
        },
        spans, edges(-1.0, 1.0, 1.0),
        [&](double span, double) { return isFixed(surface, span) ? nullptr : surface.gap; });
    for (const Flap& flap : surface.flaps) {
        // The gaps at its ends as well.
        const auto along = edges(flap.from + 0.03, flap.to - 0.03, surface.step);
        put(
            writer, surface.mirrored,
            [&](double span, double v) { return onFlap(surface.section(span), v, surface.hinge); },
            along, sectionEdges(7),
            [&](double span, double v) {
                return surface.surfaceAt(span, surface.hinge + (1.0 - surface.hinge) * v * v,
                                         v > 0.0);
            });
        for (const double end : {along.front(), along.back()}) {
            put(
                writer, surface.mirrored == (end == along.front()),
                [&](double u, double v) {
                    const Section at = surface.section(end);
                    return onFlap(at, v, surface.hinge) * u +
                           onFlap(at, -v, surface.hinge) * (1.0 - u);
                },
                edges(0.5, 1.0, 0.5), sectionEdges(7), [&](double, double) { return surface.gap; });
        }
    }
}

double endRound(double span, double tip, double over) {
    const double left = std::max(0.0, (tip - span) / over);
    return left >= 1.0 ? 1.0 : std::sqrt(std::max(1e-6, 1.0 - (1.0 - left) * (1.0 - left)));
}

} // namespace smat
