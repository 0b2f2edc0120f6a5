#include "irsg/gas/GasThroughAir.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace irsg;

namespace {

AtmosphericState humidAir() {
    AtmosphericState air;
    air.temperature_K = 294.0;
    air.moleFraction[static_cast<std::size_t>(Gas::H2O)] = 0.0188;
    air.moleFraction[static_cast<std::size_t>(Gas::CO2)] = 4e-4;
    return air;
}

GasLayer hotWater(double length_m = 1.0) {
    GasLayer layer;
    layer.temperature_K = 700.0;
    layer.length_m = length_m;
    layer.fraction(HotGas::H2O) = 0.05;
    return layer;
}

std::vector<LineCorrelation> correlationsOf(const GasRequest& request, double range_m) {
    return lineCorrelations(request, gasSpectrum(request).cells, humidAir(), range_m);
}

/// Radiance through the air, with the coincidence of lines and as the product, over a band. The
/// transmittance of the air is that of a cold layer.
std::pair<double, double> throughAir(const GasRequest& request, double range_m) {
    const GasSpectrum spectrum = gasSpectrum(request);
    GasLayer cold;
    cold.temperature_K = 294.0;
    cold.length_m = range_m;
    cold.fraction(HotGas::H2O) = 0.0188;
    cold.fraction(HotGas::CO2) = 4e-4;
    GasRequest before = request;
    before.layers = {cold};
    const GasSpectrum air = gasSpectrum(before);
    const auto correlations = correlationsOf(request, range_m);
    double with = 0.0, product = 0.0;
    for (std::size_t i = 0; i < correlations.size(); ++i) {
        const GasSpectrum::Cell& cell = spectrum.cells[i];
        const double plain = cell.radiance_W_m2_sr_um * air.cells[i].transmittance *
                             (cell.upper_per_cm - cell.lower_per_cm);
        product += plain;
        with += plain * correlations[i].radiance;
    }
    return {with, product};
}

TEST(GasThroughAir, OfWaterIsLessThanTheProductOfMeans) {
    // Line by line of both, 5 cm-1 at a time: 0.392 of the products at 1 km, 0.308 at 5 km
    // (HotGasTruth).
    for (const auto& [range_m, expected] :
         std::vector<std::pair<double, double>>{{1000.0, 0.392}, {5000.0, 0.308}}) {
        const GasRequest request{.layers = {hotWater()}, .band = {1e4 / 2200.0, 5.0}};
        const GasSpectrum spectrum = gasSpectrum(request);
        const auto correlations = correlationsOf(request, range_m);
        ASSERT_EQ(correlations.size(), spectrum.cells.size());
        for (const LineCorrelation& correlation : correlations) {
            EXPECT_GT(correlation.radiance, 0.0);
            EXPECT_LT(correlation.radiance, 1.0);
            EXPECT_GT(correlation.transmittance, 1.0) << "what is clear is clear for both";
        }
        const auto [with, product] = throughAir(request, range_m);
        EXPECT_NEAR(with / product, expected, 0.1 * expected) << range_m;
    }
}

TEST(GasThroughAir, OfNoAirIsTheProduct) {
    const GasRequest request{.layers = {hotWater()}, .band = {3.0, 5.0}};
    for (const LineCorrelation& correlation : correlationsOf(request, 0.0)) {
        EXPECT_NEAR(correlation.radiance, 1.0, 1e-9);
        EXPECT_NEAR(correlation.transmittance, 1.0, 1e-9);
    }
}

TEST(GasThroughAir, OfWhatHasNoLinesIsTheProduct) {
    GasLayer soot;
    soot.temperature_K = 900.0;
    soot.length_m = 0.5;
    soot.soot_ppmv = 0.3;
    const GasRequest request{.layers = {soot}, .band = {3.0, 5.0}};
    for (const LineCorrelation& correlation : correlationsOf(request, 2000.0)) {
        EXPECT_NEAR(correlation.radiance, 1.0, 5e-3);
    }
    // Nor has anything where no sample stands.
    const GasRequest between{.layers = {hotWater()}, .band = {5.5, 7.0}};
    for (const LineCorrelation& correlation : correlationsOf(between, 1000.0)) {
        EXPECT_EQ(correlation.radiance, 1.0);
    }
}

TEST(GasThroughAir, IsThatOfTheWholeForALayerCutInTwo) {
    const GasRequest whole{.layers = {hotWater()}, .band = {3.0, 5.0}, .background_K = 400.0};
    const GasRequest halves{
        .layers = {hotWater(0.5), hotWater(0.5)}, .band = {3.0, 5.0}, .background_K = 400.0};
    const auto one = correlationsOf(whole, 1000.0), two = correlationsOf(halves, 1000.0);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_NEAR(two[i].radiance, one[i].radiance, 1e-6 * one[i].radiance);
        EXPECT_NEAR(two[i].transmittance, one[i].transmittance, 1e-6 * one[i].transmittance);
    }
}

TEST(GasThroughAir, IsTheSameRadianceInCellsOfAnyWidth) {
    const auto with = [](double step_per_cm) {
        return throughAir({.layers = {hotWater()}, .band = {4.6, 4.9}, .step_per_cm = step_per_cm},
                          1000.0)
            .first;
    };
    // Cells of 1 cm-1 have the ratio of the 5 cm-1 around them, which spectra vary within.
    const double expected = with(5.0);
    for (const double step_per_cm : {1.0, 2.5, 10.0, 25.0}) {
        EXPECT_NEAR(with(step_per_cm), expected, 0.15 * expected) << step_per_cm;
    }
}

} // namespace
