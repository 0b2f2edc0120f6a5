// The wing and the tail of the sample jet.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/samples/LiftingSurface.h"
#include "tools/samples/Patch.h"
#include "tools/samples/TernParts.h"

namespace smat::tern {
namespace {

constexpr double halfSpan_m = 5.1;
constexpr double strakeTo_m = 1.5; ///< of the half span

/// Stations of both edges of the wing, over the span: a curved strake, then a straight wing.
const Curve strakeEdge{{0.35, 4.0}, {0.62, 4.55}, {0.85, 5.3}, {1.1, 6.2}, {1.3, 6.9}, {1.5, 7.5}};

double leadingEdge(double span) {
    constexpr double sweep = 0.84; // the tangent of 40 degrees
    return span < strakeTo_m ? strakeEdge(span)
                             : strakeEdge(strakeTo_m) + sweep * (span - strakeTo_m);
}
double trailingEdge(double span) {
    return 12.1 - 0.09 * span;
}

Section wing(double side, double span) {
    const double round = endRound(span, halfSpan_m, 0.18);
    const double front = leadingEdge(span), chord = trailingEdge(span) - front;
    constexpr double dihedral = -0.04, height_m = 0.16;
    const double part = std::clamp((span - 0.9) / (strakeTo_m - 0.9), 0.0, 1.0);
    return {{side * span, nose_m - front - 0.3 * chord * (1.0 - round), height_m + dihedral * span},
            chord * (0.4 + 0.6 * round),
            std::lerp(0.03, 0.045 - 0.008 * span / halfSpan_m, part) * round,
            0.006 * part,
            {0, 0, 1}};
}
Section starboardWing(double span) {
    return wing(1.0, span);
}
Section portWing(double span) {
    return wing(-1.0, span);
}
const FlightSurface* wingSurface(double span, double chord, bool above) {
    if (chord < (span < strakeTo_m ? 0.02 : 0.04))
        return &edge;
    return above ? &skin : &belly;
}

/// A fin that leans outwards.
Section fin(double side, double span) {
    constexpr double lean = 18.0 * std::numbers::pi / 180.0, height_m = 2.25;
    const double round = endRound(span, 1.0, 0.05);
    const double chord = (3.0 - 1.75 * span) * (0.55 + 0.45 * round);
    return {{side * (1.0 + height_m * std::sin(lean) * span), nose_m - 10.0 - 2.15 * span,
             0.32 + height_m * std::cos(lean) * span},
            chord,
            0.045 * round,
            0.0,
            {std::cos(lean), 0, -side * std::sin(lean)}};
}
Section starboardFin(double span) {
    return fin(1.0, span);
}
Section portFin(double span) {
    return fin(-1.0, span);
}

Section tailplane(double side, double span) {
    constexpr double tip_m = 2.95;
    const double round = endRound(span, tip_m, 0.12);
    const double chord = (2.5 - 0.72 * (span - 1.1)) * (0.5 + 0.5 * round);
    return {{side * span, nose_m - 12.35 - 0.85 * (span - 1.1), -0.05 - 0.03 * (span - 1.1)},
            chord,
            0.042 * round,
            0.0,
            {0, 0, 1}};
}
Section starboardTailplane(double span) {
    return tailplane(1.0, span);
}
Section portTailplane(double span) {
    return tailplane(-1.0, span);
}
const FlightSurface* tailSurface(double /*span*/, double chord, bool /*above*/) {
    return chord < 0.03 ? &edge : &tail;
}

} // namespace

void addWings(FlightWriter& writer) {
    const std::vector<Flap> flaps{{1.55, 3.3}, {3.36, 4.75}};
    for (const bool isPort : {false, true}) {
        const auto& section = isPort ? portWing : starboardWing;
        // Finely where it leaves the body.
        addLiftingSurface(writer,
                          {0.35, strakeTo_m, section, 0.78, {}, wingSurface, 0.05, isPort, &cove});
        addLiftingSurface(writer, {strakeTo_m, halfSpan_m, section, 0.78, flaps, wingSurface, 0.18,
                                   isPort, &cove});
    }
    const std::vector<Flap> rudder{{0.22, 0.86}};
    addLiftingSurface(writer,
                      {0.0, 1.0, starboardFin, 0.72, rudder, tailSurface, 0.08, true, &cove});
    addLiftingSurface(writer, {0.0, 1.0, portFin, 0.72, rudder, tailSurface, 0.08, true, &cove});
    addLiftingSurface(writer,
                      {0.95, 2.95, starboardTailplane, 0.72, {}, tailSurface, 0.16, false, &cove});
    addLiftingSurface(writer,
                      {0.95, 2.95, portTailplane, 0.72, {}, tailSurface, 0.16, true, &cove});
    // Rails at the tips.
    for (const double side : {1.0, -1.0})
        addEllipsoid(writer, {side * halfSpan_m, nose_m - 11.0, 0.16 - 0.04 * halfSpan_m},
                     {0.055, 1.15, 0.055}, edge, 16, 12);
}

} // namespace smat::tern
