#include "smatcore/tools/PathGeometry.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "irsg/atmosphere/path/Earth.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace smat {

namespace {

using irsg::earthRadius_m;

/// One line of sight on its way from what was said to what it means.
class Solver {
  public:
    explicit Solver(const PathGeometryInput& input) : input_(input) {}

    PathGeometry solve() {
        checkNumbers();
        checkCombination();
        finish();
        solvePath();
        finish();
        return result_;
    }

  private:
    void report(const char* what, std::string value, std::string expected) {
        diagnostics_.push_back({"geometry", what, std::move(value), std::move(expected)});
    }

    void checkNumber(const char* what, const std::optional<double>& value, double least,
                     double most, const char* expected) {
        if (value && !(*value >= least && *value <= most))
            report(what, irsg::numberText(*value), expected);
    }

    void checkNumbers() {
        const double largest = std::numeric_limits<double>::max();
        checkNumber("sensor altitude", input_.sensorAltitude_m, 0.0, largest,
                    "a finite altitude of at least 0 m: the ground");
        checkNumber("target altitude", input_.targetAltitude_m, 0.0, largest,
                    "a finite altitude of at least 0 m: the ground");
        checkNumber("range", input_.range_m, 0.0, largest, "a finite range of at least 0 m");
        checkNumber("elevation of the line of sight", input_.losElevation_deg, -90.0, 90.0,
                    "-90 to 90 deg");
        checkNumber("azimuth of the line of sight", input_.losAzimuth_deg, -360.0, 360.0,
                    "-360 to 360 deg");
    }

    void checkCombination() {
        if (!input_.toSpace)
            return;
        for (const auto& [what, value] : {std::pair{"range", input_.range_m},
                                          std::pair{"target altitude", input_.targetAltitude_m}}) {
            if (value) {
                report(what, irsg::numberText(*value) + " m with a path to space",
                       "one of them: a path to space has no target");
            }
        }
        for (const auto& [what, value] :
             {std::pair{"sensor altitude", input_.sensorAltitude_m},
              std::pair{"elevation of the line of sight", input_.losElevation_deg}}) {
            if (!value)
                report(what, "nothing", "a number: a path to space begins with it");
        }
        if (input_.sensorAltitude_m && *input_.sensorAltitude_m >= spaceAltitude_m) {
            report("sensor altitude", irsg::numberText(*input_.sensorAltitude_m) + " m",
                   "less than 100 km for a path to space; farther up give a range");
        }
    }

    void solvePath() {
        result_.targetAltitude_m = input_.targetAltitude_m;
        const auto& sensor_m = input_.sensorAltitude_m;
        if (!sensor_m)
            return;
        if (input_.losElevation_deg)
            sight(irsg::radians(*input_.losElevation_deg));
        if (input_.toSpace)
            pathToSpace();
        else if (input_.range_m && input_.targetAltitude_m)
            pathToAltitude(*input_.targetAltitude_m);
        else if (input_.range_m && input_.losElevation_deg)
            pathAlong(*input_.range_m);
    }

    void sight(double elevation_rad) {
        result_.sight = irsg::LineOfSight{*input_.sensorAltitude_m, elevation_rad,
                                          irsg::radians(input_.losAzimuth_deg)};
    }

    double sine() const {
        // Degrees that became radians may miss a right angle by a rounding.
        return std::clamp(std::sin(irsg::radians(*input_.losElevation_deg)), -1.0, 1.0);
    }

    /// r_s^2 - (R_earth + h)^2, without losing digits.
    double squaresAbove(double altitude_m) const {
        const double sensor_m = *input_.sensorAltitude_m;
        return (sensor_m - altitude_m) * (sensor_m + altitude_m + 2.0 * earthRadius_m);
    }

