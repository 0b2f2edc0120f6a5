#include <cmath>
#include <memory>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SolarPosition.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using irsg::AtmosphereSmart;
using irsg::AtmosphericPath;
using irsg::SpectralRange;
using irsg::Spectrum;

constexpr SpectralRange mwir{3.0, 5.0};

/// Extinction that rises from 1e-5 to 1e-3 per metre over 3 to 5 um, air of 280 K.
irsg::BeerLambert haze() {
    irsg::BeerLambertParameters parameters;
    parameters.extinction_per_m = Spectrum({3.0, 5.0}, {1e-5, 1e-3});
    parameters.airTemperature_K = 280.0;
    parameters.groundTemperature_K = 300.0;
    return irsg::BeerLambert(parameters);
}
double hazeExtinction_per_m(double wavelength_um) {
    return 1e-5 + (1e-3 - 1e-5) * (wavelength_um - 3.0) / 2.0;
}

SelfTestValue along(const std::function<double(double)>& value,
                    const std::function<double(double)>& expected,
                    SelfTestCheck::Error error = relative) {
    Farthest farthest(error);
    for (int i = 0; i <= 97; ++i) {
        const double wavelength_um = 3.0 + 2.0 * i / 97.0;
        farthest.add(value(wavelength_um), expected(wavelength_um));
    }
    return farthest.found();
}

/// Air of 20 degrees with the report's defaults.
const AtmosphereSmart& realAtmosphere() {
    static const AtmosphereSmart air{irsg::AtmosphereSmartParameters{}};
    return air;
}

double integralOf(const Spectrum& spectrum, const SpectralRange& range) {
    const Spectrum* const one[] = {&spectrum};
    return irsg::integrateProduct(one, range);
}

} // namespace

