#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

namespace irsg {
namespace {

using namespace syntheticatmosphere;

constexpr double pi = std::numbers::pi;

double planck(std::uint32_t node, double temperature_K) {
    return planckRadiance_W_m2_sr_um(1e4 / wavenumbers_per_cm[node], temperature_K);
}

double one(const std::vector<double>& values) {
    EXPECT_EQ(values.size(), 1u);
    return values.front();
}

TEST(RadiativeTransfer, RadiatesAsPlanckInsideOpaqueIsothermalAir) {
    for (const ScatteringMode mode : {ScatteringMode::single, ScatteringMode::twoStream}) {
        for (const double albedo : {0.0, 0.3, 1.0}) {
            AtmosphericModel air = model(profile(270.0), mode);
            air.groundTemperature_K = 270.0;
            air.groundAlbedo = Spectrum::constant(albedo);
            air.particles = {particles({0.0, 3000.0}, {2e-3, 1e-3}, 0.7, 0.8)};
            const RadiativeTransfer transfer(air, table());
            const double expected = planck(opaque, 270.0);
            for (const double altitude_m : {0.0, 1.0, 3456.7, 20e3}) {
                for (const double elevation : {-90.0, -30.0, -0.1, 0.0, 0.1, 45.0, 90.0}) {
                    const LineOfSight sight{altitude_m, elevation * pi / 180.0, 0.0};
                    EXPECT_NEAR(one(transfer.backgroundRadiance(nodes({opaque}), sight, night)) /
                                    expected,
                                1.0, 1e-6)
                        << altitude_m << " m, " << elevation;
                }
            }
            for (const double altitude_m : {0.0, 777.0, 40e3}) {
                EXPECT_NEAR(one(transfer.upwardFlux(nodes({opaque}), altitude_m, night)) /
                                (pi * expected),
                            1.0, 1e-6);
                EXPECT_NEAR(one(transfer.downwardFlux(nodes({opaque}), altitude_m, night)) /
                                (pi * expected),
                            1.0, 1e-6);
            }
        }
    }
}

TEST(RadiativeTransfer, RadiatesAsPlanckDeepInsideIsothermalFog) {
    // Half of the extinction is scattering; the top of the fog is 100 optical depths away.
    AtmosphericModel air = model(profile(280.0));
    air.groundTemperature_K = 280.0;
    air.groundAlbedo = Spectrum::constant(0.4);
    air.particles = {particles({0.0, 4000.0}, {0.05, 0.05}, 0.5, 0.8)};
    const RadiativeTransfer transfer(air, table());
    for (const std::uint32_t node : {thin, medium}) {
        for (const double elevation : {-90.0, -10.0, 0.0, 3.0, 90.0}) {
            const LineOfSight sight{3.0, elevation * pi / 180.0, 0.0};
            EXPECT_NEAR(one(transfer.backgroundRadiance(nodes({node}), sight, night)) /
                            planck(node, 280.0),
                        1.0, 1e-6)
                << elevation;
        }
    }
}

TEST(RadiativeTransfer, TransmitsAnExponentialAtmosphereInClosedForm) {
    const RadiativeTransfer transfer(model(profile()), table());
    for (const std::uint32_t node : {thin, medium, sunlit}) {
        for (const double top_m : {500.0, 3000.0, 20e3, 100e3}) {
            const double perMetre =
                extinction_per_m(*table(), node, transfer.air().profile.at(0.0));
            const double expected = perMetre * scaleHeight_m * -std::expm1(-top_m / scaleHeight_m);
            const double found =
                -std::log(one(transfer.transmittance(nodes({node}), {0.0, top_m, top_m})));
            EXPECT_NEAR(found / expected, 1.0, 2e-3) << node << " to " << top_m;
        }
    }
}

TEST(RadiativeTransfer, TransmitsTheSameBothWaysAndInPieces) {
    const RadiativeTransfer transfer(model(profile(288.0, 6.5)), table());
    const NodeSet set = nodes({thin, medium, sunlit});
    const auto there = transfer.transmittance(set, {1234.5, 8765.4, 60e3});
    const auto back = transfer.transmittance(set, {8765.4, 1234.5, 60e3});
    const auto whole = transfer.transmittance(set, {1000.3, 9000.0, 7999.7});
    const auto lower = transfer.transmittance(set, {1000.3, 3333.3, 2333.0});
    const auto upper = transfer.transmittance(set, {3333.3, 9000.0, 5666.7});
    for (std::size_t i = 0; i < set.nodes.size(); ++i) {
        EXPECT_NEAR(there[i], back[i], 1e-12);
        EXPECT_NEAR(whole[i], lower[i] * upper[i], 1e-9);
    }
}

TEST(RadiativeTransfer, AddsTheRadianceOfTwoPiecesOfAPath) {
    const RadiativeTransfer transfer(model(profile(288.0, 6.5)), table());
    for (const double cut_m : {3333.3, 4000.0, 4010.0}) {
        const NodeSet set = nodes({medium});
        const double whole = one(transfer.pathRadiance(set, {1000.0, 9000.0, 8000.0}, night));
        const double near = one(transfer.pathRadiance(set, {1000.0, cut_m, cut_m - 1000.0}, night));
        const double far = one(transfer.pathRadiance(set, {cut_m, 9000.0, 9000.0 - cut_m}, night));
        const double between = one(transfer.transmittance(set, {1000.0, cut_m, cut_m - 1000.0}));
        EXPECT_NEAR((near + between * far) / whole, 1.0, 1e-4);
    }
}

TEST(RadiativeTransfer, TransmitsLessTheLongerThePathAndNeverMoreThanAll) {
    AtmosphericModel air = model(profile());
    air.particles = {particles({0.0, 3000.0}, {2e-4, 1e-5}, 0.7, 0.8)};
    const RadiativeTransfer transfer(air, table());
    const NodeSet set = nodes();
    EXPECT_THAT(transfer.transmittance(set, {500.0, 500.0, 0.0}), testing::Each(1.0));
    EXPECT_THAT(transfer.pathRadiance(set, {500.0, 500.0, 0.0}, {}), testing::Each(0.0));
    std::vector<double> last(set.nodes.size(), 1.0);
    for (double range_m = 0.01; range_m < 2e5; range_m *= 2.7) {
        const auto now = transfer.transmittance(set, {3000.0, 3000.0, range_m});
        for (std::size_t i = 0; i < now.size(); ++i) {
            EXPECT_LE(now[i], last[i]) << range_m;
        }
        last = now;
    }
}

TEST(RadiativeTransfer, KeepsTheDigitsOfACentimetre) {
    const RadiativeTransfer transfer(model(profile()), table());
    const AtmosphericState ground = transfer.air().profile.at(100.0);
    const AtmosphericPath path{100.0, 100.0, 0.01};
    for (const std::uint32_t node : {medium, sunlit}) {
        const double expected = extinction_per_m(*table(), node, ground) * 0.01;
        EXPECT_NEAR((1.0 - one(transfer.transmittance(nodes({node}), path))) / expected, 1.0, 1e-3);
    }
    // The radiance has no 1 to lose digits against.
    const auto centimetre = one(transfer.pathRadiance(nodes({thin}), path, night));
    const auto metre = one(transfer.pathRadiance(nodes({thin}), {100.0, 100.0, 1.0}, night));
    EXPECT_NEAR(metre / centimetre, 100.0, 1e-4);
}

TEST(RadiativeTransfer, IsLinearWhereTheAirIsThin) {
    const RadiativeTransfer transfer(model(profile()), table());
    const NodeSet set = nodes({thin});
    const double extinction = extinction_per_m(*table(), thin, transfer.air().profile.at(2000.0));
    for (const double range_m : {1.0, 30.0, 1000.0}) {
        const double radiance = one(transfer.pathRadiance(set, {2000.0, 2000.0, range_m}, night));
        EXPECT_NEAR(radiance / (extinction * range_m * planck(thin, 288.0)), 1.0, 2e-2);
    }
}

TEST(RadiativeTransfer, AgreesWithBeerAndLambertAlongAHorizontalPath) {
    const RadiativeTransfer transfer(model(profile()), table());
    BeerLambertParameters homogeneous;
    homogeneous.airTemperature_K = 288.0;
    homogeneous.extinction_per_m =
        Spectrum::constant(extinction_per_m(*table(), medium, transfer.air().profile.at(0.0)));
    const BeerLambert reference(homogeneous);
    const double wavelength_um = 1e4 / wavenumbers_per_cm[medium];
    const SpectralRange range{wavelength_um - 0.01, wavelength_um + 0.01};
    for (const double range_m : {1.0, 500.0, 5000.0}) {
        const AtmosphericPath path{0.0, 0.0, range_m};
        EXPECT_NEAR(one(transfer.transmittance(nodes({medium}), path)),
                    reference.transmittance(path, range).at(wavelength_um), 1e-4);
        EXPECT_NEAR(one(transfer.pathRadiance(nodes({medium}), path, night)) /
                        reference.pathRadiance(path, night, range).at(wavelength_um),
                    1.0, 3e-4)
            << range_m;
    }
}

TEST(RadiativeTransfer, RadiatesAtTheNearTemperatureWhereTheAirIsOpaque) {
    const RadiativeTransfer transfer(model(profile(288.0, 6.5)), table());
    const NodeSet set = nodes({opaque});
    EXPECT_NEAR(one(transfer.pathRadiance(set, {3000.0, 10e3, 20e3}, night)) /
                    planck(opaque, 288.0 - 6.5 * 3.0),
                1.0, 1e-6);
    EXPECT_NEAR(one(transfer.pathRadiance(set, {10e3, 3000.0, 20e3}, night)) /
                    planck(opaque, 288.0 - 6.5 * 10.0),
                1.0, 1e-6);
    EXPECT_NEAR(one(transfer.pathRadiance(set, {3100.0, 10e3, 20e3}, night)) /
                    planck(opaque, 288.0 - 6.5 * 3.1),
                1.0, 1e-6);
}

TEST(RadiativeTransfer, RadiatesWithAllOfItsExtinctionWhereLightIsScatteredOnce) {
    // As MODTRAN without multiple scattering: (1 - transmittance) Planck along a level path.
    AtmosphericModel air = model(profile(288.0, 6.5), ScatteringMode::single);
    air.particles = {particles({0.0, 3000.0}, {2e-4, 2e-4}, 0.7, 0.8)};
    const RadiativeTransfer transfer(air, table());
    const AtmosphericPath path{1000.0, 1000.0, 4000.0};
    for (const std::uint32_t node : {thin, medium}) {
        const double transmittance = one(transfer.transmittance(nodes({node}), path));
        EXPECT_LT(transmittance, 0.5);
        EXPECT_NEAR(one(transfer.pathRadiance(nodes({node}), path, night)) /
                        ((1.0 - transmittance) * planck(node, 281.5)),
                    1.0, 1e-4);
    }
}

TEST(RadiativeTransfer, RadiatesUpAsDownThroughIsothermalAir) {
    const RadiativeTransfer transfer(model(profile(), ScatteringMode::single), table());
    const NodeSet set = nodes({thin, medium});
    const auto up = transfer.pathRadiance(set, {0.0, 5000.0, 12e3}, night);
    const auto down = transfer.pathRadiance(set, {5000.0, 0.0, 12e3}, night);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(up[i] / down[i], 1.0, 1e-6);
    }
}

TEST(RadiativeTransfer, DoesNotNoticeParticlesThatTakeNothing) {
    AtmosphericModel air = model(profile(288.0, 6.5));
    const RadiativeTransfer without(air, table());
    air.particles = {particles({1000.0, 2000.0}, {0.0, 0.0}, 0.5, 0.7)};
    const RadiativeTransfer with(air, table());
    const AtmosphericPath path{300.0, 7000.0, 30e3};
    const SunPosition sun{0.3, 0.6};
    EXPECT_EQ(without.transmittance(nodes(), path), with.transmittance(nodes(), path));
    EXPECT_EQ(without.pathRadiance(nodes(), path, sun), with.pathRadiance(nodes(), path, sun));
    EXPECT_EQ(without.downwardFlux(nodes(), 0.0, sun), with.downwardFlux(nodes(), 0.0, sun));
}

TEST(RadiativeTransfer, IsContinuousAcrossTheHorizon) {
    AtmosphericModel air = model(profile(288.0, 6.5));
    air.particles = {particles({0.0, 3000.0}, {1e-4, 1e-5}, 0.9, 0.7)};
    const RadiativeTransfer transfer(air, table());
    for (const double altitude_m : {10.0, 1500.0, 10e3}) {
        const SunPosition sun{0.4, 0.5};
        const auto above = transfer.backgroundRadiance(nodes(), {altitude_m, 1e-6, 1.0}, sun);
        const auto level = transfer.backgroundRadiance(nodes(), {altitude_m, 0.0, 1.0}, sun);
        const auto below = transfer.backgroundRadiance(nodes(), {altitude_m, -1e-6, 1.0}, sun);
        for (std::size_t i = 0; i < above.size(); ++i) {
            EXPECT_NEAR(above[i] / level[i], 1.0, 1e-4) << altitude_m << " node " << i;
            EXPECT_NEAR(below[i] / level[i], 1.0, 1e-4) << altitude_m << " node " << i;
        }
    }
}

TEST(RadiativeTransfer, KeepsTheFluxOfTheSunWithoutAbsorption) {
    AtmosphericModel air = model(profile(200.0));
    air.groundAlbedo = Spectrum::constant(1.0);
    air.particles = {particles({500.0, 2500.0}, {5e-3, 5e-3}, 1.0, 0.85)};
    const RadiativeTransfer transfer(air, table());
    const SunPosition zenith{0.0, 0.5 * pi};
    const NodeSet set = nodes({blue});
    const double above = one(transfer.solarIrradiance(set, 100e3, zenith));
    ASSERT_GT(above, 0.0);
    for (const double altitude_m : transfer.tracer().gridAltitudes_m()) {
        const double down = one(transfer.downwardFlux(set, altitude_m, zenith)) +
                            one(transfer.solarIrradiance(set, altitude_m, zenith));
        EXPECT_NEAR((one(transfer.upwardFlux(set, altitude_m, zenith)) - down) / above, 0.0, 2e-6)
            << altitude_m;
    }
}

TEST(RadiativeTransfer, ScattersTheSunOnceAsThinAirMust) {
    const RadiativeTransfer transfer(model(profile(), ScatteringMode::single), table());
    const NodeSet set = nodes({blue});
    const double altitude_m = 5000.0, range_m = 100.0;
    const SunPosition zenith{0.0, 0.5 * pi};
    const double beam = one(transfer.solarIrradiance(set, altitude_m, zenith));
    const double depth =
        one(transfer.scatteringOpticalDepth(set, {altitude_m, altitude_m, range_m}));
    ASSERT_GT(depth, 0.0);
    // Rayleigh's phase function is 3/4 at a right angle and 3/2 looking at the sun.
    EXPECT_NEAR(one(transfer.pathRadiance(set, {altitude_m, altitude_m, range_m}, zenith)) /
                    (beam * depth * 0.75 / (4.0 * pi)),
                1.0, 2e-3);
    EXPECT_NEAR(
        one(transfer.pathRadiance(set, {altitude_m, altitude_m + range_m, range_m}, zenith)) /
            (beam * depth * 1.5 / (4.0 * pi)),
        1.0, 2e-2);
}

TEST(RadiativeTransfer, ScattersMoreOftenThanOnceWhereTwoStreamsAreAskedFor) {
    AtmosphericModel air = model(profile());
    air.groundAlbedo = Spectrum::constant(0.0);
    air.scattering = ScatteringMode::single;
    const RadiativeTransfer once(air, table());
    air.scattering = ScatteringMode::twoStream;
    const RadiativeTransfer often(air, table());
    const LineOfSight up{0.0, 0.8, 1.0};
    const SunPosition sun{0.0, 0.7};
    const double blueRatio = one(often.backgroundRadiance(nodes({blue}), up, sun)) /
                             one(once.backgroundRadiance(nodes({blue}), up, sun));
    EXPECT_GT(blueRatio, 1.02); // Rayleigh optical depth 0.15
    EXPECT_LT(blueRatio, 1.4);
    EXPECT_NEAR(one(often.backgroundRadiance(nodes({sunlit}), up, sun)) /
                    one(once.backgroundRadiance(nodes({sunlit}), up, sun)),
                1.0, 2e-3);
}

TEST(RadiativeTransfer, SeesSunlitAndWarmGround) {
    AtmosphericModel air = model(profile(250.0));
    air.groundTemperature_K = 300.0;
    air.groundAlbedo = Spectrum::constant(0.5);
    const RadiativeTransfer transfer(air, table());
    const LineOfSight down{3000.0, -0.5 * pi, 0.0};
    EXPECT_NEAR(one(transfer.backgroundRadiance(nodes({thin}), down, night)) / planck(thin, 300.0),
                0.5, 2e-3);
    const SunPosition sun{0.0, 0.5};
    const double beam = one(transfer.solarIrradiance(nodes({sunlit}), 0.0, sun));
    const double passed = one(transfer.transmittance(nodes({sunlit}), {3000.0, 0.0, 3000.0}));
    EXPECT_NEAR(one(transfer.backgroundRadiance(nodes({sunlit}), down, sun)) /
                    (passed * 0.5 * beam * std::sin(0.5) / pi),
                1.0, 0.02);
}

TEST(RadiativeTransfer, KnowsWhenTheEarthHidesTheSun) {
    const RadiativeTransfer transfer(model(profile()), table());
    const NodeSet set = nodes({sunlit});
    EXPECT_EQ(one(transfer.solarIrradiance(set, 0.0, {0.0, -0.05})), 0.0);
    EXPECT_GT(one(transfer.solarIrradiance(set, 30e3, {0.0, -0.05})), 0.0);
    EXPECT_EQ(one(transfer.solarIrradiance(set, 30e3, {0.0, -0.5})), 0.0);
    double last = 0.0;
    for (const double elevation : {0.01, 0.1, 0.5, 1.0, 1.5}) {
        const double now = one(transfer.solarIrradiance(set, 0.0, {0.0, elevation}));
        EXPECT_GT(now, last);
        last = now;
    }
}

TEST(RadiativeTransfer, StaysFiniteAndPositiveForEverySunAndSight) {
    AtmosphericModel air = model(profile(288.0, 6.5));
    air.particles = {particles({0.0, 2000.0}, {1e-4, 1e-5}, 0.9, 0.7),
                     particles({3000.0, 4000.0}, {0.1, 0.1}, 0.999999, 0.87)};
    for (const ScatteringMode mode : {ScatteringMode::single, ScatteringMode::twoStream}) {
        air.scattering = mode;
        const RadiativeTransfer transfer(air, table());
        for (const double sun : {-90.0, -12.0, -6.0, -1.0, -0.3, 0.0, 0.3, 10.0, 60.0, 90.0}) {
            for (const double sight : {-90.0, -20.0, 0.0, 1.0, 50.0, 90.0}) {
                for (const double altitude_m : {0.0, 2.0, 3500.0, 12e3, 99e3, 400e3}) {
                    const auto radiance = transfer.backgroundRadiance(
                        nodes(), {altitude_m, sight * pi / 180.0, 0.3}, {0.3, sun * pi / 180.0});
                    const auto down =
                        transfer.downwardFlux(nodes(), altitude_m, {0.3, sun * pi / 180.0});
                    for (std::size_t i = 0; i < radiance.size(); ++i) {
                        EXPECT_TRUE(std::isfinite(radiance[i]) && radiance[i] >= 0.0)
                            << sun << " " << sight << " " << altitude_m;
                        EXPECT_TRUE(std::isfinite(down[i]) && down[i] >= -1e-9)
                            << sun << " " << altitude_m << " " << down[i];
                    }
                }
            }
        }
    }
}

TEST(RadiativeTransfer, DarkensTheGroundUnderACloud) {
    AtmosphericModel air = model(profile(270.0));
    const SunPosition sun{0.0, 0.8};
    const NodeSet set = nodes({blue});
    const RadiativeTransfer clear(air, table());
    air.particles = {particles({1000.0, 1500.0}, {0.1, 0.1}, 1.0, 0.85)};
    const RadiativeTransfer cloudy(air, table());
    const double clearLight = one(clear.downwardFlux(set, 0.0, sun)) +
                              std::sin(0.8) * one(clear.solarIrradiance(set, 0.0, sun));
    EXPECT_LT(one(cloudy.solarIrradiance(set, 0.0, sun)), 1e-20);
    EXPECT_LT(one(cloudy.downwardFlux(set, 0.0, sun)), 0.4 * clearLight);
    EXPECT_GT(one(cloudy.downwardFlux(set, 0.0, sun)), 0.1 * clearLight);
    EXPECT_GT(one(cloudy.upwardFlux(set, 3000.0, sun)), 0.5 * clearLight);
}

TEST(RadiativeTransfer, TransmitsTheProductOfItsComponents) {
    AtmosphericModel air = model(profile());
    air.particles = {particles({0.0, 3000.0}, {1e-4, 1e-5}, 0.7, 0.8)};
    const RadiativeTransfer transfer(air, table());
    const AtmosphericPath path{100.0, 6000.0, 15e3};
    std::vector<double> product(nodes().nodes.size(), 1.0);
    for (const char* component :
         {"CO2", "H2O", "N2 collision-induced", "HNO3", "Rayleigh", "particles"}) {
        const auto alone = transfer.componentTransmittance(nodes(), path, component);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            product[i] *= alone[i];
        }
    }
    const auto all = transfer.transmittance(nodes(), path);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_NEAR(product[i], all[i], 2e-6);
    }
    EXPECT_THROW((void)transfer.componentTransmittance(nodes(), path, "phlogiston"), LogicError);
}

