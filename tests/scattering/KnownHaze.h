#pragma once

#include <cmath>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/scattering/MtfDatabase.h"

namespace irsg {

/// MTF(f) = 1 + gain exp(-f / width), whose haze has closed forms: with c = 1 / (2 pi width) the
/// density is gain c / (2 pi (c^2 + t^2)^(3/2)), the solid angle of a plane at distance c.
struct KnownHaze {
    double width_per_rad, gain;

    MtfCurve curve(int points = 400) const {
        std::vector<double> frequencies{0.0}, values{1.0 + gain};
        const double lowest = 1e-4 * width_per_rad, highest = 40.0 * width_per_rad;
        for (int i = 0; i < points; ++i) {
            const double f = lowest * std::pow(highest / lowest, i / (points - 1.0));
            frequencies.push_back(f);
            values.push_back(i + 1 == points ? 1.0 : 1.0 + gain * std::exp(-f / width_per_rad));
        }
        return {frequencies, values};
    }
    double c() const { return 1.0 / (2.0 * pi * width_per_rad); }
    double density_sr(double t) const {
        return gain * c() / (2.0 * pi) * std::pow(c() * c() + t * t, -1.5);
    }
    double energyWithin(double t) const { return gain * (1.0 - c() / std::hypot(c(), t)); }
    /// Energy in a pixel at a displacement, without taper.
    double pixel(int x, int y, double pitch) const {
        const auto corner = [&](double u, double v) {
            return std::atan(u * v / (c() * std::sqrt(c() * c() + u * u + v * v)));
        };
        const double l = (x - 0.5) * pitch, r = (x + 0.5) * pitch;
        const double t = (y - 0.5) * pitch, b = (y + 0.5) * pitch;
        return gain / (2.0 * pi) * (corner(r, b) - corner(l, b) - corner(r, t) + corner(l, t));
    }
};

} // namespace irsg