    /// How far it is to the ground, where the line of sight meets it.
    std::optional<double> groundRange_m() const {
        const double along = -(earthRadius_m + *input_.sensorAltitude_m) * sine();
        const double discriminant = along * along - squaresAbove(0.0);
        if (along <= 0.0 || discriminant < 0.0)
            return std::nullopt;
        // The nearer root d = along - sqrt(discriminant), as a quotient that keeps its digits.
        return squaresAbove(0.0) / (along + std::sqrt(discriminant));
    }

    double azimuth_rad() const { return irsg::radians(input_.losAzimuth_deg); }

    double altitudeAfter_m(double range_m) const {
        const double sensorRadius_m = earthRadius_m + *input_.sensorAltitude_m;
        const double rise = range_m * (range_m + 2.0 * sensorRadius_m * sine());
        const double targetRadius_m =
            std::sqrt(std::max(sensorRadius_m * sensorRadius_m + rise, 0.0));
        return *input_.sensorAltitude_m + rise / (targetRadius_m + sensorRadius_m);
    }

    void pathAlong(double range_m) {
        const std::optional<double> ground_m = groundRange_m();
        constexpr double rounding = 1.0 + 1e-9;
        if (ground_m && range_m > *ground_m * rounding) {
            report("range", irsg::numberText(range_m) + " m",
                   fmt::format("at most {:.6g} m: there the line of sight meets the ground",
                               *ground_m));
            return;
        }
        const double target_m = std::max(altitudeAfter_m(range_m), 0.0);
        result_.path =
            irsg::AtmosphericPath{*input_.sensorAltitude_m, target_m, range_m, azimuth_rad()};
        result_.targetAltitude_m = target_m;
    }

    void pathToAltitude(double target_m) {
        const double range_m = *input_.range_m;
        const double sensor_m = *input_.sensorAltitude_m;
        if (std::abs(target_m - sensor_m) > range_m * (1.0 + 1e-6)) {
            report("range", irsg::numberText(range_m) + " m",
                   "at least the difference of the altitudes, " +
                       irsg::numberText(std::abs(target_m - sensor_m)) + " m");
            return;
        }
        result_.path = irsg::AtmosphericPath{sensor_m, target_m, range_m, azimuth_rad()};
        if (!input_.losElevation_deg) {
            const double product = 2.0 * (earthRadius_m + sensor_m) * range_m;
            const double sine =
                product > 0.0 ? -(squaresAbove(target_m) + range_m * range_m) / product : 0.0;
            sight(std::asin(std::clamp(sine, -1.0, 1.0)));
            return;
        }
        const double slack_m = 0.1 + 1e-3 * range_m + range_m * range_m / (2.0 * earthRadius_m);
        const double seen_m = altitudeAfter_m(range_m);
        if (!(std::abs(seen_m - target_m) <= slack_m)) {
            report("elevation of the line of sight",
                   irsg::numberText(*input_.losElevation_deg) + " deg with a target altitude of " +
                       irsg::numberText(target_m) + " m",
                   fmt::format("one of them, or numbers that agree: that line of sight is at "
                               "{:.6g} m after {} m",
                               seen_m, irsg::numberText(range_m)));
        }
    }

    void pathToSpace() {
        if (groundRange_m()) {
            report("elevation of the line of sight",
                   irsg::numberText(*input_.losElevation_deg) + " deg",
                   "one that misses the ground on its way to space");
            return;
        }
        const double along = (earthRadius_m + *input_.sensorAltitude_m) * sine();
        const double range_m = -along + std::sqrt(along * along - squaresAbove(spaceAltitude_m));
        result_.path = irsg::AtmosphericPath{*input_.sensorAltitude_m, spaceAltitude_m, range_m,
                                             azimuth_rad()};
    }

    void finish() {
        if (!diagnostics_.empty())
            throw irsg::InputError(std::move(diagnostics_));
    }

    const PathGeometryInput& input_;
    PathGeometry result_;
    std::vector<irsg::Diagnostic> diagnostics_;
};

} // namespace

PathGeometry solveGeometry(const PathGeometryInput& input) {
    return Solver(input).solve();
}

} // namespace smat
