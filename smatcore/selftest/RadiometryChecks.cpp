#include <array>
#include <cmath>
#include <limits>

#include "irsg/radiometry/Band.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "irsg/reference/PlanckReference.h"
#include "smatcore/selftest/CheckParts.h"
#include "smatcore/selftest/Checks.h"

namespace smat::selftest {
namespace {

using irsg::Band;
using irsg::Spectrum;

constexpr double stefanBoltzmann_W_m2_K4 = 5.670374419e-8; // CODATA 2018

double planckOfLibrary(double wavelength_um, double temperature_K) {
    return irsg::planckRadiance_W_m2_sr_um(wavelength_um, temperature_K);
}

SelfTestValue planckOver(const std::vector<double>& wavelengths_um,
                         const std::vector<double>& temperatures_K) {
    Farthest farthest;
    for (const double wavelength_um : wavelengths_um)
        for (const double temperature_K : temperatures_K)
            if (const double right = truePlanck(wavelength_um, temperature_K); right > 1e-290)
                farthest.add(planckOfLibrary(wavelength_um, temperature_K), right);
    return farthest.found();
}

/// The wavelength of the largest radiance, by bisection of its slope.
double peak_um(double temperature_K) {
    double low_um = 1000.0 / temperature_K, high_um = 6000.0 / temperature_K;
    for (int i = 0; i < 100; ++i) {
        const double middle_um = 0.5 * (low_um + high_um), step_um = 1e-4 * middle_um;
        (planckOfLibrary(middle_um + step_um, temperature_K) >
                 planckOfLibrary(middle_um - step_um, temperature_K)
             ? low_um
             : high_um) = middle_um;
    }
    return 0.5 * (low_um + high_um);
}

SelfTestValue bandsOver(const std::vector<double>& temperatures_K) {
    Farthest farthest;
    for (const auto& [min_um, max_um] :
         {std::pair{3.0, 5.0}, {8.0, 12.0}, {1.9, 2.9}, {4.2, 4.5}, {0.2, 40.0}})
        for (const double temperature_K : temperatures_K)
            if (const auto right = static_cast<double>(
                    irsg::reference::bandRadiance({min_um, max_um}, temperature_K));
                right > 1e-250)
                farthest.add(
                    irsg::bandRadiance_W_m2_sr(Band::topHat(min_um, max_um), temperature_K), right);
    return farthest.found();
}

/// R rises linearly from 0 at 3 um to 1 at 5 um: the integral of (lambda - 3) / 2 L by Simpson.
SelfTestValue sampledResponse(SelfTestBench&) {
    const Band band = Band::fromResponse(Spectrum({3.0, 5.0}, {0.0, 1.0}));
    constexpr int intervals = 20000;
    long double sum = 0.0L;
    for (int i = 0; i <= intervals; ++i) {
        const long double wavelength_um = 3.0L + 2.0L * i / intervals;
        const int weight = i == 0 || i == intervals ? 1 : (i % 2 == 1 ? 4 : 2);
        sum +=
            weight * (wavelength_um - 3.0L) / 2.0L * irsg::reference::planck(wavelength_um, 320.0L);
    }
    return {irsg::bandRadiance_W_m2_sr(band, 320.0),
            static_cast<double>(sum * 2.0L / intervals / 3.0L)};
}

SelfTestValue apparentTemperatures(SelfTestBench&) {
    Farthest farthest;
    for (const double temperature_K : {150.0, 288.15, 320.0, 900.0, 2500.0})
        for (const auto& band : {Band::topHat(3.0, 5.0), Band::topHat(8.0, 12.0)})
            farthest.add(
                *irsg::apparentTemperature_K(band, irsg::bandRadiance_W_m2_sr(band, temperature_K)),
                temperature_K);
    for (const double temperature_K : {250.0, 600.0})
        farthest.add(*irsg::brightnessTemperature_K(4.0, truePlanck(4.0, temperature_K)),
                     temperature_K);
    return farthest.found();
}

SelfTestValue slope(SelfTestBench&) {
    Farthest farthest;
    for (const double t : {250.0, 300.0, 900.0})
        farthest.add(irsg::planckDerivative_W_m2_sr_um_K(4.0, t),
                     static_cast<double>((irsg::reference::planck(4.0L, t + 0.001L) -
                                          irsg::reference::planck(4.0L, t - 0.001L)) /
                                         0.002L));
    return farthest.found();
}

SelfTestValue badAxesAndResponses(SelfTestBench&) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    using Numbers = std::vector<double>;
    int refused = refusals([] { Band::topHat(4.0, 4.0); });
    for (const auto& [axis, values] : {std::pair<Numbers, Numbers>{{5.0, 3.0}, {1.0, 1.0}},
                                       {{3.0, 3.0}, {1.0, 1.0}},
                                       {{3.0, none}, {1.0, 1.0}},
                                       {{3.0, 4.0}, {1.0, none}}})
        refused += refusals([&] { Spectrum(axis, values); });
    for (const Numbers& response : {Numbers{0.0, 0.0}, {-1.0, 3.0}})
        refused += refusals([&] { Band::fromResponse(Spectrum({3.0, 5.0}, response)); });
    return {static_cast<double>(refused), 7.0};
}

} // namespace

