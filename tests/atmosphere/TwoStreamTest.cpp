#include <cmath>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/TwoStream.h"
#include "irsg/radiometry/VectorExp.h"

namespace irsg {
namespace {

constexpr double pi = std::numbers::pi;
const double sqrt3 = std::sqrt(3.0);

struct Layer {
    double opticalDepth = 0.0;
    double albedo = 0.0;
    double asymmetry = 0.0;
};

TwoStreamLayers column(const std::vector<Layer>& layers, double surfaceAlbedo) {
    TwoStreamLayers made(layers.size(), 1);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        made.opticalDepth[i] = layers[i].opticalDepth;
        made.albedo[i] = layers[i].albedo;
        made.asymmetry[i] = layers[i].asymmetry;
    }
    made.surfaceAlbedo = {surfaceAlbedo};
    return made;
}

/// A beam of irradiance 1 through plane parallel layers.
SolarBeam beam(const TwoStreamLayers& layers, double mu0) {
    SolarBeam sun;
    sun.sinElevation = mu0;
    sun.slant.assign(layers.layers, 1.0 / mu0);
    sun.irradiance.assign(layers.layers + 1, 1.0);
    for (std::size_t i = layers.layers; i-- > 0;) {
        sun.irradiance[i] = sun.irradiance[i + 1] * std::exp(-layers.opticalDepth[i] / mu0);
    }
    return sun;
}

double net(const TwoStreamFluxes& fluxes, const SolarBeam& sun, std::size_t level) {
    return fluxes.up[level] - fluxes.down[level] - sun.sinElevation * sun.irradiance[level];
}

const std::vector<Layer> mixed = {{0.3, 0.0, 0.0},  {1e-7, 0.5, 0.3},       {2.0, 0.9, 0.45},
                                  {0.0, 0.0, 0.0},  {40.0, 0.999999, 0.46}, {1e4, 0.3, 0.2},
                                  {0.02, 1.0, 0.5}, {1e-14, 1.0, 0.0}};

TEST(TwoStream, HoldsTheFluxOfABlackBodyInAnIsothermalEnclosure) {
    for (const double albedo : {0.0, 0.3, 1.0}) {
        const TwoStreamLayers layers = column(mixed, albedo);
        const ThermalSource source{std::vector<double>(mixed.size() + 1, 7.0), {7.0}, {7.0}};
        const TwoStreamFluxes fluxes = thermalFluxes(layers, source);
        for (std::size_t level = 0; level <= mixed.size(); ++level) {
            EXPECT_NEAR(fluxes.up[level], pi * 7.0, 1e-12) << "level " << level;
            EXPECT_NEAR(fluxes.down[level], pi * 7.0, 1e-12) << "level " << level;
        }
    }
}

TEST(TwoStream, TransmitsAndEmitsAsAbsorbingAirOfKnownDepth) {
    // A slope of B over t: F+ = pi (B(0) exp(-D t) + integral), in closed form.
    for (const double t : {1e-9, 1e-3, 0.5, 3.0, 50.0}) {
        const ThermalSource source{{2.0, 5.0}, {11.0}, {}};
        const TwoStreamFluxes fluxes = thermalFluxes(column({{t, 0.0, 0.0}}, 0.0), source);
        const double x = 1.66 * t;
        const double absorbed = -std::expm1(-x);
        const double slope =
            x < 1e-4 ? x / 2.0 - x * x / 3.0 : absorbed / x - std::exp(-x); // from near to far
        EXPECT_NEAR(fluxes.up[1], pi * (11.0 * std::exp(-x) + 5.0 * absorbed + (2.0 - 5.0) * slope),
                    1e-12);
        EXPECT_NEAR(fluxes.down[0], pi * (2.0 * absorbed + (5.0 - 2.0) * slope), 1e-12);
        EXPECT_DOUBLE_EQ(fluxes.up[0], pi * 11.0);
        EXPECT_EQ(fluxes.down[1], 0.0);
    }
}

TEST(TwoStream, ReflectsAsMeadorAndWeaversSemiInfiniteLayer) {
    // Their equation 14 for infinite depth; k mu0 = 1 is where their form divides by zero.
    struct Case {
        const char* name;
        double albedo, asymmetry, mu0;
    };
    const double resonant = 1.0 / (sqrt3 * std::sqrt(0.1 * (1.0 - 0.9 * 0.3)));
    for (const Case& c :
         {Case{"isotropic", 0.9, 0.0, 0.5}, Case{"forward", 0.99, 0.45, 0.2},
          Case{"dark", 0.1, 0.1, 1.0}, Case{"nearly conservative", 1 - 1e-7, 0.4, 0.7},
          Case{"resonant", 0.9, 0.3, resonant}}) {
        const double gamma1 = sqrt3 * (1.0 - 0.5 * c.albedo * (1.0 + c.asymmetry));
        const double gamma2 = sqrt3 * 0.5 * c.albedo * (1.0 - c.asymmetry);
        const double gamma3 = 0.5 * (1.0 - sqrt3 * c.asymmetry * c.mu0);
        const double k = std::sqrt(gamma1 * gamma1 - gamma2 * gamma2);
        const double alpha2 = gamma1 * gamma3 + gamma2 * (1.0 - gamma3);
        const double expected =
            c.albedo * (alpha2 + k * gamma3) / ((1.0 + k * c.mu0) * (k + gamma1));
        TwoStreamLayers layers = column({{1e6, c.albedo, c.asymmetry}}, 0.5);
        SolarBeam sun = beam(layers, std::min(c.mu0, 1.0));
        sun.sinElevation = c.mu0;
        sun.slant = {1.0 / c.mu0};
        EXPECT_NEAR(solarFluxes(layers, sun).up[1] / c.mu0, expected, 1e-8) << c.name;
    }
}

TEST(TwoStream, ReflectsAsMeadorAndWeaversFiniteLayer) {
    // Their equations 14 and 15 at moderate depth, and 24 for conservative scattering:
    // R = (g1 t + (g3 - g1 mu0) (1 - exp(-t / mu0))) / (1 + g1 t).
    const double t = 1.3, mu0 = 0.6, g = 0.35;
    const double gamma1 = sqrt3 / 2.0 * (1.0 - g), gamma3 = 0.5 * (1.0 - sqrt3 * g * mu0);
    const double conservative =
        (gamma1 * t + (gamma3 - gamma1 * mu0) * -std::expm1(-t / mu0)) / (1.0 + gamma1 * t);
    const TwoStreamLayers layers = column({{t, 1.0, g}}, 0.0);
    const TwoStreamFluxes fluxes = solarFluxes(layers, beam(layers, mu0));
    EXPECT_NEAR(fluxes.up[1] / mu0, conservative, 1e-9);
    EXPECT_NEAR(fluxes.down[0] / mu0, 1.0 - conservative - std::exp(-t / mu0), 1e-9);

    const double w = 0.8;
    const double a1 = sqrt3 * (1.0 - 0.5 * w * (1.0 + g)), a2 = sqrt3 * 0.5 * w * (1.0 - g);
    const double k = std::sqrt(a1 * a1 - a2 * a2);
    const double gamma4 = 1.0 - gamma3;
    const double alpha1 = a1 * gamma4 + a2 * gamma3, alpha2 = a1 * gamma3 + a2 * gamma4;
    const double denominator =
        (1.0 - k * k * mu0 * mu0) * ((k + a1) * std::exp(k * t) + (k - a1) * std::exp(-k * t));
    const double R = w / denominator *
                     ((1.0 - k * mu0) * (alpha2 + k * gamma3) * std::exp(k * t) -
                      (1.0 + k * mu0) * (alpha2 - k * gamma3) * std::exp(-k * t) -
                      2.0 * k * (gamma3 - alpha2 * mu0) * std::exp(-t / mu0));
    const double T = -w / denominator * std::exp(-t / mu0) *
                     ((1.0 + k * mu0) * (alpha1 + k * gamma4) * std::exp(k * t) -
                      (1.0 - k * mu0) * (alpha1 - k * gamma4) * std::exp(-k * t) -
                      2.0 * k * (gamma4 + alpha1 * mu0) * std::exp(t / mu0));
    const TwoStreamLayers grey = column({{t, w, g}}, 0.0);
    const TwoStreamFluxes found = solarFluxes(grey, beam(grey, mu0));
    EXPECT_NEAR(found.up[1] / mu0, R, 1e-12);
    EXPECT_NEAR(found.down[0] / mu0, T, 1e-12);
}

/// Chandrasekhar's H function of isotropic scattering by iteration: 1 / H(mu) = sqrt(1 - w) +
/// w / 2 integral of mu' H(mu') / (mu + mu').
double chandrasekharH(double w, double mu) {
    std::vector<double> nodes, weights, H;
    constexpr int count = 200;
    for (int i = 0; i < count; ++i) { // midpoints of a stretched axis
        const double u = (i + 0.5) / count;
        nodes.push_back(u * u);
        weights.push_back(2.0 * u / count);
    }
    H.assign(nodes.size(), 1.0);
    auto reciprocal = [&](double at) {
        double sum = 0.0;
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            sum += weights[j] * nodes[j] * H[j] / (at + nodes[j]);
        }
        return std::sqrt(1.0 - w) + 0.5 * w * sum;
    };
    for (int step = 0; step < 200; ++step) {
        std::vector<double> next;
        for (std::size_t i = 0; i < nodes.size(); ++i) { // half way, or it swings
            next.push_back(0.5 * (H[i] + 1.0 / reciprocal(nodes[i])));
        }
        H = next;
    }
    return 1.0 / reciprocal(mu);
}