std::vector<SelfTestCheck> atmosphereChecks() {
    return {
        {.name = "air.beer-lambert",
         .says = "Transmittance of 2.5 km of air whose extinction is linear in wavelength against "
                 "exp(-extinction range)",
         .unit = "",
         .bound = 2e-5,
         .measure =
             [](auto&) {
                 const Spectrum found = haze().transmittance({100.0, 100.0, 2500.0}, mwir);
                 return along(
                     [&](double um) { return found.at(um); },
                     [](double um) { return std::exp(-2500.0 * hazeExtinction_per_m(um)); });
             }},
        {.name = "air.path-radiance",
         .says = "Path radiance of the same air against (1 - transmittance) times a black body of "
                 "its temperature",
         .unit = "W m-2 sr-1 um-1",
         .bound = 5e-5,
         .measure =
             [](auto&) {
                 const Spectrum found = haze().pathRadiance({100.0, 100.0, 2500.0}, {}, mwir);
                 return along([&](double um) { return found.at(um); },
                              [](double um) {
                                  return -std::expm1(-2500.0 * hazeExtinction_per_m(um)) *
                                         truePlanck(um, 280.0);
                              });
             }},
        {.name = "air.ground-behind-air",
         .says = "Background 30 degrees below the horizontal: black ground of 300 K behind that "
                 "air, at h / sin(depression)",
         .unit = "W m-2 sr-1 um-1",
         .bound = 5e-5,
         .measure =
             [](auto&) {
                 const Spectrum found =
                     haze().backgroundRadiance({500.0, irsg::radians(-30.0), 0.0}, {}, mwir);
                 return along([&](double um) { return found.at(um); },
                              [](double um) {
                                  const double t = std::exp(-1000.0 * hazeExtinction_per_m(um));
                                  return t * truePlanck(um, 300.0) +
                                         (1.0 - t) * truePlanck(um, 280.0);
                              });
             }},
        {.name = "air.solar-constant",
         .says = "The sun of a vacuum, 0.2 to 40 um, against that part of 1361 W m-2 (IAU 2015 "
                 "resolution B3) by Planck's law at 5772 K",
         .unit = "W m-2",
         .bound = 4e-4,
         .measure =
             [](auto&) {
                 const SpectralRange all{0.2, 40.0};
                 const Spectrum sun =
                     irsg::Vacuum().solarIrradiance(0.0, {.elevation_rad = 1.0}, all);
                 const auto part =
                     static_cast<double>(irsg::reference::bandRadiance(all, 5772.0L) /
                                         irsg::reference::bandRadiance({0.01, 10000.0}, 5772.0L));
                 return SelfTestValue{integralOf(sun, all), 1361.0 * part};
             }},
        {.name = "air.sun-azimuth",
         .says = "Azimuth of the sun in the published example of NREL's algorithm (17 October "
                 "2003, Golden)",
         .unit = "deg",
         .bound = 2e-6,
         .error = absolute,
         .measure =
             [](auto&) {
                 const auto sun = irsg::sunPosition(
                     irsg::UniversalTime{2003, 10, 17, 19.5 + 30.0 / 3600.0},
                     {irsg::radians(39.742476), irsg::radians(-105.1786), 1830.14}, 67.0);
                 return SelfTestValue{irsg::degrees(sun.azimuth_rad), 194.340241};
             }},
        {.name = "air.sun-elevation",
         .says = "Its true elevation in the same example",
         .unit = "deg",
         .bound = 2e-6,
         .error = absolute,
         .measure =
             [](auto&) {
                 const auto sun = irsg::sunPosition(
                     irsg::UniversalTime{2003, 10, 17, 19.5 + 30.0 / 3600.0},
                     {irsg::radians(39.742476), irsg::radians(-105.1786), 1830.14}, 67.0);
                 return SelfTestValue{irsg::degrees(sun.elevation_rad), 39.872046};
             }},
        {.name = "air.sun-distance",
         .says = "Distance of the sun in the published example of Meeus (13 October 1992)",
         .unit = "au",
         .bound = 1e-7,
         .error = absolute,
         .measure =
             [](auto&) {
                 return SelfTestValue{irsg::sunPosition({1992, 10, 13, 0.0}, {}, 0.0).distance_au,
                                      0.99760775};
             }},
        {.name = "air.two-ways",
         .says = "Computed air: transmittance from 100 m up to 3 km and back down, at every bin",
         .unit = "",
         .bound = 1e-9,
         .error = absolute,
         .measure =
             [](auto&) {
                 const Spectrum up = realAtmosphere().transmittance({100.0, 3000.0, 6000.0}, mwir);
                 const Spectrum down =
                     realAtmosphere().transmittance({3000.0, 100.0, 6000.0}, mwir);
                 return along([&](double um) { return up.at(um); },
                              [&](double um) { return down.at(um); }, absolute);
             }},
        {.name = "air.carbon-dioxide",
         .says = "Computed air: 5 km in the band of carbon dioxide at 4.3 um are black",
         .unit = "",
         .bound = 1e-6,
         .error = absolute,
         .measure =
             [](auto&) {
                 return SelfTestValue{
                     realAtmosphere().transmittance({0.0, 0.0, 5000.0}, mwir).at(4.3), 0.0};
             }},
        {.name = "air.opaque-path-is-black",
         .says = "Computed air: the path radiance of those 5 km at 4.3 um against a black body of "
                 "the air's temperature",
         .unit = "W m-2 sr-1 um-1",
         .bound = 5e-3,
         .measure =
             [](auto&) {
                 const double air_K = realAtmosphere().ambientTemperature_K(0.0);
                 return SelfTestValue{
                     realAtmosphere().pathRadiance({0.0, 0.0, 5000.0}, {}, mwir).at(4.3),
                     truePlanck(4.3, air_K)};
             }},
        {.name = "air.no-path",
         .says =
             "A path of no length lets everything through and radiates nothing, in every air (that "
             "of the tables within their float)",
         .unit = "",
         .bound = 1e-7,
         .error = absolute,
         .hard = true,
         .measure =
             [](auto&) {
                 const AtmosphericPath none{100.0, 100.0, 0.0};
                 Farthest farthest(absolute);
                 farthest.add(realAtmosphere().transmittance(none, mwir).minimum(), 1.0);
                 farthest.add(realAtmosphere().pathRadiance(none, {}, mwir).maximum(), 0.0);
                 farthest.add(haze().transmittance(none, mwir).minimum(), 1.0);
                 farthest.add(haze().pathRadiance(none, {}, mwir).maximum(), 0.0);
                 return farthest.found();
             }},
        {.name = "air.opaque",
         .says = "A hundred thousand kilometres of that haze let nothing through and radiate as a "
                 "black body",
         .unit = "W m-2 sr-1 um-1",
         .bound = 5e-5,
         .hard = true,
         .measure =
             [](auto&) {
                 const AtmosphericPath far{100.0, 100.0, 1e8};
                 const Spectrum path = haze().pathRadiance(far, {}, mwir);
                 const double through = haze().transmittance(far, mwir).maximum();
                 return along([&](double um) { return path.at(um) + through; },
                              [](double um) { return truePlanck(um, 280.0); });
             }},
        {.name = "air.refusals",
         .says = "Paths below the ground, of negative range or no number: refused",
         .unit = "refusals",
         .bound = 0.0,
         .error = absolute,
         .hard = true,
         .measure =
             [](auto&) {
                 const auto air = haze();
                 return SelfTestValue{
                     static_cast<double>(refusals(
                         [&] {
                             (void)air.transmittance({-1.0, 0.0, 10.0}, mwir);
                         },
                         [&] {
                             (void)air.transmittance({0.0, 0.0, -10.0}, mwir);
                         },
                         [&] {
                             (void)air.transmittance({0.0, 0.0, std::nan("")}, mwir);
                         })),
                     3.0};
             }},
    };
}

} // namespace smat::selftest
