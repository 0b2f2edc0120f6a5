#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "irsg/atmosphere/engine/DiffuseLight.h"
#include "irsg/atmosphere/engine/NodeColumn.h"
#include "irsg/atmosphere/engine/ParticleParts.h"
#include "irsg/atmosphere/engine/RadiativeTransfer.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "tests/atmosphere/DiscreteOrdinates.h"

namespace irsg {
namespace {

constexpr double pi = std::numbers::pi;

const std::vector<OrdinateLayer> mixed = {{0.3, 0.9, 0.7, 5.0, 4.0},
                                          {2.0, 0.5, 0.3, 4.0, 2.0},
                                          {1e-9, 0.5, 0.3, 2.0, 2.0},
                                          {0.7, 0.999, 0.8, 2.0, 1.0}};

TEST(DiscreteOrdinates, EmitsAsAbsorbingAirOfKnownDepth) {
    // 2 pi times the integral of mu (1 - exp(-t / mu)): the third exponential integral.
    const GaussRule& rule = gaussLegendre(32);
    for (const double t : {1e-3, 0.1, 1.0, 5.0}) {
        double flux = 0.0;
        for (int part = 0; part < 64; ++part) {
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double mu = (static_cast<double>(part) + rule.nodes[i]) / 64.0;
                flux += 2.0 * pi * mu * -std::expm1(-t / mu) * rule.weights[i] / 64.0;
            }
        }
        const DiscreteOrdinates air({{t, 0.0, 0.0, 3.0, 3.0}}, 0.0, 0.0);
        EXPECT_NEAR(air.down[0] / (3.0 * flux), 1.0, 2e-3) << t; // of eight points
        EXPECT_NEAR(air.up[1] / (3.0 * flux), 1.0, 2e-3) << t;   // of eight points
    }
}

TEST(DiscreteOrdinates, AreIsotropicInDeepAirOfOneTemperature) {
    for (const double albedo : {0.0, 0.4, 1.0}) {
        const DiscreteOrdinates air(
            {{0.3, 0.9, 0.7, 2.0, 2.0}, {5.0, 0.5, 0.3, 2.0, 2.0}, {60.0, 0.2, 0.8, 2.0, 2.0}},
            albedo, 2.0);
        for (const std::size_t level : {0u, 1u, 2u}) {
            EXPECT_NEAR(air.up[level], 2.0 * pi, 1e-6);
            EXPECT_NEAR(air.down[level], 2.0 * pi, 1e-6);
            EXPECT_NEAR(air.mean[level], 2.0, 1e-6);
            for (const double cosine : {-1.0, -0.3, 0.0, 0.9}) {
                EXPECT_NEAR(air.scattered(level, cosine), 2.0, 1e-6);
            }
        }
    }
}

TEST(DiscreteOrdinates, ReflectAsChandrasekharsDeepIsotropicAir) {
    // Plane albedo 1 - H(mu0) sqrt(1 - w), with his integral equation for H, solved by iteration.
    const GaussRule& rule = gaussLegendre(32);
    for (const double w : {0.3, 0.9, 0.99}) {
        const auto hAt = [&](const std::vector<double>& h, double mu) {
            double sum = 0.0;
            for (std::size_t i = 0; i < h.size(); ++i) {
                sum += rule.weights[i] * rule.nodes[i] * h[i] / (mu + rule.nodes[i]);
            }
            return 1.0 / (std::sqrt(1.0 - w) + 0.5 * w * sum);
        };
        std::vector<double> h(rule.nodes.size(), 1.0);
        for (int pass = 0; pass < 200; ++pass) {
            const std::vector<double> before = h;
            for (std::size_t i = 0; i < h.size(); ++i) {
                h[i] = hAt(before, rule.nodes[i]);
            }
        }
        for (const double mu0 : {0.2, 0.5, 1.0}) {
            const DiscreteOrdinates air({{400.0, w, 0.0}}, 0.0, 0.0, 1.0, mu0);
            EXPECT_NEAR(air.up[1] / mu0, 1.0 - hAt(h, mu0) * std::sqrt(1.0 - w), 5e-5)
                << w << ", " << mu0;
        }
    }
}

TEST(DiscreteOrdinates, LoseNoLightWhereNothingAbsorbs) {
    for (const double g : {0.0, 0.45, 0.8}) {
        const std::vector<OrdinateLayer> layers = {{1.3, 1.0, g}, {0.2, 1.0, 0.1}};
        const double mu0 = 0.6, peak = std::pow(g, 16.0), other = std::pow(0.1, 16.0);
        const double direct = mu0 * std::exp(-(1.3 * (1.0 - peak) + 0.2 * (1.0 - other)) / mu0);
        const DiscreteOrdinates black(layers, 0.0, 0.0, 1.0, mu0);
        EXPECT_NEAR(black.up[2] + black.down[0] + direct, mu0, 1e-6) << g;
        const DiscreteOrdinates white(layers, 1.0, 0.0, 1.0, mu0);
        EXPECT_NEAR(white.up[2], mu0, 1e-5) << g;
    }
}

TEST(DiscreteOrdinates, DoNotNoticeWhereALayerIsCut) {
    const DiscreteOrdinates whole(mixed, 0.3, 6.0, 2.0, 0.4);
    std::vector<OrdinateLayer> cut = mixed;
    const double third = 4.0 + (2.0 - 4.0) / 3.0;
    cut[1] = {2.0 / 3.0, 0.5, 0.3, 4.0, third};
    cut.insert(cut.begin() + 2, {4.0 / 3.0, 0.5, 0.3, third, 2.0});
    const DiscreteOrdinates pieces(cut, 0.3, 6.0, 2.0, 0.4);
    for (std::size_t level = 0; level <= mixed.size(); ++level) {
        const std::size_t same = level > 1 ? level + 1 : level;
        EXPECT_NEAR(pieces.up[same], whole.up[level], 1e-6);
        EXPECT_NEAR(pieces.down[same], whole.down[level], 1e-6);
        EXPECT_NEAR(pieces.mean[same], whole.mean[level], 1e-6);
    }
}

/// Thermal light near the ground at some nodes of 3.5 to 4.15 um.
class HazyGround {
  public:
    HazyGround(ModelAtmosphere model, double visibility_m)
        : air_{Profile::model(model), {}}, gases_(GasTable::shipped()) {
        ParticleSettings particles;
        particles.visibility_m = visibility_m;
        air_.particles = particleLayers(particles, air_.profile);
        const RadiativeTransfer transfer(air_, gases_);
        const NodeSet all = transfer.nodesOf({3.5, 4.15});
        for (std::size_t i = 0; i < all.nodes.size(); i += 53) {
            set_.nodes.push_back(all.nodes[i]);
            set_.wavenumbers_per_cm.push_back(all.wavenumbers_per_cm[i]);
        }
    }
    /// Of a level path at the ground as the engine has it at night, summed over the nodes.
    double pathRadiance(ScatteringMode mode, double range_m) const {
        AtmosphericModel air = air_;
        air.scattering = mode;
        const RadiativeTransfer transfer(air, gases_);
        double sum = 0.0;
        for (const double value :
             transfer.pathRadiance(set_, {1.0, 1.0, range_m}, SunPosition{0.0, -0.6})) {
            sum += value;
        }
        return sum;
    }
    /// The same with what 16 streams scatter into the path, and what two do, and the ratios of
    /// fluxes of two to those of 16 at the ground.
    struct Sums {
        double reference = 0.0, twoStream = 0.0;
        double down = 0.0, downTwoStream = 0.0;
        double mean = 0.0, meanTwoStream = 0.0;
    };
    Sums sums(double range_m) const {
        const AtmosphericColumn column(air_.profile, air_.particles, gases_);
        const NodeColumn nodes(column, set_.nodes, set_.wavenumbers_per_cm, 5.0);
        const DiffuseLight light(nodes, {air_.groundTemperature_K, air_.groundAlbedo});
        const auto thermal = light.thermal();
        std::vector<double> ground(nodes.size());
        nodes.planckAt(air_.groundTemperature_K, ground);
        Sums all;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            std::vector<OrdinateLayer> layers;
            for (std::size_t k = 0; k + 1 < column.levelCount(); ++k) {
                const auto mean = [&](std::span<const float> below, std::span<const float> above) {
                    return 0.5 * (static_cast<double>(below[i]) + static_cast<double>(above[i]));
                };
                const double e = mean(nodes.extinction(k), nodes.extinction(k + 1));
                const double s = mean(nodes.scattering(k), nodes.scattering(k + 1));
                const double m = mean(nodes.asymmetry(k), nodes.asymmetry(k + 1));
                layers.push_back({e * (column.altitudes_m()[k + 1] - column.altitudes_m()[k]),
                                  e > 0.0 ? std::min(s / e, 1.0) : 0.0, s > 0.0 ? m / s : 0.0,
                                  nodes.planck(k)[i], nodes.planck(k + 1)[i]});
            }
            const double albedo =
                std::clamp(air_.groundAlbedo.at(1e4 / set_.wavenumbers_per_cm[i]), 0.0, 1.0);
            const DiscreteOrdinates streams(layers, albedo, ground[i]);

            const double e = static_cast<double>(nodes.extinction(0)[i]);
            const double s = static_cast<double>(nodes.scattering(0)[i]);
            const double g = static_cast<double>(nodes.asymmetry(0)[i]) / s;
            const double peak = std::pow(g, 16.0), planck = nodes.planck(0)[i];
            // What is sent on straight ahead is the light of the level line of sight itself.
            const double scaled =
                ((e - s) * planck + s * (1.0 - peak) * streams.scattered(0, 0.0)) / (e - s * peak);
            const double source = ((e - s) * planck +
                                   s * ((1.0 - peak) * streams.scattered(0, 0.0) + peak * scaled)) /
                                  e;
            const double twoMean = (thermal->up[i] + thermal->down[i]) / (2.0 * pi);
            const double opacity = -std::expm1(-e * range_m);
            all.reference += source * opacity;
            all.twoStream += ((e - s) * planck + s * twoMean) / e * opacity;
            all.down += streams.down[0];
            all.downTwoStream += thermal->down[i];
            all.mean += streams.mean[0];
            all.meanTwoStream += twoMean;
        }
        return all;
    }