TEST(TwoStream, ComesNearTheExactAlbedoOfIsotropicScattering) {
    // A semi-infinite atmosphere reflects 1 - sqrt(1 - w) H(mu0) (Chandrasekhar 1960, section 38).
    EXPECT_NEAR(chandrasekharH(1.0, 1.0), 2.9078, 2e-3); // his table XI
    for (const double w : {0.5, 0.9, 0.99}) {
        for (const double mu0 : {0.2, 0.5, 1.0}) {
            const TwoStreamLayers layers = column({{1e5, w, 0.0}}, 0.0);
            const double exact = 1.0 - std::sqrt(1.0 - w) * chandrasekharH(w, mu0);
            const double found = solarFluxes(layers, beam(layers, mu0)).up[1] / mu0;
            EXPECT_NEAR(found, exact, 0.035) << "w " << w << " mu0 " << mu0;
        }
    }
}

TEST(TwoStream, KeepsTheNetFluxOfTheSunWithoutAbsorption) {
    const std::vector<Layer> layers = {{1e-8, 1.0, 0.1}, {3.0, 1.0, 0.5}, {1e4, 1.0, 0.45},
                                       {0.0, 1.0, 0.0},  {0.7, 1.0, 0.0}, {1e-3, 1.0, 0.5}};
    for (const double albedo : {0.0, 0.4, 1.0}) {
        for (const double mu0 : {1.0, 1.0 / sqrt3, 0.3, 0.01}) {
            const TwoStreamLayers air = column(layers, albedo);
            const SolarBeam sun = beam(air, mu0);
            const TwoStreamFluxes fluxes = solarFluxes(air, sun);
            const double first = net(fluxes, sun, 0);
            for (std::size_t level = 1; level <= layers.size(); ++level) {
                EXPECT_NEAR(net(fluxes, sun, level), first, 1e-7 * mu0) << level;
            }
        }
    }
}

