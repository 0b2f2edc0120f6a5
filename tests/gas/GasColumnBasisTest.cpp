#include "irsg/gas/GasColumnBasis.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/radiometry/Planck.h"

using namespace irsg;

namespace {

GasLayer gas(double temperature_K, double co2, double h2o) {
    GasLayer layer;
    layer.temperature_K = temperature_K;
    layer.fraction(HotGas::CO2) = co2;
    layer.fraction(HotGas::H2O) = h2o;
    return layer;
}

std::vector<double> wavenumbers_per_cm() {
    std::vector<double> all;
    for (double n = 1900.0; n <= 4100.0; n += 20.0) {
        all.push_back(n);
    }
    return all;
}

/// Lines through cold gas about hot gas, off its middle and cut off, by a sequence without chance.
std::vector<GasLine> lines(int count) {
    std::vector<GasLine> all;
    for (int i = 0; i < count; ++i) {
        const double off = std::fmod(0.618034 * i, 1.0), cut = std::fmod(0.414214 * i, 1.0);
        const double outer_m = std::sqrt(1.0 - off * off),
                     inner_m = off < 0.5 ? std::sqrt(0.25 - off * off) : 0.0;
        GasLine line{{0, outer_m - inner_m}};
        if (inner_m > 0.0) {
            line.push_back({1, 2.0 * inner_m * (i % 2 == 0 ? 1.0 : cut)});
        }
        if (i % 2 == 0) {
            line.push_back({0, outer_m - inner_m});
        }
        all.push_back(line);
    }
    return all;
}

double radiance(const GasColumns& columns, const std::vector<GasLayer>& gases,
                const GasLine& line) {
    double sum = 0.0;
    const auto shares = columns.shares(line);
    for (std::size_t g = 0; g < gases.size(); ++g) {
        for (std::size_t i = 0; i < shares[g].size(); ++i) {
            const double um = 1e4 / columns.wavenumbers_per_cm()[i];
            sum += shares[g][i] * um * um * planckRadiance_W_m2_sr_um(um, gases[g].temperature_K);
        }
    }
    return sum;
}

TEST(GasColumnBasis, MakesLinesItHasNotSeenOfFewColumns) {
    const std::vector<GasLayer> gases{gas(400.0, 0.01, 0.02), gas(900.0, 0.04, 0.05)};
    const GasColumnBasis basis(gases, wavenumbers_per_cm(), lines(400));
    EXPECT_LE(basis.columns().size(), 32U);
    EXPECT_LT(basis.error().rms, 0.002);
    EXPECT_LT(std::abs(basis.error().mean), 0.001);
    const GasColumns columns(gases, wavenumbers_per_cm());
    std::vector<double> weights(basis.columns().size());
    for (const GasLine& line :
         std::vector<GasLine>{{{0, 0.55}, {1, 0.9}, {0, 0.55}}, {{0, 0.9}}, {{0, 0.4}, {1, 0.3}}}) {
        GasColumnBasis::Line followed(basis);
        for (const GasStretch& stretch : line) {
            // In pieces, as walls of other zones cut it.
            followed.add(stretch.gas, 0.25 * stretch.length_m);
            followed.add(stretch.gas, 0.75 * stretch.length_m);
        }
        basis.weightsOf(followed, weights);
        double sum = 0.0;
        for (std::size_t k = 0; k < weights.size(); ++k) {
            sum += weights[k] * radiance(columns, gases, basis.columns()[k]);
        }
        EXPECT_NEAR(sum / radiance(columns, gases, line), 1.0, 0.004);
    }
}

/// What lines let through of 1, by fronts less by all columns: rms over wavenumbers, of the line
/// that is farthest off.
double offByFronts(const GasColumnBasis& basis, const std::vector<GasLayer>& gases,
                   const GasColumnBasis::Fronts& fronts) {
    const GasColumns columns(gases, wavenumbers_per_cm());
    const auto addStopped = [&](const GasLine& line, double weight, std::vector<double>& sums) {
        for (const std::vector<double>& share : columns.shares(line)) {
            for (std::size_t i = 0; i < sums.size(); ++i) {
                sums[i] += weight * share[i];
            }
        }
    };
    std::vector<double> ofColumns(basis.columns().size()), ofFronts(fronts.columns.size());
    double most = 0.0;
    for (const GasLine& line :
         std::vector<GasLine>{{{0, 0.55}, {1, 0.9}, {0, 0.55}}, {{0, 0.9}}, {{0, 0.4}, {1, 0.3}}}) {
        GasColumnBasis::Line followed(basis);
        for (const GasStretch& stretch : line) {
            followed.add(stretch.gas, stretch.length_m);
        }
        std::vector<double> values(basis.valuesOfLine());
        followed.fillValues(values);
        basis.weightsOf(values, ofColumns);
        fronts.weightsOf(values, ofFronts);
        std::vector<double> off(wavenumbers_per_cm().size());
        for (std::size_t k = 0; k < ofColumns.size(); ++k) {
            addStopped(basis.columns()[k], -ofColumns[k], off);
        }
        for (std::size_t m = 0; m < ofFronts.size(); ++m) {
            addStopped(basis.columns()[fronts.columns[m]], ofFronts[m], off);
        }
        const double squares = std::inner_product(off.begin(), off.end(), off.begin(), 0.0);
        most = std::max(most, std::sqrt(squares / static_cast<double>(off.size())));
    }
    // None of no gas.
    fronts.weightsOf(std::vector<double>(basis.valuesOfLine(), 0.0), ofFronts);
    EXPECT_EQ(std::ranges::count(ofFronts, 0.0), static_cast<std::ptrdiff_t>(ofFronts.size()));
    return most;
}

TEST(GasColumnBasis, LetsThroughWhatItsColumnsDoByFewerFronts) {
    const std::vector<GasLayer> gases{gas(400.0, 0.01, 0.02), gas(900.0, 0.04, 0.05)};
    const GasColumnBasis basis(gases, wavenumbers_per_cm(), lines(400));
    ASSERT_LE(basis.fronts().columns.size(), 14U);
    ASSERT_LT(basis.fronts().columns.size(), basis.columns().size());
    EXPECT_LT(offByFronts(basis, gases, basis.fronts()), 1e-3);
}

TEST(GasColumnBasis, LetsThroughNearlyThatByTheFirstFrontsAlone) {
    const std::vector<GasLayer> gases{gas(400.0, 0.01, 0.02), gas(900.0, 0.04, 0.05)};
    const GasColumnBasis basis(gases, wavenumbers_per_cm(), lines(400));
    const std::vector<std::size_t>& few = basis.reflectionFronts().columns;
    ASSERT_LE(few.size(), 10U);
    ASSERT_LE(few.size(), basis.fronts().columns.size());
    EXPECT_TRUE(std::ranges::equal(few, std::span(basis.fronts().columns).first(few.size())));
    const double off = offByFronts(basis, gases, basis.reflectionFronts());
    EXPECT_LT(off, 1e-3);
    EXPECT_GT(off, 1e-6); // or all that are taken count nothing
}

TEST(GasColumnBasis, GivesNoGasNoWeight) {
    const std::vector<GasLayer> gases{gas(400.0, 0.01, 0.02), gas(900.0, 0.04, 0.05)};
    const GasColumnBasis basis(gases, wavenumbers_per_cm(), lines(200));
    std::vector<double> weights(basis.columns().size(), 1.0);
    GasColumnBasis::Line line(basis);
    basis.weightsOf(line, weights);
    for (const double weight : weights) {
        EXPECT_EQ(weight, 0.0);
    }
    // A thin line has half of the weights of one twice as long.
    line.add(1, 1e-6);
    basis.weightsOf(line, weights);
    std::vector<double> twice(weights.size());
    line.add(1, 1e-6);
    basis.weightsOf(line, twice);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        EXPECT_NEAR(twice[k], 2.0 * weights[k], 5e-4 * std::abs(weights[k]) + 1e-9);
    }
}

TEST(GasColumnBasis, OfGasThatAbsorbsNothingHasNoColumns) {
    const GasColumnBasis basis({gas(900.0, 0.0, 0.0)}, wavenumbers_per_cm(), {{{0, 1.0}}});
    EXPECT_TRUE(basis.columns().empty());
    GasColumnBasis::Line line(basis);
    line.add(0, 1.0);
    basis.weightsOf(line, {});
}

} // namespace
