#include "irsg/sensor/PupilTransfer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

double halfChord(double radius, double x) {
    return std::sqrt(std::max(0.0, (radius - x) * (radius + x)));
}

/// Height of the overlap at x from the middle between both centres, for x >= 0.
double overlapHeight(double obscuration, double halfShift, double x) {
    const double outer = halfChord(1.0, x + halfShift);
    const double inner = halfChord(obscuration, std::abs(x - halfShift));
    return 2.0 * std::max(0.0, outer - inner);
}

/// The integral of height(x) cos(k x) over a piece whose ends may have the slope of a root.
template <typename Height>
double pieceIntegral(double from, double to, double k, const Height& height) {
    const GaussRule& rule = gaussLegendre(20);
    const double width = to - from;
    const auto panels = static_cast<int>(std::ceil(1.0 + std::abs(k) * width / 8.0));
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel)
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = (panel + rule.nodes[i]) / panels;
            const double sine = std::sin(0.5 * pi * t);
            const double x = from + width * sine * sine;
            sum += rule.weights[i] / panels * 0.5 * pi * std::sin(pi * t) * width * height(x) *
                   std::cos(k * x);
        }
    return sum;
}

double roundTransfer(double obscuration, double waves, double shift) {
    if (shift >= 2.0)
        return 0.0;
    const double half = 0.5 * shift, end = 1.0 - half;
    if (obscuration == 0.0 && waves == 0.0) // Goodman's eq. 6-31
        return 2.0 / pi * (std::acos(half) - half * halfChord(1.0, half));
    std::vector<double> places{0.0, end};
    const auto add = [&](double x) {
        if (x > 0.0 && x < end)
            places.push_back(x);
    };
    if (obscuration > 0.0) {
        add(half - obscuration);
        add(half + obscuration);
        add(obscuration - half);
        if (shift > 0.0)
            add(0.5 * (1.0 - obscuration * obscuration) / shift); // the hole meets the rim
    }
    std::ranges::sort(places);
    const double k = 4.0 * pi * waves * shift;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
        sum += pieceIntegral(places[i], places[i + 1], k,
                             [&](double x) { return overlapHeight(obscuration, half, x); });
    return 2.0 * sum / (pi * (1.0 - obscuration * obscuration));
}

double sideTransfer(double waves, double shift) {
    const double overlap = 1.0 - 0.5 * std::abs(shift);
    if (overlap <= 0.0)
        return 0.0;
    const double phase = 4.0 * pi * waves * shift * overlap;
    return overlap * (std::abs(phase) < 1e-8 ? 1.0 : std::sin(phase) / phase);
}

} // namespace

double pupilTransfer(PupilShape shape, double obscuration, double waves, double shiftX,
                     double shiftY) {
    if (shape == PupilShape::square)
        return sideTransfer(waves, shiftX) * sideTransfer(waves, shiftY);
    return roundTransfer(obscuration, waves, std::hypot(shiftX, shiftY));
}

} // namespace irsg
