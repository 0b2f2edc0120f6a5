#pragma once

#include <cmath>
#include <vector>

#include "irsg/scattering/MtfDatabase.h"

namespace irsg {

/// Two curves of four points each: exp(tau q) with q falling from 0.9 to 0.
inline MtfDatabase smallDatabase() {
    const std::vector<double> q{0.9, 0.6, 0.2, 0.0};
    std::vector<std::vector<double>> values;
    for (const double depth : {1.0, 2.0}) {
        values.emplace_back();
        for (const double one : q) {
            values.back().push_back(std::exp(depth * one));
        }
    }
    return {{1.0, 1.0, 100e-6, 299792458.0 / 4e-6}, {0.0, 1.0, 10.0, 100.0}, {1.0, 2.0}, values};
}

} // namespace irsg
