#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/import/Tape7.h"
#include "tests/atmosphere/SyntheticTape7.h"

/// Families of runs through an exponential atmosphere over a flat earth.
namespace irsg::tabulatedtest {

inline constexpr double nodes_per_cm[] = {2000.0, 2010.0, 2020.0, 2030.0, 2040.0};
inline constexpr double airTemperature_K = 280.0;

inline TabulatedAtmosphere family(const std::vector<SyntheticRun>& made) {
    std::string text;
    for (const SyntheticRun& run : made) {
        text += tape7(run);
    }
    return {parseTape7(TextLines::parse(text, "family")), "family"};
}

/// Absorption of an exponential atmosphere, m-1, stronger at larger wavenumbers.
inline double absorption_per_m(double altitude_m, double wavenumber_per_cm) {
    return 1e-4 * (wavenumber_per_cm - 1990.0) / 10.0 * std::exp(-altitude_m / 5000.0);
}

/// Optical depth of a straight path over a flat earth.
inline double depthOf(const AtmosphericPath& path, double wavenumber_per_cm) {
    const double rise = path.targetAltitude_m - path.sensorAltitude_m;
    if (rise == 0.0) {
        return absorption_per_m(path.sensorAltitude_m, wavenumber_per_cm) * path.range_m;
    }
    return 5000.0 *
           (absorption_per_m(path.sensorAltitude_m, wavenumber_per_cm) -
            absorption_per_m(path.targetAltitude_m, wavenumber_per_cm)) *
           path.range_m / rise;
}

inline SyntheticRun runOver(const AtmosphericPath& path) {
    SyntheticRun run;
    run.path = path.sensorAltitude_m == path.targetAltitude_m ? 1 : 2;
    run.h1_km = path.sensorAltitude_m / 1e3;
    run.h2_km = path.targetAltitude_m / 1e3;
    run.range_km = path.range_m / 1e3;
    run.zenith_deg = 60.0;
    run.temperature_K = airTemperature_K;
    run.depth = [path](double nu) { return depthOf(path, nu); };
    return run;
}

inline const InterpolationError& errorOf(const std::vector<InterpolationError>& errors,
                                         const std::string& quantity, const std::string& axis) {
    for (const InterpolationError& error : errors) {
        if (error.quantity == quantity && error.axis == axis) {
            return error;
        }
    }
    ADD_FAILURE() << "no error of " << quantity << " over " << axis;
    return errors.front();
}

} // namespace irsg::tabulatedtest
