#include "irsg/atmosphere/AtmosphereNodes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/Environment.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Quadrature.h"

using namespace irsg;

namespace {

std::shared_ptr<const AtmosphereSmart> atmosphereOf(int resolution_per_cm = 5) {
    AtmosphereSmartParameters parameters;
    parameters.irradianceMode = 2;
    parameters.resolution_per_cm = resolution_per_cm;
    return std::make_shared<const AtmosphereSmart>(parameters);
}

const Band band = Band::topHat(3.01, 3.333);
const AtmosphericPath path{1000.0, 800.0, 3000.0, 0.4};
const SunPosition sun{1.0, 0.6};

double sumOf(const Spectrum& spectrum, const Band& over) {
    const Spectrum* const factors[] = {&spectrum, &over.response()};
    return integrateProduct(factors, over.range());
}

} // namespace

TEST(AtmosphereNodes, AddUpASingleQuantityAsItsSpectrumDoes) {
    for (const int resolution_per_cm : {1, 5, 15}) {
        const auto air = atmosphereOf(resolution_per_cm);
        const Band triangle =
            Band::fromResponse(Spectrum({3.02, 3.1, 3.3}, {0.0, 1.0, 0.2}), "triangle");
        for (const Band& over : {band, triangle}) {
            const auto nodes = air->nodesOf({over});
            EXPECT_NEAR(nodes->area_um(), over.area_um(), 2e-9); // weights are floats
            for (const AtmosphericQuery& query :
                 {AtmosphericQuery::transmittance(path), AtmosphericQuery::pathRadiance(path, sun),
                  AtmosphericQuery::solarIrradiance(500.0, sun),
                  AtmosphericQuery::upwardFlux(500.0, sun),
                  AtmosphericQuery::backgroundRadiance({10.0, 0.3, 0.0}, sun)}) {
                const double expected = sumOf(air->spectrum(query, over.range()), over);
                EXPECT_NEAR(nodes->integrate(air->provide(query, *nodes)) / expected, 1.0, 1e-9)
                    << resolution_per_cm << " " << name(query.quantity);
            }
        }
    }
}

TEST(AtmosphereNodes, MultiplyWhatMeetsTheSameLinesBeforeTheBinIsSummed) {
    // Through a path and back is a path of twice the depth: at a node its transmittance is the
    // square, of means of bins it is not.
    const auto air = atmosphereOf();
    const auto nodes = air->nodesOf({band});
    const AtmosphericPath once{1000.0, 1000.0, 1500.0}, twice{1000.0, 1000.0, 3000.0};
    const std::vector<double> there = air->provide(AtmosphericQuery::transmittance(once), *nodes);
    const double expected =
        nodes->integrate(air->provide(AtmosphericQuery::transmittance(twice), *nodes));
    EXPECT_NEAR(nodes->integrate(there, there) / expected, 1.0, 2e-4);
    const Spectrum mean = air->transmittance(once, band.range());
    const Spectrum* const squared[] = {&mean, &mean};
    EXPECT_LT(integrateProduct(squared, band.range()) / expected, 0.97);
}

TEST(AtmosphereNodes, TakeBlackBodiesAndSurfacesAsTheBandDoes) {
    const auto air = atmosphereOf();
    const auto nodes = air->nodesOf({band});
    EXPECT_NEAR(nodes->integrate(nodes->planck(300.0)) / bandRadiance_W_m2_sr(band, 300.0), 1.0,
                1e-4);
    const Spectrum slope({3.0, 3.1, 3.4}, {0.2, 0.9, 0.3});
    EXPECT_NEAR(nodes->integrate(nodes->sampled(slope)), sumOf(slope, band), 1e-9);
    const Spectrum step({3.05, 3.05 + 1e-9}, {0.0, 1.0});
    EXPECT_NEAR(nodes->integrate(nodes->sampled(step)), sumOf(step, band), 1e-9);
    EXPECT_EQ(nodes->sampled(Spectrum::constant(0.7)), std::vector<double>(nodes->size(), 0.7));
}

TEST(AtmosphereNodes, TakeSpectraOfOneAxisAsEachAlone) {
    std::vector<double> axis, values;
    for (int n = 3000; n <= 3340; n += 5) { // some beyond the band
        axis.insert(axis.begin(), 1e4 / n);
        values.insert(values.begin(), std::sin(0.1 * n) + 1e-3 * n);
    }
    const auto air = atmosphereOf();
    const std::shared_ptr<const SpectralSampling> samplings[] = {
        air->nodesOf({band, Band::fromResponse(Spectrum({3.34, 3.35, 3.4}, {0.0, 1.0, 0.0}), "")}),
        air->nodesAt({3.05, 3.1001, 3.2})};
    for (const auto& sampling : samplings) {
        const AtmosphereNodes* nodes = AtmosphereNodes::of(*sampling);
        ASSERT_NE(nodes, nullptr);
        const std::vector<double> expected = nodes->sampled(Spectrum(axis, values));
        const std::vector<double> got = nodes->fromAxis(axis).sampled(values);
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t i = 0; i < got.size(); ++i) {
            EXPECT_NEAR(got[i], expected[i], 1e-12 * std::abs(expected[i]) + 1e-13) << i;
        }
    }
}

