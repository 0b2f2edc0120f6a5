// The wing and the tail of the sample aircraft.
#include <cmath>
#include <numbers>
#include <vector>

#include "tools/samples/HeronParts.h"
#include "tools/samples/HeronSurfaces.h"
#include "tools/samples/LiftingSurface.h"
#include "tools/samples/Patch.h"

namespace smat::heron {
namespace {

using irsg::Vec3;

constexpr double halfSpan_m = 13.5;

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
    addLiftingSurface(
        writer, {0.0, halfSpan_m, starboardWing, 0.72, wingFlaps, wingSurface, 0.45, false, &cove});
    addLiftingSurface(writer,
                      {0.0, halfSpan_m, portWing, 0.72, wingFlaps, wingSurface, 0.45, true, &cove});
    const std::vector<Flap> elevators{{0.45, 4.0}};
    addLiftingSurface(
        writer, {0.0, 4.3, starboardTailplane, 0.66, elevators, tailSurface, 0.4, false, &cove});
    addLiftingSurface(writer,
                      {0.0, 4.3, portTailplane, 0.66, elevators, tailSurface, 0.4, true, &cove});
    addLiftingSurface(writer, {0.0, 1.0, fin, 0.66, {{0.16, 0.93}}, tailSurface, 0.1, true, &cove});
    addLiftingSurface(writer, {0.0, 1.0, dorsalFin, 0.72, {}, tailSurface, 0.12, true, &cove});
    // Where fin and tailplane meet.
    addEllipsoid(writer, {0.0, -9.75, 5.12}, {0.24, 1.45, 0.24}, tail, 14, 16);
}

} // namespace smat::heron