TEST(TwoStream, KeepsTheNetFluxOfHeatWithoutAbsorption) {
    const TwoStreamLayers air = column({{2.0, 1.0, 0.3}, {1e4, 1.0, 0.5}, {1e-6, 1.0, 0.0}}, 0.25);
    const TwoStreamFluxes fluxes = thermalFluxes(air, {{9.0, 7.0, 1.0, 3.0}, {10.0}, {}});
    const double first = fluxes.up[0] - fluxes.down[0];
    EXPECT_GT(first, 0.0);
    for (std::size_t level = 1; level < 4; ++level) {
        EXPECT_NEAR(fluxes.up[level] - fluxes.down[level], first, 1e-9) << level;
    }
}

TEST(TwoStream, DoesNotNoticeWhereALayerIsCutOrATransparentOneIsPutIn) {
    const double mu0 = 0.4;
    struct Case {
        const char* name;
        std::vector<Layer> layers;
        std::vector<double> planck;
        std::vector<std::size_t> same; ///< levels that the plain column has, too
    };
    const Layer first{1.5, 0.7, 0.3}, second{0.2, 0.95, 0.45};
    const auto part = [](Layer layer, double share) {
        layer.opticalDepth *= share;
        return layer;
    };
    const Case plain{"plain", {first, second}, {4.0, 2.0, 1.0}, {0, 1, 2}};
    for (const Case& c :
         {Case{"cut",
               {part(first, 0.25), part(first, 0.75), second},
               {4.0, 3.5, 2.0, 1.0},
               {0, 2, 3}},
          Case{"thin slice",
               {part(first, 1e-9), part(first, 1.0 - 1e-9), second},
               {4.0, 4.0 - 2e-9, 2.0, 1.0},
               {0, 2, 3}},
          Case{"transparent", {first, {0.0, 1.0, 0.5}, second}, {4.0, 2.0, 2.0, 1.0}, {0, 1, 3}}}) {
        const TwoStreamLayers one = column(plain.layers, 0.3), other = column(c.layers, 0.3);
        const TwoStreamFluxes heat = thermalFluxes(one, {plain.planck, {5.0}, {}});
        const TwoStreamFluxes heatCut = thermalFluxes(other, {c.planck, {5.0}, {}});
        const TwoStreamFluxes light = solarFluxes(one, beam(one, mu0));
        const TwoStreamFluxes lightCut = solarFluxes(other, beam(other, mu0));
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(heatCut.up[c.same[i]], heat.up[i], 1e-12) << c.name << i;
            EXPECT_NEAR(heatCut.down[c.same[i]], heat.down[i], 1e-12) << c.name << i;
            EXPECT_NEAR(lightCut.up[c.same[i]], light.up[i], 1e-12) << c.name << i;
            EXPECT_NEAR(lightCut.down[c.same[i]], light.down[i], 1e-12) << c.name << i;
        }
    }
}