  private:
    AtmosphericModel air_;
    std::shared_ptr<const GasTable> gases_;
    NodeSet set_;
};

TEST(DiscreteOrdinates, SettleTheThermalPathRadianceOfHazyAir) {
    for (const auto& [model, name] :
         {std::pair{ModelAtmosphere::usStandard1976, "US standard"},
          std::pair{ModelAtmosphere::tropical, "tropical"},
          std::pair{ModelAtmosphere::subarcticWinter, "subarctic winter"}}) {
        for (const double visibility_m : {5e3, 23e3}) {
            const HazyGround air(model, visibility_m);
            const HazyGround::Sums sums = air.sums(5000.0);
            const double single = air.pathRadiance(ScatteringMode::single, 5000.0);
            const double twoStream = air.pathRadiance(ScatteringMode::twoStream, 5000.0);
            std::printf("| %s | %.0f | %.4g | %+.2f | %+.2f | %+.2f | %+.2f |\n", name,
                        1e-3 * visibility_m, sums.reference,
                        100.0 * (single / sums.reference - 1.0),
                        100.0 * (twoStream / sums.reference - 1.0),
                        100.0 * (sums.downTwoStream / sums.down - 1.0),
                        100.0 * (sums.meanTwoStream / sums.mean - 1.0));
            EXPECT_NEAR(twoStream / sums.twoStream, 1.0, 0.01) << "the same along the path";
            const double off = std::abs(twoStream / sums.reference - 1.0);
            EXPECT_LT(off, visibility_m < 1e4 ? 0.075 : 0.03) << name;
            EXPECT_LT(3.0 * off, std::abs(single / sums.reference - 1.0)) << name;
            // Flux is right and the mean over directions is not: the sky is bright at its edge.
            EXPECT_NEAR(sums.downTwoStream / sums.down, 1.0, 0.04) << name;
            EXPECT_LT(sums.meanTwoStream, sums.mean) << name;
        }
    }
}

} // namespace
} // namespace irsg