std::vector<SelfTestCheck> radiometryChecks() {
    return withHard(
        {
            {"radiometry.planck", "Planck's law, 200 to 3000 K, 1 to 15 um, against long double",
             "W m-2 sr-1 um-1", 1e-12, relative,
             [](auto&) {
                 return planckOver({1.0, 2.7, 4.3, 10.0, 15.0},
                                   {200.0, 288.15, 300.0, 700.0, 3000.0});
             }},
            {"radiometry.planck-printed",
             "Planck's law at 300 K and 10 um: 9.924 W m-2 sr-1 um-1, as tables print it",
             "W m-2 sr-1 um-1", 1e-4, relative,
             [](auto&) {
                 return SelfTestValue{planckOfLibrary(10.0, 300.0), 9.9240};
             }},
            {"radiometry.stefan-boltzmann",
             "pi times the integral of Planck's law, 0.2 to 40 um at 3000 K with the tails, "
             "against sigma T^4 (CODATA 2018)",
             "W m-2", 1e-8, relative,
             [](auto&) {
                 const double all = irsg::bandRadiance_W_m2_sr(Band::topHat(0.05, 5000.0), 3000.0);
                 return SelfTestValue{irsg::pi * all,
                                      stefanBoltzmann_W_m2_K4 * std::pow(3000.0, 4)};
             }},
            {"radiometry.wien",
             "Wavelength of the largest radiance at 1000 K against Wien's displacement law", "um",
             1e-6, relative,
             [](auto&) {
                 return SelfTestValue{peak_um(1000.0), 2.897771955};
             }},
            {"radiometry.slope",
             "Slope of Planck's law with temperature against a central difference",
             "W m-2 sr-1 um-1 K-1", 1e-8, relative, slope},
            {"radiometry.band",
             "Band radiance of black bodies, 250 to 3000 K, against Simpson's rule in long double",
             "W m-2 sr-1", 1e-8, relative,
             [](auto&) {
                 return bandsOver({250.0, 288.15, 320.0, 900.0, 3000.0});
             }},
            {"radiometry.response",
             "Band radiance under a response that rises linearly over 3-5 um, likewise",
             "W m-2 sr-1", 1e-8, relative, sampledResponse},
            {"radiometry.temperature-back",
             "Apparent and brightness temperature of black bodies give their temperature back", "K",
             1e-8, relative, apparentTemperatures},
        },
        {
            {"radiometry.planck-edges",
             "Planck's law at 1 K and 1e5 K, 0.2 to 40 um, against long double", "W m-2 sr-1 um-1",
             1e-12, relative,
             [](auto&) {
                 return planckOver({0.2, 0.5, 12.0, 25.0, 40.0}, {1.0, 2.0, 30.0, 2e4, 1e5});
             }},
            {"radiometry.rayleigh-jeans",
             "h c / lambda k T = 1e-10: Planck's law against 2 c k T / lambda^4", "W m-2 sr-1 um-1",
             1e-9, relative,
             [](auto&) {
                 const double t = irsg::secondRadiationConstant_um_K / 40.0 * 1e10;
                 return SelfTestValue{planckOfLibrary(40.0, t),
                                      irsg::firstRadiationConstant_W_um4_m2_sr / std::pow(40.0, 4) *
                                          t / irsg::secondRadiationConstant_um_K};
             }},
            {"radiometry.band-edges",
             "Band radiance at 30 K and 5000 K against Simpson's rule in long double", "W m-2 sr-1",
             1e-8, relative,
             [](auto&) {
                 return bandsOver({30.0, 5000.0});
             }},
            {"radiometry.refusals",
             "Reversed, repeated and NaN axes, a response of no area, one below zero and a band "
             "without width: refused",
             "refusals", 0.0, absolute, badAxesAndResponses},
        });
}

} // namespace smat::selftest
