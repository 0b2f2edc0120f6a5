#include <cmath>
#include <memory>

#include "benchmarks/atmosphere/Table.h"
#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Units.h"

namespace irsg::accuracy {

namespace {

constexpr double altitudes_m[] = {0.0, 3e3, 1e4};

double direct_W_m2(const AtmosphereSmart& air, const SpectralSampling& nodes, double altitude_m,
                   double elevation_rad) {
    return nodes.integrate(
        air.provide(AtmosphericQuery::solarIrradiance(altitude_m, {0.0, elevation_rad}), nodes));
}

} // namespace

/// The direct sun while it sets, at three altitudes.
void sunTables(const Output& output) {
    AtmosphereSmartParameters parameters;
    parameters.atmosphereModel = 6;
    parameters.irradianceMode = 2;
    const AtmosphereSmart air(parameters);
    const Band band = Band::topHat(3.5, 4.1);
    const auto nodes = air.nodesOf({band});

    Table table("The sun sets: true elevation of its middle on the horizon, and the largest change "
                "of the direct sun of 3.5-4.1 µm over 2e-6 rad between -4 and 1 degrees, in terms "
                "of its greatest value there",
                {"altitude", "on the horizon", "sun at 1°, W m⁻²", "largest change"});
    std::vector<Curve> curves{{"true elevation [deg]", {}}};
    for (double deg = -4.0; deg <= 1.0001; deg += 0.01)
        curves.front().values.push_back(deg);
    for (const double altitude_m : altitudes_m) {
        Curve curve{"direct sun at " + text("%.0f", altitude_m) + " m [W m-2]", {}};
        double change = 0.0;
        for (const double deg : curves.front().values) {
            curve.values.push_back(direct_W_m2(air, *nodes, altitude_m, radians(deg)));
            change = std::max(change,
                              std::abs(direct_W_m2(air, *nodes, altitude_m, radians(deg) + 1e-6) -
                                       direct_W_m2(air, *nodes, altitude_m, radians(deg) - 1e-6)));
        }
        const double greatest = curve.values.back();
        table.add(
            {text("%.0f km", 1e-3 * altitude_m),
             text("%.3f°", degrees(air.transfer().tracer().trueHorizonElevation_rad(altitude_m))),
             text("%.3f", greatest), text("%.1e", change / greatest)});
        curves.push_back(std::move(curve));
    }
    table.print();
    writeCurves(output, "sunset", "direct sun of 3.5-4.1 um [W m-2] over its true elevation",
                curves);
}

} // namespace irsg::accuracy
