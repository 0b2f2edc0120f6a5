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

SelfTestValue beerLambert(SelfTestBench&) {
    const Spectrum found = haze().transmittance({100.0, 100.0, 2500.0}, mwir);
    return along([&](double um) { return found.at(um); },
                 [](double um) { return std::exp(-2500.0 * hazeExtinction_per_m(um)); });
}

SelfTestValue pathRadiance(SelfTestBench&) {
    const Spectrum found = haze().pathRadiance({100.0, 100.0, 2500.0}, {}, mwir);
    return along([&](double um) { return found.at(um); },
                 [](double um) {
                     return -std::expm1(-2500.0 * hazeExtinction_per_m(um)) * truePlanck(um, 280.0);
                 });
}

SelfTestValue groundBehindAir(SelfTestBench&) {
    const Spectrum found = haze().backgroundRadiance({500.0, irsg::radians(-30.0), 0.0}, {}, mwir);
    return along([&](double um) { return found.at(um); },
                 [](double um) {
                     const double t = std::exp(-1000.0 * hazeExtinction_per_m(um));
                     return t * truePlanck(um, 300.0) + (1.0 - t) * truePlanck(um, 280.0);
                 });
}

/// The published example of NREL's algorithm.
irsg::SunPosition sunOfNrel() {
    return irsg::sunPosition(irsg::UniversalTime{2003, 10, 17, 19.5 + 30.0 / 3600.0},
                             {irsg::radians(39.742476), irsg::radians(-105.1786), 1830.14}, 67.0);
}

SelfTestValue solarConstant(SelfTestBench&) {
    const SpectralRange all{0.2, 40.0};
    const Spectrum sun = irsg::Vacuum().solarIrradiance(0.0, {.elevation_rad = 1.0}, all);
    const auto part = static_cast<double>(irsg::reference::bandRadiance(all, 5772.0L) /
                                          irsg::reference::bandRadiance({0.01, 10000.0}, 5772.0L));
    return {integralOf(sun, all), 1361.0 * part};
}

SelfTestValue twoWays(SelfTestBench&) {
    const Spectrum up = realAtmosphere().transmittance({100.0, 3000.0, 6000.0}, mwir);
    const Spectrum down = realAtmosphere().transmittance({3000.0, 100.0, 6000.0}, mwir);
    return along([&](double um) { return up.at(um); }, [&](double um) { return down.at(um); },
                 absolute);
}

SelfTestValue noPath(SelfTestBench&) {
    const AtmosphericPath none{100.0, 100.0, 0.0};
    Farthest farthest(absolute);
    farthest.add(realAtmosphere().transmittance(none, mwir).minimum(), 1.0);
    farthest.add(realAtmosphere().pathRadiance(none, {}, mwir).maximum(), 0.0);
    farthest.add(haze().transmittance(none, mwir).minimum(), 1.0);
    farthest.add(haze().pathRadiance(none, {}, mwir).maximum(), 0.0);
    return farthest.found();
}

SelfTestValue opaque(SelfTestBench&) {
    const AtmosphericPath far{100.0, 100.0, 1e8};
    const Spectrum path = haze().pathRadiance(far, {}, mwir);
    const double through = haze().transmittance(far, mwir).maximum();
    return along([&](double um) { return path.at(um) + through; },
                 [](double um) { return truePlanck(um, 280.0); });
}

SelfTestValue badPaths(SelfTestBench&) {
    const auto air = haze();
    int refused = 0;
    for (const AtmosphericPath& path :
         {AtmosphericPath{-1.0, 0.0, 10.0}, {0.0, 0.0, -10.0}, {0.0, 0.0, std::nan("")}})
        refused += refusals([&] { (void)air.transmittance(path, mwir); });
    return {static_cast<double>(refused), 3.0};
}

} // namespace

std::vector<SelfTestCheck> atmosphereChecks() {
    return withHard(
        {
            {"air.beer-lambert",
             "Transmittance of 2.5 km of air whose extinction is linear in wavelength against "
             "exp(-extinction range)",
             "", 2e-5, relative, beerLambert},
            {"air.path-radiance",
             "Path radiance of the same air against (1 - transmittance) times a black body of its "
             "temperature",
             "W m-2 sr-1 um-1", 5e-5, relative, pathRadiance},
            {"air.ground-behind-air",
             "Background 30 degrees below the horizontal: black ground of 300 K behind that air, "
             "at h / sin(depression)",
             "W m-2 sr-1 um-1", 5e-5, relative, groundBehindAir},
            {"air.solar-constant",
             "The sun of a vacuum, 0.2 to 40 um, against that part of 1361 W m-2 (IAU 2015 "
             "resolution B3) by Planck's law at 5772 K",
             "W m-2", 4e-4, relative, solarConstant},
            {"air.sun-azimuth",
             "Azimuth of the sun in the published example of NREL's algorithm (17 October 2003, "
             "Golden)",
             "deg", 2e-6, absolute,
             [](auto&) {
                 return SelfTestValue{irsg::degrees(sunOfNrel().azimuth_rad), 194.340241};
             }},
            {"air.sun-elevation", "Its true elevation in the same example", "deg", 2e-6, absolute,
             [](auto&) {
                 return SelfTestValue{irsg::degrees(sunOfNrel().elevation_rad), 39.872046};
             }},
            {"air.sun-distance",
             "Distance of the sun in the published example of Meeus (13 October 1992)", "au", 1e-7,
             absolute,
             [](auto&) {
                 return SelfTestValue{irsg::sunPosition({1992, 10, 13, 0.0}, {}, 0.0).distance_au,
                                      0.99760775};
             }},
            {"air.two-ways",
             "Computed air: transmittance from 100 m up to 3 km and back down, at every bin", "",
             1e-9, absolute, twoWays},
            {"air.carbon-dioxide",
             "Computed air: 5 km in the band of carbon dioxide at 4.3 um are black", "", 1e-6,
             absolute,
             [](auto&) {
                 return SelfTestValue{
                     realAtmosphere().transmittance({0.0, 0.0, 5000.0}, mwir).at(4.3), 0.0};
             }},
            {"air.opaque-path-is-black",
             "Computed air: the path radiance of those 5 km at 4.3 um against a black body of the "
             "air's temperature",
             "W m-2 sr-1 um-1", 5e-3, relative,
             [](auto&) {
                 const double air_K = realAtmosphere().ambientTemperature_K(0.0);
                 return SelfTestValue{
                     realAtmosphere().pathRadiance({0.0, 0.0, 5000.0}, {}, mwir).at(4.3),
                     truePlanck(4.3, air_K)};
             }},
        },
        {
            {"air.no-path",
             "A path of no length lets everything through and radiates nothing, in every air (that "
             "of the tables within their float)",
             "", 1e-7, absolute, noPath},
            {"air.opaque",
             "A hundred thousand kilometres of that haze let nothing through and radiate as a "
             "black body",
             "W m-2 sr-1 um-1", 5e-5, relative, opaque},
            {"air.refusals", "Paths below the ground, of negative range or no number: refused",
             "refusals", 0.0, absolute, badPaths},
        });
}

} // namespace smat::selftest
