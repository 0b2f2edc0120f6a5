// Views through air of another optical depth between objects and sensor (Outputs::throughDepth).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/GaussLegendre.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/SceneFixtures.h"

using namespace irsg;
using namespace irsg::test;

namespace {

constexpr IrCodes one{1, 1};

/// Grey air over flat ground whose extinction thins out with altitude and whose source function
/// changes with it; a part between two altitudes may be `factor` times as thick. Closed forms and
/// quadratures of its own.
class LayeredAir : public ConstantAtmosphere {
  public:
    double extinction_per_m = 3e-4, scaleHeight_m = 1500.0;
    double source = 4.0, sourcePerMetre = -5e-4; ///< W m-2 sr-1 um-1
    double ground = 6.0, top_m = 6000.0;
    double from_m = 0.0, to_m = 0.0, factor = 1.0;

  protected:
    Spectrum nativeSpectrum(const AtmosphericQuery& query,
                            const SpectralRange& range) const override {
        const AtmosphericPath& path = query.path;
        const double slope = (path.targetAltitude_m - path.sensorAltitude_m) / path.range_m;
        switch (query.quantity) {
        case AtmosphereProperty::transmittance:
            return Spectrum::constant(
                std::exp(-depth(path.sensorAltitude_m, slope, 0.0, path.range_m)));
        case AtmosphereProperty::pathRadiance:
            return Spectrum::constant(emitted(path.sensorAltitude_m, slope, path.range_m));
        case AtmosphereProperty::backgroundRadiance: {
            const double climb = std::sin(query.sight.elevation_rad);
            const double altitude_m = query.sight.sensorAltitude_m;
            const double way_m =
                climb < 0.0 ? altitude_m / -climb : (top_m - altitude_m) / std::max(climb, 1e-6);
            return Spectrum::constant(emitted(altitude_m, climb, way_m) +
                                      (climb < 0.0 ? ground : 0.0) *
                                          std::exp(-depth(altitude_m, climb, 0.0, way_m)));
        }
        default:
            return ConstantAtmosphere::nativeSpectrum(query, range);
        }
    }

  private:
    double extinctionAt(double altitude_m) const {
        const double own = extinction_per_m * std::exp(-altitude_m / scaleHeight_m);
        return altitude_m > from_m && altitude_m < to_m ? factor * own : own;
    }
    /// Places along a line between which nothing jumps.
    std::vector<double> pieces(double altitude_m, double slope, double first_m,
                               double last_m) const {
        std::vector<double> places{first_m, last_m};
        for (const double edge_m : {from_m, to_m}) {
            const double place_m = slope != 0.0 ? (edge_m - altitude_m) / slope : -1.0;
            if (place_m > first_m && place_m < last_m) {
                places.push_back(place_m);
            }
        }
        std::ranges::sort(places);
        return places;
    }
    template <typename Value>
    double integral(double altitude_m, double slope, double first_m, double last_m,
                    const Value& value) const {
        const GaussRule& rule = gaussLegendre(32);
        const std::vector<double> places = pieces(altitude_m, slope, first_m, last_m);
        double sum = 0.0;
        for (std::size_t p = 0; p + 1 < places.size(); ++p) {
            const double width_m = places[p + 1] - places[p];
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                const double place_m = places[p] + rule.nodes[i] * width_m;
                sum += rule.weights[i] * width_m * value(place_m, altitude_m + slope * place_m);
            }
        }
        return sum;
    }
    double depth(double altitude_m, double slope, double first_m, double last_m) const {
        return integral(altitude_m, slope, first_m, last_m,
                        [&](double, double at_m) { return extinctionAt(at_m); });
    }
    double emitted(double altitude_m, double slope, double range_m) const {
        return integral(altitude_m, slope, 0.0, range_m, [&](double place_m, double at_m) {
            return extinctionAt(at_m) * (source + sourcePerMetre * at_m) *
                   std::exp(-depth(altitude_m, slope, 0.0, place_m));
        });
    }
};

template <typename Air>
Environment with(const Air& air) {
    Environment environment;
    environment.add(std::make_shared<Air>(air));
    return environment;
}

