#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "irsg/gas/PlumeField.h"

namespace smat::test {

/// Gas of a place, from the air's 288 K on.
template <typename PartOf>
irsg::PlumeField fieldOfPart(const irsg::PlumeField::Axes& axes_m, double hottest_K,
                             const PartOf& partOf) {
    std::vector<irsg::PlumeField::Node> nodes;
    for (const double x_m : axes_m[0]) {
        for (const double y_m : axes_m[1]) {
            for (const double z_m : axes_m[2]) {
                const double part = partOf(x_m, y_m, z_m);
                irsg::GasLayer gas;
                gas.temperature_K = 288.0 + (hottest_K - 288.0) * part;
                gas.fraction(irsg::HotGas::CO2) = 0.04 * part;
                gas.fraction(irsg::HotGas::H2O) = 0.04 * part;
                nodes.push_back(irsg::PlumeField::Node::of(gas));
            }
        }
    }
    return irsg::PlumeField::ofNodes(axes_m, std::move(nodes));
}

/// So many planes, evenly.
inline std::vector<double> planes(double from_m, double to_m, std::size_t count) {
    std::vector<double> all_m;
    for (std::size_t i = 0; i < count; ++i) {
        all_m.push_back(
            std::lerp(from_m, to_m, static_cast<double>(i) / static_cast<double>(count - 1)));
    }
    return all_m;
}

/// The same from 0 on, closer there.
inline std::vector<double> planesFromZero(double to_m, std::size_t count) {
    std::vector<double> all_m;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count - 1);
        all_m.push_back(to_m * t * std::lerp(0.25, 1.0, t));
    }
    return all_m;
}
/// So many on each side of 0 and there, closer there.
inline std::vector<double> planesAboutZero(double to_m, std::size_t each) {
    std::vector<double> all_m;
    for (const double from_m : planesFromZero(to_m, each + 1)) {
        all_m.insert(all_m.begin(), -from_m);
        all_m.push_back(from_m);
    }
    all_m.erase(all_m.begin() + static_cast<std::ptrdiff_t>(each)); // 0 twice
    return all_m;
}

/// Exhaust in air about the x axis: 1 in a core, then falling along it, bell-shaped across, wider
/// in z than in y by `flat`.
inline double jetPart(double x_m, double y_m, double z_m, double flat = 1.0) {
    const double width_m = 0.12 + 0.09 * x_m;
    const double axis = std::min(1.0, 0.58 / std::max(x_m, 1e-6));
    const double square = (y_m * y_m * flat + z_m * z_m / flat) / (width_m * width_m);
    return axis * std::exp(-square);
}

} // namespace smat::test
