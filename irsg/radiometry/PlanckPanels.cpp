#include "irsg/radiometry/PlanckPanels.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

namespace irsg {

namespace {

constexpr double largestExponentStep = 4.0;
constexpr double largestWavelengthRatio = 1.5;
constexpr double resolvedExponents = 150.0;

/// The number of points for a change `spread` of ln L; seven linear factors are exact with four.
/// Where sampled spectra cut the band into thousands of intervals, three linear factors exact and
/// the rest smooth is enough: two points, with an error of spread^4 / 4320.
int pointsFor(double spread) {
    if (spread <= 0.01)
        return 2;
    if (spread <= 0.15)
        return 4;
    return spread <= 1.5 ? 6 : 8;
}

} // namespace

std::vector<PlanckPanel> planckPanels(const SpectralRange& range, double coldest_K) {
    if (!(coldest_K > 0.0))
        throw LogicError("Planck panels for a temperature of " + numberText(coldest_K) + " K");
    const double c2_T = secondRadiationConstant_um_K / coldest_K;
    const double smallestExponent = c2_T / range.max_um;

    std::vector<PlanckPanel> panels;
    double upper_um = range.max_um;
    while (upper_um > range.min_um) {
        // The next edge is where the exponent or the wavelength has changed as far as it may.
        const double exponent = c2_T / upper_um;
        const double step =
            largestExponentStep * std::max(1.0, (exponent - smallestExponent) / resolvedExponents);
        const double edge_um =
            std::max(c2_T / (exponent + step), upper_um / largestWavelengthRatio);

        // A rest of less than half a step joins this panel's successor by sharing the way evenly.
        double lower_um = std::max(edge_um, range.min_um);
        const double afterwards_um = edge_um - 0.5 * (upper_um - edge_um);
        if (lower_um > range.min_um && afterwards_um < range.min_um)
            lower_um = 0.5 * (upper_um + range.min_um);
        const double spread =
            std::max(c2_T / lower_um - exponent, 5.0 * std::log(upper_um / lower_um));
        panels.push_back({{lower_um, upper_um}, pointsFor(spread)});
        upper_um = lower_um;
    }
    return panels;
}

} // namespace irsg