RenderSettings emissionAlone() {
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    settings.backgroundRows = 0;
    return settings;
}

/// A sphere at 1000 m, before what is behind itself.
InteractiveRenderer sphereScene(double transmissivity = 0.0) {
    InteractiveRenderer irsg{emissionAlone()};
    irsg.scene.entities = {entityOf(modelOf(sphereMesh(5.0, 24, 48, one)),
                                    greyDatabase(0.6, 330.0, 0.0, transmissivity))};
    return irsg;
}

void lookFrom(InteractiveRenderer& irsg, double elevation_deg, double range_m) {
    look(irsg, {.range_m = range_m,
                .elevation_rad = radians(elevation_deg),
                .fieldOfView_rad = 40.0 / range_m});
}

RenderReport seen(InteractiveRenderer& irsg, double depth = 1.0) {
    return irsg.render(Outputs::reports().throughDepth(depth)).reports.front();
}

void expectAlike(const RenderReport& a, const RenderReport& b, double tolerance) {
    EXPECT_NEAR(a.all.intensity_W_sr / b.all.intensity_W_sr, 1.0, tolerance);
    EXPECT_NEAR(a.all.contrastIntensity_W_sr / b.all.contrastIntensity_W_sr, 1.0, tolerance);
    EXPECT_NEAR(a.all.irradiance_W_m2 / b.all.irradiance_W_m2, 1.0, tolerance);
    EXPECT_NEAR(a.background_W_m2_sr / b.background_W_m2_sr, 1.0, tolerance);
}

BeerLambert hazeOf(double factor, double ground_K = 288.15) {
    BeerLambertParameters haze;
    haze.extinction_per_m = Spectrum({2.5, 3.5, 4.2, 5.5},
                                     {factor * 1e-4, factor * 4e-4, factor * 9e-4, factor * 2e-4});
    haze.groundTemperature_K = ground_K;
    return BeerLambert(haze);
}

} // namespace

// Where ground and air are as warm, what is behind is the same whatever the depth, so that all of
// the air may be thicker.
TEST(PathDepth, IsThatOfThickerAirOfBeersLawOnLevelAndSlantPaths) {
    for (const double elevation_deg : {-20.0, 0.0, 5.0, 40.0}) {
        SCOPED_TRACE(elevation_deg);
        for (const double depth : {0.7, 1.01, 2.0}) {
            SCOPED_TRACE(depth);
            InteractiveRenderer irsg = sphereScene();
            irsg.scene.environment = with(hazeOf(1.0));
            lookFrom(irsg, elevation_deg, 2500.0);
            const RenderReport deep = seen(irsg, depth), thin = seen(irsg);
            irsg.scene.environment = with(hazeOf(depth));
            expectAlike(deep, seen(irsg), 5e-5);
            EXPECT_GT(
                std::abs(deep.all.contrastIntensity_W_sr / thin.all.contrastIntensity_W_sr - 1.0),
                5e-3);
        }
    }
}

// At one wavelength, so to say: contrast goes with tau^(depth - 1), whatever is behind.
TEST(PathDepth, ContrastInGreyAirHasAClosedForm) {
    for (const double elevation_deg : {-20.0, 30.0}) {
        InteractiveRenderer irsg = sphereScene();
        BeerLambertParameters haze;
        haze.extinction_per_m = Spectrum::constant(3e-4);
        haze.groundTemperature_K = 310.0;
        irsg.scene.environment = with(BeerLambert(haze));
        lookFrom(irsg, elevation_deg, 2500.0);
        const RenderReport thin = seen(irsg), deep = seen(irsg, 1.5);
        EXPECT_NEAR(deep.all.contrastIntensity_W_sr / thin.all.contrastIntensity_W_sr,
                    std::exp(-0.5 * 3e-4 * 2500.0), 1e-6);
    }
}

