#pragma once

#include <string>
#include <vector>

namespace irsg {

/// How many droplets there are of each radius.
struct SizeDistribution {
    enum class Kind {
        single,   ///< all of one radius
        gamma,    ///< n(r) ~ r^width exp(-width r / radius): modified gamma with its mode at radius
        logNormal ///< median radius, geometric standard deviation `width`
    };
    Kind kind = Kind::single;
    double radius_um = 50.0; ///< > 0
    double width = 1.0;      ///< gamma: > 0; log-normal: 1.01 to 10; else without effect

    static SizeDistribution single(double radius_um) { return {Kind::single, radius_um, 1.0}; }
    /// Heavy advection fog of E. P. Shettle and R. W. Fenn 1979, AFGL-TR-79-0214: width 3, mode
    /// 10 um.
    static SizeDistribution advectionFog() { return {Kind::gamma, 10.0, 3.0}; }
    /// Moderate radiation fog of the same source: width 6, mode 2 um.
    static SizeDistribution radiationFog() { return {Kind::gamma, 2.0, 6.0}; }

    /// "gamma, mode 10 um, width 3".
    std::string description() const;

    /// Radii and how many droplets each stands for; the numbers sum to 1. Gauss-Legendre in ln r
    /// over all radii that matter for the shadow: what is left out is below 1e-7 of it.
    struct Nodes {
        std::vector<double> radii_um, numbers;
    };
    /// Throws InputError for parameters out of range.
    Nodes nodes() const;
    /// Diameter of a droplet of mean shadow, sqrt(<D^2>), um.
    double meanDiameter_um() const;
};

} // namespace irsg
