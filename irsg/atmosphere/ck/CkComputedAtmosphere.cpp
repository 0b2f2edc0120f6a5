#include <cmath>

#include "irsg/atmosphere/ck/CkTraining.h"
#include "irsg/core/Errors.h"

namespace irsg {

namespace {

/// Paths between altitudes and over ranges that scenes have.
std::vector<AtmosphericPath> spreadOfPaths(double top_m) {
    struct Ends {
        double sensor_m, target_m;
    };
    std::vector<AtmosphericPath> paths;
    for (const Ends& ends :
         {Ends{5, 5}, Ends{5, 500}, Ends{5, 3000}, Ends{1500, 0}, Ends{1500, 1500},
          Ends{3000, 3000}, Ends{6000, 1000}, Ends{3000, 10000}, Ends{6000, 6000},
          Ends{10000, 10000}, Ends{12000, 0}, Ends{15000, 8000}, Ends{20000, 12000}})
        for (const double range_m : {10.0, 60.0, 500.0, 2e3, 6e3, 13e3, 30e3, 65e3, 150e3}) {
            const double climb_m = std::abs(ends.sensor_m - ends.target_m);
            const bool low = ends.sensor_m < 1000.0 && ends.target_m < 1000.0;
            if (range_m < 1.05 * climb_m || (low && range_m > 30e3) ||
                std::max(ends.sensor_m, ends.target_m) > top_m)
                continue;
            paths.push_back({ends.sensor_m, ends.target_m, range_m});
        }
    return paths;
}

/// Every so many of some.
template <typename Element>
std::vector<Element> oneIn(std::size_t many, const std::vector<Element>& all) {
    std::vector<Element> some;
    for (std::size_t i = many / 2; i < all.size(); i += many)
        some.push_back(all[i]);
    return some;
}

/// Paths between those of the training in range and altitude.
std::vector<AtmosphericPath> pathsHeldOut(double top_m) {
    struct Ends {
        double sensor_m, target_m;
    };
    std::vector<AtmosphericPath> paths;
    for (const Ends& ends : {Ends{20, 20}, Ends{10, 1200}, Ends{2200, 2200}, Ends{5000, 2000},
                             Ends{8000, 7700}, Ends{11000, 300}, Ends{15000, 9000}})
        for (const double range_m : {11.0, 70.0, 800.0, 2.7e3, 7.5e3, 16e3, 36e3, 100e3}) {
            const double climb_m = std::abs(ends.sensor_m - ends.target_m);
            const bool low = ends.sensor_m < 1000.0 && ends.target_m < 1000.0;
            if (range_m >= 1.05 * climb_m && (!low || range_m < 30e3) &&
                std::max(ends.sensor_m, ends.target_m) <= top_m)
                paths.push_back({ends.sensor_m, ends.target_m, range_m});
        }
    return paths;
}

std::vector<LineOfSight> spreadOfSights() {
    std::vector<LineOfSight> sights;
    for (const double altitude_m : {2.0, 3000.0, 10000.0})
        for (const double elevation_rad : {-0.5, -0.1, 0.02, 0.1, 0.5, 1.5})
            sights.push_back({altitude_m, elevation_rad, 0.0});
    return sights;
}

std::vector<double> valuesOf(const RadiativeTransfer& transfer, const NodeSet& set,
                             const AtmosphericQuery& query) {
    const auto& [quantity, path, sight, altitude_m, sun] = query;
    const bool hasFluxes = transfer.air().scattering == ScatteringMode::twoStream;
    switch (quantity) {
    case AtmosphereProperty::transmittance:
        return transfer.transmittance(set, path);
    case AtmosphereProperty::pathRadiance:
        return transfer.pathRadiance(set, path, sun);
    case AtmosphereProperty::backgroundRadiance:
        return transfer.backgroundRadiance(set, sight, sun);
    case AtmosphereProperty::solarIrradiance:
        return transfer.solarIrradiance(set, altitude_m, sun);
    case AtmosphereProperty::upwardFlux:
        return hasFluxes ? transfer.upwardFlux(set, altitude_m, sun) : std::vector<double>();
    case AtmosphereProperty::downwardFlux:
        return hasFluxes ? transfer.downwardFlux(set, altitude_m, sun) : std::vector<double>();
    default:
        throw LogicError("quadrature points were to be trained on another quantity");
    }
}

} // namespace

CkAtmosphere ckAtmosphereOf(const RadiativeTransfer& transfer, const Band& band) {
    const double top_m = transfer.air().profile.top_m();
    const std::vector<AtmosphericPath> spread = spreadOfPaths(top_m);
    CkAtmosphere air{.nodes = CkNodes(transfer, band),
                     .values = {},
                     .ambient_K = transfer.air().profile.at(0.0).temperature_K,
                     .paths = oneIn(10, spread),
                     .sights = oneIn(5, spreadOfSights()),
                     .shades = spread,
                     .heldOut = oneIn(2, pathsHeldOut(top_m))};
    air.values = [&transfer, set = air.nodes.set](const AtmosphericQuery& query) {
        return valuesOf(transfer, set, query);
    };
    return air;
}

} // namespace irsg
