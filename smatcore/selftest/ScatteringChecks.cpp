#include <cmath>
#include <memory>
#include <numbers>

#include "irsg/scattering/Mie.h"
#include "irsg/scattering/MtfFilter.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

/// MTF(f) = 1 + gain exp(-f / width): its haze in closed form is the solid angle under which a
/// pixel is seen from the distance 1 / (2 pi width).
constexpr double gain = 1.5, width_per_rad = 30.0, pitch_rad = 1e-3;

std::shared_ptr<const irsg::PixelHaze> exponentialHaze() {
    std::vector<double> frequencies{0.0}, values{1.0 + gain};
    for (int i = 0; i < 400; ++i) {
        const double f = 1e-4 * width_per_rad * std::pow(4e5, i / 399.0);
        frequencies.push_back(f);
        values.push_back(i == 399 ? 1.0 : 1.0 + gain * std::exp(-f / width_per_rad));
    }
    return std::make_shared<const irsg::PixelHaze>(
        irsg::HazeFunction(irsg::MtfCurve{frequencies, values}), pitch_rad, 20);
}

double pixelOfHaze(int x, int y) {
    const double c = 1.0 / (2.0 * std::numbers::pi * width_per_rad);
    const auto corner = [&](double u, double v) {
        return std::atan(u * v / (c * std::sqrt(c * c + u * u + v * v)));
    };
    const double l = (x - 0.5) * pitch_rad, r = (x + 0.5) * pitch_rad;
    const double t = (y - 0.5) * pitch_rad, b = (y + 0.5) * pitch_rad;
    return gain / (2.0 * std::numbers::pi) *
           (corner(r, b) - corner(l, b) - corner(r, t) + corner(l, t));
}

/// A picture through the transforms against the sum over its pixels.
SelfTestValue filtered(SelfTestBench&) {
    irsg::MtfFilter filter(exponentialHaze());
    const irsg::HazeWindow object{11, 13, 7, 5}, frame{0, 0, 45, 51};
    std::vector<float> values(object.size()), sums(frame.size(), 0.0F);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(0.1 + static_cast<double>((i * 7) % 11) / 11.0);
    filter.addHaze(object, values, frame, sums);
    Farthest farthest(absolute);
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            double right = 0.0;
            for (int v = 0; v < object.height; ++v)
                for (int u = 0; u < object.width; ++u)
                    right += static_cast<double>(
                                 values[static_cast<std::size_t>(v * object.width + u)]) *
                             filter.haze().at(x - object.x - u, y - object.y - v);
            farthest.add(static_cast<double>(sums[static_cast<std::size_t>(y * frame.width + x)]),
                         right);
        }
    return farthest.found();
}

} // namespace

std::vector<SelfTestCheck> scatteringChecks() {
    return {
        {"scattering.mie",
         "Extinction of a sphere of index 1.5 + i, size 100, as Wiscombe prints it (NCAR/TN-140)",
         "", 6e-7, absolute,
         [](auto&) {
             return SelfTestValue{irsg::MieSphere({1.5, 1.0}, 100.0).efficiencies().extinction,
                                  2.097502};
         }},
        {"scattering.haze-of-a-point",
         "Haze of a point at (5, 0), (3, 4), (10, 0) and (8, 6) pixels in closed form", "", 1e-3,
         relative,
         [](auto&) {
             const auto point = exponentialHaze();
             Farthest farthest;
             for (const auto& [x, y] :
                  {std::pair{5, 0}, std::pair{3, 4}, std::pair{10, 0}, std::pair{8, 6}})
                 farthest.add(point->at(x, y), pixelOfHaze(x, y));
             return farthest.found();
         }},
        {"scattering.energy",
         "Haze within the support and what the taper cuts against the gain of the MTF", "", 1e-4,
         relative,
         [](auto&) {
             return SelfTestValue{exponentialHaze()->energy() + exponentialHaze()->cut(), gain};
         }},
        {"scattering.transforms",
         "A window of 7 x 5 pixels by Fourier transforms against the direct sum", "", 1e-6,
         absolute, filtered},
    };
}

} // namespace smat::selftest