TEST(PathDepth, IsThatOfLayeredAirWhichIsThickerBetweenTargetAndSensorAlone) {
    for (const double elevation_deg : {-15.0, 10.0, 60.0}) {
        for (const double transmissivity : {0.0, 0.3}) {
            SCOPED_TRACE(std::to_string(elevation_deg) + " deg, transmissivity " +
                         std::to_string(transmissivity));
            InteractiveRenderer irsg = sphereScene(transmissivity);
            LayeredAir air;
            irsg.scene.environment = with(air);
            lookFrom(irsg, elevation_deg, 2500.0);
            const RenderReport deep = seen(irsg, 1.5), thin = seen(irsg);
            const double sensor_m = irsg.view.viewpoint.position_m.z;
            air.from_m = std::min(sensor_m, standingAltitude_m);
            air.to_m = std::max(sensor_m, standingAltitude_m);
            air.factor = 1.5;
            irsg.scene.environment = with(air);
            const RenderReport thick = seen(irsg);
            EXPECT_NEAR(deep.all.contrastIntensity_W_sr / thick.all.contrastIntensity_W_sr, 1.0,
                        1e-4);
            // The source function of the path is its mean.
            EXPECT_NEAR(deep.background_W_m2_sr / thick.background_W_m2_sr, 1.0, 2e-3);
            EXPECT_NEAR(std::log(deep.background_W_m2_sr / thin.background_W_m2_sr) /
                            std::log(thick.background_W_m2_sr / thin.background_W_m2_sr),
                        1.0, 0.04);
        }
    }
}

// Rows of background, which pixels have, in place of what is behind the object itself.
TEST(PathDepth, BackgroundsOfPicturesAreSeenThroughTheSameAir) {
    for (const int rows : {1, 5}) {
        SCOPED_TRACE(rows);
        InteractiveRenderer irsg = sphereScene();
        irsg.scene.settings.backgroundRows = rows;
        irsg.scene.environment = with(hazeOf(1.0));
        lookFrom(irsg, 20.0, 2500.0);
        const RenderReport deep = seen(irsg, 1.5);
        const Rendered picture = irsg.render(Outputs::image().throughDepth(1.5));
        irsg.scene.environment = with(hazeOf(1.5));
        expectAlike(deep, seen(irsg), 5e-5);
        const Rendered direct = irsg.render(Outputs::image());
        const auto& pixels = picture.image.channels.front().values;
        const auto& wanted = direct.image.channels.front().values;
        ASSERT_EQ(pixels.size(), wanted.size());
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            ASSERT_NEAR(pixels[i] / wanted[i], 1.0, 3e-5) << i;
        }
    }
}

TEST(PathDepth, SpectraGoThroughItAndSourcesDoNot) {
    InteractiveRenderer irsg = sphereScene();
    irsg.scene.environment = with(hazeOf(1.0));
    lookFrom(irsg, 10.0, 2500.0);
    const std::vector<double> wavenumbers_per_cm{2100.0, 2500.0, 3000.0};
    const auto spectrum = [&](double depth) {
        return irsg.render(Outputs::spectrum(wavenumbers_per_cm).throughDepth(depth))
            .spectrum.contrastIntensity_W_sr_um;
    };
    const std::vector<double> thin = spectrum(1.0), deep = spectrum(2.0);
    const auto sources = irsg.render(Outputs::reports().withSource().throughDepth(2.0)).reports;
    const auto plain = irsg.render(Outputs::reports().withSource()).reports;
    irsg.scene.environment = with(hazeOf(2.0));
    const std::vector<double> direct = spectrum(1.0);
    for (std::size_t i = 0; i < direct.size(); ++i) {
        EXPECT_NEAR(deep[i] / direct[i], 1.0, 2e-5);
        EXPECT_LT(deep[i] / thin[i], 0.9);
    }
    EXPECT_EQ(sources.back().all.intensity_W_sr, plain.back().all.intensity_W_sr);
}

TEST(PathDepth, OneChangesNothingAndNoneIsRefused) {
    InteractiveRenderer irsg = sphereScene();
    irsg.scene.environment = with(hazeOf(1.0));
    lookFrom(irsg, 10.0, 2500.0);
    EXPECT_EQ(seen(irsg, 1.0).all.irradiance_W_m2, irsg.measure().all.irradiance_W_m2);
    for (const double depth : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(seen(irsg, depth), LogicError) << depth;
    }
}
