#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quadrature.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using testing::HasSubstr;

/// Lines of many strengths, each a triangle three steps wide.
double absorption_per_m(double wavenumber_per_cm) {
    const double phase = std::fmod(wavenumber_per_cm * 0.37, 1.0);
    return 1e-5 * std::exp(6.0 * std::abs(2.0 * phase - 1.0)) *
           (1.0 + 0.8 * std::sin(0.013 * wavenumber_per_cm));
}

/// Runs of homogeneous air at 285 K, 1 cm-1 apart, which a program other than ours might have made.
std::vector<SpectralRun> runs(std::initializer_list<double> ranges_m,
                              std::initializer_list<double> altitudes_m) {
    std::vector<SpectralRun> all;
    for (const double altitude_m : altitudes_m) {
        for (const double range_m : ranges_m) {
            SpectralRun run;
            run.source = "run " + std::to_string(all.size());
            run.kind = RunKind::thermalRadiance;
            run.geometry = {RunPath::horizontal, altitude_m, altitude_m, range_m, 0.0, {}};
            for (double nu = 1950.0; nu <= 2550.0; nu += 1.0) {
                const double depth =
                    absorption_per_m(nu) * range_m * std::exp(-altitude_m / 4000.0);
                const double black = planckRadiance_W_m2_sr_um(1e4 / nu, 285.0);
                run.wavenumbers_per_cm.push_back(nu);
                run.transmittance.push_back(std::exp(-depth));
                run.pathRadiance_W_m2_sr_um.push_back(-std::expm1(-depth) * black);
                run.totalRadiance_W_m2_sr_um.push_back(black);
            }
            all.push_back(std::move(run));
        }
    }
    return all;
}

BeerLambert haze() {
    return BeerLambert::fromCsv(SMAT_RESOURCES_DIR "/atmospheres/haze-23km.csv");
}

CkRequest requestFor(double low_um, double high_um) {
    CkRequest request;
    request.band = Band::topHat(low_um, high_um);
    request.sun = {0.4, 0.7};
    return request;
}

/// Largest relative error of the apparent radiance of black bodies along a path.
double worstOver(const Atmosphere& air, const SensorCkData& points, const AtmosphericPath& path) {
    const Band& band = points.band();
    const AtmosphericQuery tau = AtmosphericQuery::transmittance(path),
                           light = AtmosphericQuery::pathRadiance(path, {0.4, 0.7});
    const Spectrum through = air.spectrum(tau, band.range());
    const Spectrum emitted = air.spectrum(light, band.range());
    const Spectrum* axes[] = {&through, &emitted};
    const SpectralQuadrature quadrature(band, axes);
    double worst = 0.0;
    for (const double temperature_K : {230.0, 300.0, 350.0, 600.0, 1500.0}) {
        const double expected =
            quadrature.integrate(quadrature.planck(temperature_K), quadrature.sampled(through)) +
            quadrature.integrate(quadrature.sampled(emitted));
        const double found =
            points.integrate(points.planck(temperature_K), air.provide(tau, points)) +
            points.integrate(air.provide(light, points));
        worst = std::max(worst, std::abs(found / expected - 1.0));
    }
    return worst;
}

TEST(HazeCk, GivesApparentRadianceWithinHalfAPercent) {
    const BeerLambert air = haze();
    for (const auto& [low_um, high_um] : {std::pair{3.0, 5.0}, {8.0, 12.0}, {4.1, 4.5}}) {
        const auto points = air.prepareCk(requestFor(low_um, high_um));
        double worst = 0.0;
        for (const double range_m : {0.0, 5.0, 47.0, 410.0, 1700.0, 5200.0, 17e3, 62e3}) {
            worst = std::max(worst, worstOver(air, *points, {300.0, 900.0, range_m}));
        }
        EXPECT_LT(worst, 0.005) << low_um << " um, " << points->size() << " points";
        EXPECT_LT(points->heldOutError(), 0.01);
        EXPECT_GT(points->heldOutError(), points->heldOutRms());
        EXPECT_LT(points->size(), 80u);
        std::cout << low_um << "-" << high_um << ": " << points->size() << " points, worst "
                  << 100.0 * worst << " %, held out " << 100.0 * points->heldOutError() << " %\n";
    }
}

TEST(HazeCk, AnswersEveryQuantityAsTheSpectralModeDoes) {
    const BeerLambert air = haze();
    const SunPosition sun{0.4, 0.7};
    const auto points = air.prepareCk(requestFor(3.0, 5.0));
    for (const AtmosphericQuery& query :
         {AtmosphericQuery::backgroundRadiance({500.0, 0.2, 0.0}, sun),
          AtmosphericQuery::backgroundRadiance({500.0, 0.0, 0.0}, sun),
          AtmosphericQuery::backgroundRadiance({500.0, -0.02, 0.0}, sun),
          AtmosphericQuery::backgroundRadiance({500.0, -1.2, 0.0}, sun),
          AtmosphericQuery::solarIrradiance(100.0, sun), AtmosphericQuery::upwardFlux(100.0, sun),
          AtmosphericQuery::downwardFlux(100.0, sun)}) {
        const Spectrum spectral = air.spectrum(query, points->range());
        const Spectrum* axes[] = {&spectral};
        const SpectralQuadrature quadrature(points->band(), axes);
        EXPECT_NEAR(points->integrate(air.provide(query, *points)) /
                        quadrature.integrate(quadrature.sampled(spectral)),
                    1.0, 0.006)
            << name(query.quantity) << " at " << query.sight.elevation_rad;
    }
    const std::vector<double> depth =
        air.provide(AtmosphericQuery::scatteringOpticalDepth({0.0, 0.0, 1e3}), *points);
    EXPECT_THAT(depth, testing::Each(0.0));
}

