#pragma once

#include <cmath>
#include <vector>

#include "irsg/radiometry/Units.h"
#include "irsg/scattering/PhaseFunction.h"

namespace irsg::test {

/// exp(-t / w): as good as all light stays near its direction where w is small.
inline PhaseFunction narrow(double width_rad) {
    std::vector<double> angles, values;
    for (int i = 0; i <= 8000; ++i) {
        angles.push_back(pi * i / 8000.0);
        values.push_back(std::exp(-angles.back() / width_rad));
    }
    return {angles, values};
}

} // namespace irsg::test