TEST(RadiativeTransfer, AveragesNodesIntoBinsOverWavelength) {
    const RadiativeTransfer transfer(model(profile()), table());
    const SpectralRange range{1e4 / 1009.0, 1e4 / 1001.0};
    EXPECT_EQ(transfer.nodesOf(range).nodes, (std::vector<std::uint32_t>{thin, medium, opaque}));
    const Spectrum spectrum = transfer.spectrum(range, std::vector<double>{4.0, 8.0, 3.0});
    EXPECT_TRUE(spectrum.covers(range));
    EXPECT_NEAR(spectrum.at(1e4 / 1002.5), 7.0, 1e-9);
    EXPECT_NEAR(spectrum.at(1e4 / 1007.5), 3.0, 1e-9);
    EXPECT_NEAR(spectrum.at(range.min_um), 3.0, 1e-9);
    // A range inside one bin needs its neighbour.
    const SpectralRange narrow{1e4 / 1004.5, 1e4 / 1004.0};
    EXPECT_EQ(transfer.nodesOf(narrow).nodes.size(), 3u);
    EXPECT_THROW((void)transfer.spectrum(range, std::vector<double>{4.0}), LogicError);
    EXPECT_THROW((void)transfer.nodesOf({3.0, 5.0}), LogicError);
}

TEST(RadiativeTransfer, AnswersSeveralThreadsAsOne) {
    const AtmosphericPath path{100.0, 6000.0, 15e3};
    const SunPosition sun{0.2, 0.7};
    const RadiativeTransfer alone(model(profile(288.0, 6.0)), table());
    const auto expected = alone.pathRadiance(nodes(), path, sun);
    const RadiativeTransfer shared(model(profile(288.0, 6.0)), table());
    std::vector<std::vector<double>> found(4);
    {
        std::vector<std::jthread> threads;
        for (auto& own : found) {
            threads.emplace_back([&] { own = shared.pathRadiance(nodes(), path, sun); });
        }
    }
    EXPECT_THAT(found, testing::Each(expected));
}

} // namespace
} // namespace irsg
