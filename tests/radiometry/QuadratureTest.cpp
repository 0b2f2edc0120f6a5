#include "irsg/radiometry/Quadrature.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"

using namespace irsg;

namespace {

const Band mwir = Band::topHat(3.0, 5.0);

} // namespace

TEST(SpectralQuadrature, OfOneIsTheAreaOfTheResponse) {
    const Band triangle = Band::fromResponse({{3.0, 4.0, 5.0}, {0.0, 0.8, 0.0}});
    for (const Band& band : {mwir, triangle}) {
        const SpectralQuadrature grid(band, {});
        const std::vector<double> ones(grid.size(), 1.0);
        EXPECT_NEAR(grid.integrate(ones), band.area_um(), 1e-14);
    }
}

TEST(SpectralQuadrature, IntegratesProductsOfLinesExactly) {
    const Spectrum a({2.0, 3.7, 4.1, 6.0}, {0.0, 1.0, 0.2, 0.9});
    const Spectrum b({3.0, 3.3, 5.0}, {1.0, 0.5, 0.7});
    const Spectrum c({3.0, 4.4, 4.6, 5.0}, {0.1, 0.0, 1.0, 0.3});
    const Band band = Band::fromResponse({{3.0, 4.0, 5.0}, {0.0, 0.8, 0.0}});
    const Spectrum* const breakpoints[] = {&a, &b, &c};
    const SpectralQuadrature grid(band, breakpoints);
    std::vector<double> values = grid.sampled(a);
    std::ranges::transform(values, grid.sampled(b), values.begin(), std::multiplies<>());
    const Spectrum* const factors[] = {&a, &b, &c, &band.response()};
    const double expected = integrateProduct(factors, band.range());
    EXPECT_NEAR(grid.integrate(values, grid.sampled(c)), expected, 1e-15);
}

TEST(SpectralQuadrature, IntegratesPlanckFunctionsAsTheBandRadianceDoes) {
    double worst = 0.0;
    for (const auto& [min_um, max_um] :
         {std::pair{1.9, 2.9}, {3.0, 5.0}, {8.0, 12.0}, {0.2, 40.0}}) {
        const Band band = Band::topHat(min_um, max_um);
        const SpectralQuadrature grid(band, {}, 200.0);
        for (const double temperature_K : {200.0, 250.0, 300.0, 600.0, 2000.0, 1e5}) {
            const double value = grid.integrate(grid.planck(temperature_K));
            const double truth = bandRadiance_W_m2_sr(band, temperature_K);
            worst = std::max(worst, std::abs(value / truth - 1.0));
        }
    }
    EXPECT_LT(worst, 1e-10);
    std::printf("spectral quadrature of Planck functions, 200 to 1e5 K: largest relative error "
                "%.2e\n",
                worst);
}

TEST(SpectralQuadrature, IntegratesPlanckFunctionsTimesSteepLinesTo1e10) {
    // Truth: the same product cut into 64 times as many intervals.
    const Spectrum rising({3.0, 5.0}, {0.0, 1.0});
    const Spectrum falling({3.0, 5.0}, {1.0, 0.0});
    std::vector<double> fine;
    for (int i = 0; i <= 256; ++i) {
        fine.push_back(3.0 + 2.0 * i / 256.0);
    }
    const Spectrum cuts(fine, std::vector<double>(fine.size(), 0.0));
    const Spectrum* const cut[] = {&cuts};
    const SpectralQuadrature grid(mwir, {});
    const SpectralQuadrature truth(mwir, cut);
    for (const double temperature_K : {200.0, 300.0, 2000.0}) {
        const auto integral = [&](const SpectralQuadrature& rule) {
            std::vector<double> values = rule.planck(temperature_K);
            for (const Spectrum* factor : {&rising, &falling, &rising}) {
                std::ranges::transform(values, rule.sampled(*factor), values.begin(),
                                       std::multiplies<>());
            }
            return rule.integrate(values);
        };
        EXPECT_NEAR(integral(grid) / integral(truth), 1.0, 1e-10) << temperature_K << " K";
    }
}

TEST(SpectralQuadrature, NeedsFewNodesForAPlainBand) {
    EXPECT_LE(SpectralQuadrature(mwir, {}).size(), 40u);
    EXPECT_LE(SpectralQuadrature(Band::topHat(0.2, 40.0), {}).size(), 1000u);
    EXPECT_LE(SpectralQuadrature(Band::topHat(1e-6, 40.0), {}).size(), 10000u);
}

TEST(SpectralQuadrature, NodesAscendInsideTheBand) {
    const SpectralQuadrature grid(mwir, {});
    EXPECT_TRUE(std::ranges::is_sorted(grid.wavelengths_um()));
    EXPECT_GT(grid.wavelengths_um().front(), 3.0);
    EXPECT_LT(grid.wavelengths_um().back(), 5.0);
    for (const double weight_um : grid.weights_um()) {
        EXPECT_GT(weight_um, 0.0);
    }
}

TEST(SpectralQuadrature, RefusesValuesOfAnotherGrid) {
    const SpectralQuadrature grid(mwir, {});
    const std::vector<double> tooFew(grid.size() - 1);
    const std::vector<double> right(grid.size());
    EXPECT_THROW((void)grid.integrate(tooFew), LogicError);
    EXPECT_THROW((void)grid.integrate(right, tooFew), LogicError);
    EXPECT_THROW(SpectralQuadrature(mwir, {}, 0.0), LogicError);
}
