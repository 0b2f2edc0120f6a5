#include "irsg/atmosphere/engine/AltitudeGrid.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "tests/atmosphere/SyntheticAtmosphere.h"

namespace irsg {
namespace {

using namespace syntheticatmosphere;

/// A model atmosphere whose air is warmer by `peak_K` at `peak_m`, falling off to nothing at the
/// ground and 200 m above the peak.
Profile withInversion(double peak_m, double peak_K) {
    const Profile model = Profile::model(ModelAtmosphere::usStandard1976);
    std::vector<AtmosphericState> levels = model.levels();
    for (const double z : {peak_m, peak_m + 200.0}) {
        levels.push_back(model.at(z));
    }
    levels[levels.size() - 2].temperature_K += peak_K;
    std::ranges::sort(levels, {}, &AtmosphericState::altitude_m);
    return Profile(std::move(levels), "inversion");
}

/// An ascent to 20 km whose temperature and water bend at 50 altitudes and nowhere else, as
/// `count` levels; each is off by up to `noise` of the two tolerances of the grid.
Profile ascent(std::size_t count, double noise = 0.0) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<AtmosphericState> bends;
    for (int i = 0; i < 50; ++i) {
        AtmosphericState level;
        level.altitude_m = 20e3 * i / 49.0;
        level.pressure_hPa = 1013.25 * std::exp(-level.altitude_m / 7500.0);
        level.temperature_K = std::max(290.0 - 6.5e-3 * level.altitude_m, 217.0) +
                              (i < 20 ? 0.8 * uniform(generator) : 0.0);
        level.moleFraction[static_cast<std::size_t>(Gas::H2O)] =
            0.012 *
            std::exp(-level.altitude_m / 2200.0 + (i < 20 ? 0.3 * uniform(generator) : 0.0));
        level.moleFraction[static_cast<std::size_t>(Gas::CO2)] = 4e-4;
        bends.push_back(level);
    }
    const Profile sparse(bends, "50 levels");
    std::vector<AtmosphericState> levels = bends;
    for (std::size_t i = 1; levels.size() < count; ++i) {
        levels.push_back(sparse.at(20e3 * static_cast<double>(i) / static_cast<double>(count)));
    }
    std::ranges::sort(levels, {}, &AtmosphericState::altitude_m);
    const auto isTwin = [](const AtmosphericState& a, const AtmosphericState& b) {
        return b.altitude_m - a.altitude_m < 1e-3;
    };
    levels.erase(std::unique(levels.begin(), levels.end(), isTwin), levels.end());
    for (AtmosphericState& level : levels) {
        level.temperature_K += noise * transferTemperatureTolerance_K * uniform(generator);
        level.moleFraction[static_cast<std::size_t>(Gas::H2O)] *=
            1.0 + noise * transferAmountTolerance * uniform(generator);
    }
    return Profile(std::move(levels), "ascent");
}

/// In-band radiance of the sky or the ground from `altitude_m`, W m-2 sr-1.
double seen(const RadiativeTransfer& transfer, const SpectralRange& band, double altitude_m,
            double elevation_rad) {
    const LineOfSight sight{altitude_m, elevation_rad, 0.0};
    const Spectrum spectrum =
        transfer.spectrum(band, transfer.backgroundRadiance(transfer.nodesOf(band), sight, night));
    const Spectrum* const factors[] = {&spectrum};
    return integrateProduct(factors, band);
}

TEST(AltitudeGrid, KeepTheEdgesOfACloudApart) {
    const auto altitudes_m = transferAltitudes_m(
        profile(), {particles({1000.0, 1330.0}, {0.1, 0.1}, 0.9, 0.8),
                    particles({0.0, 2000.0, 2000.4, 10e3}, {1e-4, 1e-4, 1e-5, 0.0}, 0.9, 0.7)});
    EXPECT_THAT(altitudes_m,
                testing::IsSupersetOf({0.0, 999.0, 1000.0, 1330.0, 1331.0, 10e3, 100e3}));
    EXPECT_LE(altitudes_m.size(), mostTransferAltitudes);
    for (std::size_t i = 1; i < altitudes_m.size(); ++i) {
        EXPECT_GE(altitudes_m[i] - altitudes_m[i - 1], 0.5);
    }
}

TEST(AltitudeGrid, EndWhereTheProfileEnds) {
    std::vector<AtmosphericState> levels(2);
    levels[1].altitude_m = 7.3e3;
    levels[1].pressure_hPa = 400.0;
    const auto altitudes_m = transferAltitudes_m(Profile(levels), {});
    EXPECT_EQ(altitudes_m.front(), 0.0);
    EXPECT_EQ(altitudes_m.back(), 7.3e3);
}

TEST(AltitudeGrid, ModelAtmospheresNeedNoBends) {
    const std::size_t straight = transferAltitudes_m(profile(), {}).size();
    for (int code = 1; code <= 6; ++code) {
        EXPECT_EQ(
            transferAltitudes_m(Profile::model(static_cast<ModelAtmosphere>(code)), {}).size(),
            straight)
            << code;
    }
}

TEST(AltitudeGrid, KeepsTheLevelsWhereTemperatureOrHumidityTurn) {
    EXPECT_THAT(transferAltitudes_m(withInversion(130.0, 10.0), {}),
                testing::IsSupersetOf({130.0, 330.0}));
    EXPECT_THAT(transferAltitudes_m(withInversion(6140.0, -3.0), {}),
                testing::IsSupersetOf({6140.0, 6340.0}));
    std::vector<AtmosphericState> levels = profile().levels();
    const auto layer = [&](double altitude_m, double water) {
        AtmosphericState level = profile().at(altitude_m);
        level.moleFraction[static_cast<std::size_t>(Gas::H2O)] = water;
        levels.push_back(level);
    };
    for (AtmosphericState& level : levels) {
        level.moleFraction[static_cast<std::size_t>(Gas::H2O)] = 1e-3;
    }
    layer(3310.0, 1e-3);
    layer(3340.0, 1e-5);
    layer(3430.0, 1e-5);
    layer(3460.0, 1e-3);
    std::ranges::sort(levels, {}, &AtmosphericState::altitude_m);
    EXPECT_THAT(transferAltitudes_m(Profile(levels), {}),
                testing::IsSupersetOf({3310.0, 3340.0, 3430.0, 3460.0}));
}

TEST(AltitudeGrid, MissesNoLevelOfAnAscentByMoreThanItSays) {
    const Profile air = ascent(5000, 0.5);
    const auto altitudes_m = transferAltitudes_m(air, {});
    std::vector<AtmosphericState> nodes;
    for (const double z : altitudes_m) {
        nodes.push_back(air.at(z));
    }
    const Profile thinned(nodes, "thinned");
    for (const AtmosphericState& level : air.levels()) {
        const AtmosphericState found = thinned.at(level.altitude_m);
        const double slack = std::max(1.0, transferTolerancePressure_hPa / level.pressure_hPa);
        EXPECT_LE(std::abs(found.temperature_K - level.temperature_K),
                  transferTemperatureTolerance_K * slack * 1.001)
            << level.altitude_m;
        EXPECT_LE(std::abs(std::log(found.fraction(Gas::H2O) / level.fraction(Gas::H2O))),
                  transferAmountTolerance * slack * 1.01)
            << level.altitude_m;
    }
}

TEST(AltitudeGrid, ThousandsOfLevelsCostWhatFiftyCost) {
    const auto few = transferAltitudes_m(ascent(50), {});
    const auto many = transferAltitudes_m(ascent(5000), {});
    EXPECT_EQ(many.size(), few.size());
    // However rough the ascent is, the grid stays small.
    const auto rough = transferAltitudes_m(ascent(5000, 20.0), {});
    EXPECT_LE(rough.size(), mostTransferAltitudes);

    const SpectralRange band{8.0, 12.0};
    const RadiativeTransfer sparse(model(ascent(50)), GasTable::shipped());
    const RadiativeTransfer dense(model(ascent(5000, 0.5)), GasTable::shipped());
    for (const double elevation_rad : {0.5 * pi, 0.1}) {
        EXPECT_NEAR(seen(dense, band, 0.0, elevation_rad) / seen(sparse, band, 0.0, elevation_rad),
                    1.0, 1e-3);
    }
}

TEST(AltitudeGrid, ASurfaceInversionCountsAsOnAFineGrid) {
    // Nodes of particles that are not there make the grid fine: 10 m.
    std::vector<double> fine_m;
    for (double z = 10.0; z <= 340.0; z += 10.0) {
        fine_m.push_back(z);
    }
    AtmosphericModel fine = model(withInversion(130.0, 10.0));
    fine.particles = {particles(fine_m, std::vector<double>(fine_m.size(), 0.0), 0.5, 0.5)};
    const RadiativeTransfer reference(fine, GasTable::shipped());
    const RadiativeTransfer air(model(withInversion(130.0, 10.0)), GasTable::shipped());
    const RadiativeTransfer without(model(withInversion(130.0, 0.0)), GasTable::shipped());
    for (const SpectralRange& band : {SpectralRange{3.0, 5.0}, SpectralRange{8.0, 12.0}}) {
        for (const auto& [altitude_m, elevation_rad] :
             {std::pair{0.0, 0.5 * pi}, {0.0, 0.1}, {100e3, -0.5 * pi}}) {
            const double expected = seen(reference, band, altitude_m, elevation_rad);
            EXPECT_NEAR(seen(air, band, altitude_m, elevation_rad) / expected, 1.0, 1e-3)
                << band.min_um << " um, " << altitude_m << " m, " << elevation_rad;
            // From below the inversion is seen at all.
            if (altitude_m == 0.0) {
                EXPECT_GT(expected / seen(without, band, altitude_m, elevation_rad), 1.01);
            }
        }
    }
}

} // namespace
} // namespace irsg