TEST(TableCk, GivesApparentRadianceWithinHalfAPercentBetweenItsRuns) {
    const TabulatedAtmosphere air(runs({500.0, 2000.0, 5000.0, 20000.0}, {0.0, 1000.0, 3000.0}),
                                  "family");
    const auto points = air.prepareCk(requestFor(4.0, 5.0));
    double worst = 0.0;
    for (const double altitude_m : {0.0, 400.0, 2100.0, 3000.0}) {
        for (const double range_m : {12.0, 90.0, 700.0, 3100.0, 8000.0, 19000.0}) {
            worst = std::max(worst, worstOver(air, *points, {altitude_m, altitude_m, range_m}));
        }
    }
    EXPECT_LT(worst, 0.005) << points->size() << " points";
    EXPECT_LT(points->heldOutError(), 0.01);
    EXPECT_LT(points->size(), 100u);
    std::cout << points->size() << " points, worst " << 100.0 * worst << " %, held out "
              << 100.0 * points->heldOutError() << " %\n";
}

TEST(TableCk, IsTrainedAlongTheRangesOfASingleRun) {
    const TabulatedAtmosphere air(runs({5000.0}, {0.0}), "one run");
    const auto points = air.prepareCk(requestFor(4.0, 4.8));
    for (const double range_m : {20.0, 300.0, 1900.0, 4900.0}) {
        EXPECT_LT(worstOver(air, *points, {0.0, 0.0, range_m}), 0.005) << range_m;
    }
}

TEST(TableCk, RefusesWhatTheFamilyDoesNotHoldAsTheSpectralModeDoes) {
    const TabulatedAtmosphere air(runs({5000.0}, {0.0}), "one run");
    const auto points = air.prepareCk(requestFor(4.0, 4.8));
    const auto refusal = [&](auto ask) -> std::string {
        try {
            ask();
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    const AtmosphericQuery tooFar = AtmosphericQuery::transmittance({0.0, 0.0, 6000.0});
    const std::string spectral = refusal([&] { (void)air.spectrum(tooFar, points->range()); });
    EXPECT_THAT(spectral, HasSubstr("range up to 5000 m"));
    EXPECT_EQ(refusal([&] { (void)air.provide(tooFar, *points); }), spectral);
    Environment environment;
    environment.add(std::make_shared<TabulatedAtmosphere>(air));
    EXPECT_THAT(
        refusal([&] { (void)environment.provide(AtmosphericQuery::upwardFlux(0.0, {}), *points); }),
        HasSubstr("wideband upward flux over 4-4.8 um: found one run (has no upward flux)"));
}

TEST(KnownAtmosphereCk, IsKeptOnDiskAndFoundByTheNumbersOfTheAir) {
    const smat::test::TemporaryFolder folder;
    setenv("SMAT_CACHE", folder.path().c_str(), 1);
    const auto kept = [&] {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
            count += entry.path().extension() == ".cache" ? 1 : 0;
        }
        return count;
    };
    const auto first =
        TabulatedAtmosphere(runs({5000.0}, {0.0}), "one").prepareCk(requestFor(4, 4.5));
    EXPECT_EQ(kept(), 1u);
    const auto again =
        TabulatedAtmosphere(runs({5000.0}, {0.0}), "other name").prepareCk(requestFor(4, 4.5));
    EXPECT_EQ(kept(), 1u);
    EXPECT_EQ(again->weights_um(), first->weights_um());
    EXPECT_EQ(again->heldOutError(), first->heldOutError());

    std::vector<SpectralRun> changed = runs({5000.0}, {0.0});
    changed[0].transmittance[300] *= 0.999;
    (void)TabulatedAtmosphere(changed, "one").prepareCk(requestFor(4, 4.5));
    EXPECT_EQ(kept(), 2u);

    BeerLambertParameters thin = haze().parameters();
    (void)BeerLambert(thin).prepareCk(requestFor(4, 4.5));
    EXPECT_EQ(kept(), 3u);
    thin.airTemperature_K += 1e-9;
    (void)BeerLambert(thin).prepareCk(requestFor(4, 4.5));
    EXPECT_EQ(kept(), 4u);
    setenv("SMAT_CACHE", "", 1);
}

TEST(KnownAtmosphereCk, IsDeclinedByNameWhereOneLineOfSightIsKnown) {
    SpectraAtmosphereParameters one;
    one.name = "radiative output";
    one.spectra[AtmosphereProperty::transmittance] = Spectrum({3.0, 5.0}, {0.5, 0.6});
    one.path = AtmosphericPath{0.0, 0.0, 1000.0};
    Environment environment;
    environment.add(std::make_shared<SpectraAtmosphere>(one));
    EXPECT_FALSE(environment.findWideband({3.5, 4.5}));
    try {
        (void)environment.prepareCk(requestFor(3.5, 4.5));
        FAIL() << "nothing was refused";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("radiative output (has no wideband mode: it knows one "
                                            "line of sight"));
    }
}

TEST(KnownAtmosphereCk, IsThatOfTheAirThatKnowsMost) {
    Environment environment;
    environment.add(std::make_shared<TabulatedAtmosphere>(runs({5000.0}, {0.0}), "runs"));
    EXPECT_EQ(environment.requireWideband({4.0, 4.5}).name(), "runs");
    environment.add(std::make_shared<BeerLambert>(haze()));
    EXPECT_EQ(environment.requireWideband({4.0, 4.5}).name(), haze().name())
        << "which has the fluxes";
    environment.add(std::make_shared<BeerLambert>(haze()));
    EXPECT_EQ(environment.findWideband({4.0, 4.5}), environment.atmospheres()[1].get())
        << "the first of equals";
}

} // namespace
} // namespace irsg