TEST(AtmosphereNodes, AtWavelengthsAreTheSpectrum) {
    const auto air = atmosphereOf();
    const std::vector<double> wavelengths_um{3.02, 3.1, 3.1003, 3.25};
    const auto sampling = air->nodesAt(wavelengths_um);
    const AtmosphereNodes& nodes = *AtmosphereNodes::of(*sampling);
    ASSERT_EQ(nodes.outputs().size(), wavelengths_um.size());
    const AtmosphericQuery query = AtmosphericQuery::solarIrradiance(100.0, sun);
    const Spectrum spectrum = air->spectrum(query, band.range());
    const std::vector<double> values = air->provide(query, nodes);
    const Spectrum slope({3.0, 3.4}, {0.0, 1.0});
    const std::vector<double> ofSlope = nodes.sampled(slope);
    for (std::size_t i = 0; i < wavelengths_um.size(); ++i) {
        const auto [first, last] = nodes.outputs()[i];
        double sum = 0.0;
        for (std::size_t k = first; k < last; ++k) {
            sum += nodes.weights_um()[k] * values[k];
            EXPECT_EQ(nodes.wavelengths_um()[k], wavelengths_um[i]);
            EXPECT_EQ(ofSlope[k], slope.at(wavelengths_um[i]));
        }
        EXPECT_NEAR(sum / spectrum.at(wavelengths_um[i]), 1.0, 1e-6) << wavelengths_um[i];
    }
}

TEST(AtmosphereNodes, OfSeveralBandsAreThoseOfEachAlone) {
    const auto air = atmosphereOf();
    const Band triangle =
        Band::fromResponse(Spectrum({3.2, 3.25, 3.3}, {0.0, 1.0, 0.2}), "triangle");
    // Two that share a bin, one with a response behind a gap.
    const std::vector<Band> bands{Band::topHat(3.01, 3.05), Band::topHat(3.05, 3.1), triangle};
    const auto together = air->nodesOf(bands);
    const auto& outputs = AtmosphereNodes::of(*together)->outputs();
    ASSERT_EQ(outputs.size(), bands.size());
    EXPECT_EQ(outputs.front().first, 0u);
    EXPECT_EQ(outputs.back().second, together->size());
    const Spectrum slope({3.0, 3.07, 3.4}, {0.2, 0.9, 0.3});
    const auto part = [&](const std::vector<double>& values, std::size_t k) {
        return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(outputs[k].first),
                                   values.begin() + static_cast<std::ptrdiff_t>(outputs[k].second));
    };
    for (std::size_t k = 0; k < bands.size(); ++k) {
        const auto alone = air->nodesOf({bands[k]});
        EXPECT_EQ(part(together->wavelengths_um(), k), alone->wavelengths_um()) << k;
        EXPECT_EQ(part(together->weights_um(), k), alone->weights_um()) << k;
        EXPECT_EQ(part(together->sampled(slope), k), alone->sampled(slope)) << k;
        for (const AtmosphericQuery& query :
             {AtmosphericQuery::transmittance(path), AtmosphericQuery::pathRadiance(path, sun),
              AtmosphericQuery::backgroundRadiance({10.0, 0.3, 0.0}, sun)}) {
            EXPECT_EQ(part(air->provide(query, *together), k), air->provide(query, *alone))
                << k << " " << name(query.quantity);
        }
    }
    Environment one, two;
    one.add(air);
    two.add(air);
    two.add(atmosphereOf(15));
    EXPECT_NE(one.nodesOf(bands), nullptr);
    EXPECT_EQ(two.nodesOf(bands), nullptr) << "bands could be answered by either";
    EXPECT_THROW((void)air->nodesOf(std::vector<Band>{}), LogicError);
}

TEST(AtmosphereNodes, OfOneAirAreAnsweredByAnotherWithItsSpectrum) {
    const auto air = atmosphereOf(), other = atmosphereOf(15);
    const auto nodes = air->nodesOf({band});
    const AtmosphericQuery query = AtmosphericQuery::transmittance(path);
    EXPECT_EQ(other->provide(query, *nodes),
              nodes->sampled(other->transmittance(path, band.range())));
    BeerLambertParameters haze;
    haze.extinction_per_m = Spectrum({2.0, 6.0}, {1e-5, 4e-5});
    Environment environment;
    environment.add(air);
    EXPECT_NE(environment.nodesOf(band), nullptr);
    Environment smooth;
    smooth.add(std::make_shared<BeerLambert>(haze));
    smooth.add(air);
    EXPECT_EQ(smooth.nodesOf(band), nullptr) << "who answers has no lines";
    EXPECT_EQ(smooth.provide(query, *nodes).value,
              nodes->sampled(smooth.atmospheres()[0]->transmittance(path, band.range())));
    EXPECT_THROW((void)AtmosphereNodes::of(*nodes)->arranged(std::vector<double>{1.0}), LogicError);
    EXPECT_THROW((void)air->nodesOf({Band::topHat(8.0, 9.0)}), LogicError);
}