TEST(TwoStream, LooksTheSameFromBothSidesOfASymmetricSlab) {
    const TwoStreamLayers air = column({{1.0, 0.6, 0.4}, {0.3, 0.1, 0.2}, {1.0, 0.6, 0.4}}, 0.0);
    const TwoStreamFluxes fluxes = thermalFluxes(air, {{3.0, 5.0, 5.0, 3.0}, {0.0}, {}});
    for (std::size_t level = 0; level < 4; ++level) {
        EXPECT_NEAR(fluxes.up[level], fluxes.down[3 - level], 1e-13);
    }
}

TEST(TwoStream, IsLinearInDepthWhereItIsThin) {
    for (const double t : {1e-6, 1e-9, 1e-12}) {
        const TwoStreamLayers thin = column({{t, 0.6, 0.25}}, 0.0);
        const double mu0 = 0.5;
        EXPECT_NEAR(solarFluxes(thin, beam(thin, mu0)).up[1] /
                        (0.6 * 0.5 * (1.0 - sqrt3 * 0.25 * mu0) * t),
                    1.0, 1e-5);
        EXPECT_NEAR(thermalFluxes(thin, {{8.0, 8.0}, {0.0}, {}}).up[1] /
                        (pi * 1.66 * 0.4 * 8.0 * t),
                    1.0, 1e-5);
    }
}

TEST(TwoStream, SolvesColumnsSideBySideAsAlone) {
    TwoStreamLayers both(2, 2);
    both.opticalDepth = {0.1, 2.0, 0.3, 4.0};
    both.albedo = {0.2, 0.9, 0.4, 0.8};
    both.asymmetry = {0.1, 0.4, 0.2, 0.3};
    both.surfaceAlbedo = {0.1, 0.6};
    const TwoStreamFluxes fluxes = thermalFluxes(both, {{1, 2, 3, 4, 5, 6}, {7, 8}, {}});
    const TwoStreamFluxes alone =
        thermalFluxes(column({{2.0, 0.9, 0.4}, {4.0, 0.8, 0.3}}, 0.6), {{2, 4, 6}, {8}, {}});
    for (std::size_t level = 0; level < 3; ++level) {
        EXPECT_DOUBLE_EQ(fluxes.up[2 * level + 1], alone.up[level]);
        EXPECT_DOUBLE_EQ(fluxes.down[2 * level + 1], alone.down[level]);
    }
}

TEST(VectorExp, AgreesWithTheLibraryToItsLastDigits) {
    for (double x = 1e-12; x < 600.0; x *= 1.37) {
        for (const double signedX : {x, -x}) {
            EXPECT_NEAR(vectorExpm1(signedX) / std::expm1(signedX), 1.0, 1e-15) << signedX;
        }
    }
    EXPECT_EQ(vectorExpm1(0.0), 0.0);
    EXPECT_EQ(vectorAbsorbed(1e9), 1.0);
    for (double x = -600.0; x < 600.0; x += 1.37) {
        EXPECT_NEAR(vectorExp(x) / std::exp(x), 1.0, 1e-15) << x;
    }
}

TEST(VectorExp, AgreesWithTheLibraryInSinglePrecision) {
    for (float x = -86.9f; x < 87.9f; x += 0.0137f) {
        EXPECT_NEAR(static_cast<double>(vectorExp(x)) / std::exp(static_cast<double>(x)), 1.0, 2e-7)
            << x;
    }
    EXPECT_EQ(vectorExp(0.0f), 1.0f);
    EXPECT_EQ(vectorExp(-1000.0f), vectorExp(-87.0f));
}

} // namespace
} // namespace irsg
