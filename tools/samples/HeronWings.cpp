// The wing and the tail of the sample aircraft.
#include <array>
#include <cmath>
#include <numbers>

#include "tools/samples/HeronParts.h"
#include "tools/samples/HeronSurfaces.h"
#include "tools/samples/Patch.h"

namespace smat::heron {
namespace {

using irsg::Vec3;

/// One section of a lifting surface: its nose, its chord backwards, and where its back is.
struct Section {
    Vec3 nose;
    double chord;
    double thickness; ///< of the chord
    double camber;
    Vec3 up;
};

/// A control surface along the span, behind a gap.
struct Flap {
    double from, to;
};

struct LiftingSurface {
    double root, tip; ///< of the parameter along the span
    Section (*section)(double span);
    double hinge; ///< part of the chord that is fixed
    std::vector<Flap> flaps;
    /// The kinds of surface by place along span and chord, above and below.
    const FlightSurface* (*surfaceAt)(double span, double chord, bool above);
    double step;
    bool mirrored; ///< drawn for the port side: turns what is in front
};

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
        [&](double span, double) { return isFixed(surface, span) ? nullptr : &cove; });
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
                edges(0.5, 1.0, 0.5), sectionEdges(7), [](double, double) { return &cove; });
        }
    }
}

constexpr double halfSpan_m = 13.5;

/// Towards the end of a surface its chord goes round.
double endRound(double span, double tip, double over) {
    const double left = std::max(0.0, (tip - span) / over);
    return left >= 1.0 ? 1.0 : std::sqrt(std::max(1e-6, 1.0 - (1.0 - left) * (1.0 - left)));
}

Section wing(double side, double span) {
    const double chord = (span < 4.4 ? 2.75 : 2.75 - (span - 4.4) * (2.75 - 1.5) / 9.1) *
                         (0.35 + 0.65 * endRound(span, halfSpan_m, 0.5));
    const double quarter_m = 1.55;
    const double rise = span < 4.4 ? 0.0 : (span - 4.4) * std::tan(2.5 * std::numbers::pi / 180.0);
    return {{side * span, quarter_m + 0.25 * chord, wingHeight_m - 0.05 + rise},
            chord,
            (0.18 - 0.05 * span / halfSpan_m) * endRound(span, halfSpan_m, 0.5),
            0.02,
            {0, 0, 1}};
}
Section starboardWing(double span) {
    return wing(1.0, span);
}
Section portWing(double span) {
    return wing(-1.0, span);
}
const FlightSurface* wingSurface(double span, double chord, bool above) {
    const bool behindEngine = std::abs(span - engine_m) < 0.55;
    if (chord < 0.055 && !behindEngine)
        return &boot;
    if (span > 5.0 && span < 10.0 && chord > 0.16 && chord < 0.62)
        return above ? &tankTop : &tank;
    return above ? &skin : &belly;
}

Section fin(double span) {
    const double round = endRound(span, 1.0, 0.04);
    const double chord = 3.9 - 1.7 * span;
    return {{0.0, -7.4 - 1.75 * span, 1.05 + 4.15 * span},
            chord,
            0.12 * (0.5 + 0.5 * round),
            0.0,
            {1, 0, 0}};
}
Section dorsalFin(double span) {
    const double chord = 6.4 * (1.0 - span) + 0.8;
    return {{0.0, -3.6 - 4.2 * span, 1.30 + 1.25 * span}, chord, 0.035, 0.0, {1, 0, 0}};
}
Section tailplane(double side, double span) {
    const double round = endRound(span, 4.3, 0.25);
    const double chord = (2.05 - 0.21 * span) * (0.4 + 0.6 * round);
    return {{side * span, -8.95 - 0.12 * span, 5.12}, chord, 0.11 * round, 0.0, {0, 0, 1}};
}
Section starboardTailplane(double span) {
    return tailplane(1.0, span);
}
Section portTailplane(double span) {
    return tailplane(-1.0, span);
}
const FlightSurface* tailSurface(double /*span*/, double chord, bool /*above*/) {
    return chord < 0.05 ? &boot : &tail;
}

} // namespace

void addWings(FlightWriter& writer) {
    const std::vector<Flap> wingFlaps{{1.35, 3.55}, {4.75, 8.6}, {8.75, 12.7}};
    addLiftingSurface(writer,
                      {0.0, halfSpan_m, starboardWing, 0.72, wingFlaps, wingSurface, 0.45, false});
    addLiftingSurface(writer,
                      {0.0, halfSpan_m, portWing, 0.72, wingFlaps, wingSurface, 0.45, true});
    const std::vector<Flap> elevators{{0.45, 4.0}};
    addLiftingSurface(writer,
                      {0.0, 4.3, starboardTailplane, 0.66, elevators, tailSurface, 0.4, false});
    addLiftingSurface(writer, {0.0, 4.3, portTailplane, 0.66, elevators, tailSurface, 0.4, true});
    addLiftingSurface(writer, {0.0, 1.0, fin, 0.66, {{0.16, 0.93}}, tailSurface, 0.1, true});
    addLiftingSurface(writer, {0.0, 1.0, dorsalFin, 0.72, {}, tailSurface, 0.12, true});
    // Where fin and tailplane meet.
    addEllipsoid(writer, {0.0, -9.75, 5.12}, {0.24, 1.45, 0.24}, tail, 14, 16);
}

} // namespace smat::heron
