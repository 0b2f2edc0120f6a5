#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "irsg/core/Errors.h"
#include "irsg/radiance/SceneRadiometry.h"
#include "irsg/radiance/WidebandPoints.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/radiometry/Units.h"
#include "tests/support/Refusal.h"
#include "tests/support/SampleAircraft.h"
#include "tests/support/SceneSpectra.h"
#include "tests/support/WidebandScenes.h"

using namespace irsg;
using namespace irsg::test;

namespace {

using testing::HasSubstr;

const IrCodes one{1, 1}, two{2, 2};

RenderReport measured(InteractiveRenderer& irsg, CalculationMode mode,
                      ReflectionMode reflection = ReflectionMode::smart) {
    RenderSettings settings = irsg.scene.settings;
    settings.mode = mode;
    settings.sun = settings.ambientReflection = reflection;
    settings.samplesPerAxis = 1;
    irsg.scene.settings = settings;
    return irsg.measure();
}

long trainings(const InteractiveRenderer& irsg) {
    for (const StageTimes::Stage& stage : irsg.stageTimes().stages) {
        if (stage.name == "wideband points") {
            return stage.calls;
        }
    }
    return 0;
}

std::string refusal(InteractiveRenderer& irsg) {
    return smat::test::refusalOf([&] { measured(irsg, CalculationMode::wideband); });
}

class WidebandScenes : public testing::TestWithParam<WidebandAtmosphere> {};

// Five scenes in each of four airs: the check of feature F17, for what surfaces emit. What they
// reflect has its own, as the spectral mode multiplies means of bins there.
TEST_P(WidebandScenes, HaveTheIntensityAndTheBackgroundOfTheSpectralMode) {
    const Band band = GetParam().band();
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = GetParam().environment();
    double worst = 0.0;
    for (const WidebandScene& scene : widebandScenes(band)) {
        irsg.scene.entities = {scene.entity};
        look(irsg, scene.view);
        const RenderReport spectral =
            measured(irsg, CalculationMode::spectral, ReflectionMode::off);
        const RenderReport wideband =
            measured(irsg, CalculationMode::wideband, ReflectionMode::off);
        const double intensity = wideband.all.intensity_W_sr / spectral.all.intensity_W_sr - 1.0;
        const double background = wideband.background_W_m2_sr / spectral.background_W_m2_sr - 1.0;
        EXPECT_NEAR(intensity, 0.0, 5e-3) << scene.name;
        EXPECT_NEAR(background, 0.0, 5e-3) << scene.name;
        worst = std::max({worst, std::abs(intensity), std::abs(background)});
        EXPECT_THAT(wideband.providedBy.front(), HasSubstr("wideband-ck: "));
        EXPECT_THAT(wideband.providedBy.front(), HasSubstr("% off on paths that were not trained"));
        EXPECT_THAT(wideband.providedBy.front(), HasSubstr("AtmosphereSmart"));
    }
    RecordProperty("worst_percent", std::to_string(100.0 * worst));
}

TEST(WidebandRadiometry, MultipliesMonochromaticallyAtEveryPoint) {
    const auto smart = smartAtmosphere(2);
    const Environment environment = environmentOf(smart);
    const std::vector<Entity> entities{entityOf(box(), withGas(200.0))};
    const ObjectGeometry geometry = geometryOf({1500.0, 1000.0, 3000.0});
    RenderSettings settings = RenderSettings::direct();
    settings.sun = settings.ambientReflection = ReflectionMode::off;
    const auto points = std::make_shared<const WidebandPoints>(environment, Band::topHat(3.0, 5.0),
                                                               widebandSpectraOf(entities));
    const SceneRadiometry scene =
        atPoints(environment, entities, {geometry}, settings, {1500.0, -0.1, 0.0}, points);

    const SensorCkData& ck = points->data();
    const std::vector<double> path = smart->transfer().transmittance(ck.nodes(), geometry.path);
    const std::vector<double> inside =
        smart->transfer().transmittance(ck.nodes(), {1000.0 + 500.0 / 15.0, 1000.0, 200.0});
    const std::vector<double> light =
        smart->transfer().pathRadiance(ck.nodes(), geometry.path, environment.sun);
    const std::vector<double> gas = ck.sampled(hotGas());
    ASSERT_EQ(scene.rows().keys(), (std::vector<SurfaceKey>{{0, one}, {0, two}}));
    const int skin = scene.rows().first(0), plume = scene.rows().first(1);
    ASSERT_EQ(scene.weights_um(), ck.weights_um());
    for (std::size_t i = 0; i < ck.size(); ++i) {
        EXPECT_DOUBLE_EQ(term(scene, skin, "thermal")[i],
                         0.9 * planckRadiance_W_m2_sr_um(ck.wavelengths_um()[i], 320.0) * path[i]);
        EXPECT_DOUBLE_EQ(term(scene, plume, "thermal")[i],
                         inside[i] < 1e-30 ? 0.0 : gas[i] * (path[i] / inside[i]));
        EXPECT_DOUBLE_EQ(term(scene, skin, "path")[i], light[i]);
    }
}

// Light that was through the air twice is absorbed by the same lines twice: the truth is the
// product at every node, its mean taken last.
TEST_P(WidebandScenes, ReflectAsIfMultipliedAtEveryNodeOfTheBand) {
    const SpectralRange range = GetParam().band().range();
    const auto smart = smartAtmosphere(GetParam().model, range.min_um, range.max_um);
    const Environment environment = environmentOf(smart);
    const RadiativeTransfer& transfer = smart->transfer();
    const NodeSet nodes = transfer.nodesOf(range);
    const std::vector<Entity> entities{entityOf(ball(), greyDatabase(0.6, 300.0))};
    const auto points = std::make_shared<const WidebandPoints>(environment, GetParam().band(),
                                                               widebandSpectraOf(entities));
    for (const AtmosphericPath& path :
         {AtmosphericPath{1000.0, 1000.0, 500.0}, AtmosphericPath{3300.0, 1000.0, 3000.0},
          AtmosphericPath{2200.0, 1000.0, 4000.0}}) {
        const SceneRadiometry scene =
            atPoints(environment, entities, {geometryOf(path)}, RenderSettings{},
                     {path.sensorAltitude_m, -0.1, 0.0}, points);
        const std::vector<double> through = transfer.transmittance(nodes, path);
        auto reflected = [&](std::vector<double> light) {
            for (std::size_t i = 0; i < light.size(); ++i) {
                light[i] *= 0.4 / pi * through[i];
            }
            const Spectrum means = transfer.spectrum(range, light);
            const Spectrum* factors[] = {&means};
            return integrateProduct(factors, range);
        };
        const double altitude_m = path.targetAltitude_m;
        const SunPosition& sun = environment.sun;
        const int skin = scene.rows().first(0);
        EXPECT_NEAR(scene.integrate(term(scene, skin, "sun")) /
                        reflected(transfer.solarIrradiance(nodes, altitude_m, sun)),
                    1.0, 5e-3);
        EXPECT_NEAR(scene.integrate(term(scene, skin, "down")) /
                        reflected(transfer.downwardFlux(nodes, altitude_m, sun)),
                    1.0, 5e-3);
        EXPECT_NEAR(scene.integrate(term(scene, skin, "up")) /
                        reflected(transfer.upwardFlux(nodes, altitude_m, sun)),
                    1.0, 5e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Airs, WidebandScenes, testing::ValuesIn(widebandAtmospheres()),
                         [](const auto& test) { return test.param.name; });

TEST(SpectraOfAScene, AreSortedByEntityAndCodesAndHeldOnceEach) {
    const Band band = Band::topHat(3.0, 5.0);
    const SignatureDatabase paint = painted(band, 300.0),
                            other = painted(Band::topHat(2.0, 5.0), 1);
    const WidebandSpectra spectra =
        widebandSpectraOf({entityOf(box(), paint), entityOf(box(), withGas(0.0)),
                           entityOf(box(), other), entityOf(box(), painted(band, 500.0))});
    EXPECT_EQ(spectra.materials, (std::vector<Spectrum>{paint.materials.at(2).emissivity,
                                                        other.materials.at(2).emissivity}));
    EXPECT_EQ(spectra.radiances, std::vector<Spectrum>{hotGas()});
}

TEST(WidebandPointsOfAScene, AreThoseOfAGasHoweverFaintItIs) {
    const Environment environment = environmentOf(smartAtmosphere(2));
    const Band band = Band::topHat(4.0, 5.0);
    const Spectrum bright = hotGas();
    const Spectrum faint = bright.mapped([](double radiance) { return radiance / 65536.0; });
    ASSERT_GT(bright.maximum(), 1.0);
    ASSERT_LT(faint.maximum(), 1.0);
    const WidebandPoints points(environment, band, {{}, {bright}});
    EXPECT_EQ(WidebandPoints(environment, band, {{}, {faint}}).data().weights_um(),
              points.data().weights_um());
}

TEST(WidebandPointsOfAScene, AreTrainedOnceForAnEnvironmentABandAndItsSpectra) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(smartAtmosphere(2, 3.0, 5.0));
    const Band band = Band::topHat(3.0, 5.0), narrow = Band::topHat(4.5, 4.9),
               wide = Band::topHat(2.8, 5.0);
    irsg.scene.entities = {entityOf(box(), painted(band, 300.0))};
    for (const double azimuth_rad : {0.0, 1.0, 2.0}) {
        look(irsg, {.azimuth_rad = azimuth_rad, .band = band});
        measured(irsg, CalculationMode::wideband);
    }
    irsg.scene.entities[0].database =
        std::make_shared<const SignatureDatabase>(painted(band, 350.0));
    measured(irsg, CalculationMode::wideband);
    EXPECT_EQ(trainings(irsg), 1) << "views and temperatures are no training";

    look(irsg, {.band = narrow});
    measured(irsg, CalculationMode::wideband);
    look(irsg, {.band = band});
    measured(irsg, CalculationMode::wideband);
    EXPECT_EQ(trainings(irsg), 2) << "and so is a band that comes back";

    irsg.scene.entities[0].database =
        std::make_shared<const SignatureDatabase>(painted(wide, 350.0));
    measured(irsg, CalculationMode::wideband);
    EXPECT_EQ(trainings(irsg), 3) << "another paint is";
    irsg.scene.environment = environmentOf(smartAtmosphere(5, 3.0, 5.0));
    measured(irsg, CalculationMode::wideband);
    EXPECT_EQ(trainings(irsg), 4) << "and so is other air, wherever it lies in memory";
}

TEST(WidebandScene, DoesNotDependOnWhatWasDrawnBefore) {
    auto result = [](const std::vector<double>& ranges_m, CalculationMode mode) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = environmentOf(smartAtmosphere(2));
        irsg.scene.entities = {entityOf(box(), withGas(0.0))};
        RenderReport report;
        for (const double range_m : ranges_m) {
            look(irsg, {.range_m = range_m, .azimuth_rad = 0.5});
            report = measured(irsg, mode);
        }
        return report;
    };
    for (const CalculationMode mode : {CalculationMode::spectral, CalculationMode::wideband}) {
        const RenderReport once = result({900.0}, mode), later = result({150.0, 900.0}, mode);
        EXPECT_EQ(once.all.intensity_W_sr, later.all.intensity_W_sr);
        EXPECT_EQ(once.all.irradiance_W_m2, later.all.irradiance_W_m2);
        EXPECT_EQ(once.background_W_m2_sr, later.background_W_m2_sr);
        EXPECT_EQ(once.providedBy, later.providedBy);
    }
}

TEST(WidebandScene, KeepsAConstantBackgroundToItsLastDigits) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(smartAtmosphere(2));
    irsg.scene.entities = {entityOf(ball(), greyDatabase(0.9, 300.0))};
    RenderSettings settings = RenderSettings::direct();
    settings.background = BackgroundMode::constant;
    settings.background_W_m2_sr = 1.25;
    irsg.scene.settings = settings;
    look(irsg, {});
    EXPECT_NEAR(measured(irsg, CalculationMode::wideband).background_W_m2_sr, 1.25, 1e-12);
    settings.background = BackgroundMode::none;
    irsg.scene.settings = settings;
    EXPECT_EQ(measured(irsg, CalculationMode::wideband).background_W_m2_sr, 0.0);
}

TEST(WidebandScene, HasSpectraOfTheSpectralModeAndSaysSo) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(smartAtmosphere(2));
    irsg.scene.entities = {entityOf(ball(), greyDatabase(0.9, 300.0))};
    look(irsg, {});
    const IntensitySpectrum spectral = irsg.measureSpectrum({2200.0, 2500.0});
    RenderSettings settings = RenderSettings::direct();
    settings.mode = CalculationMode::wideband;
    irsg.scene.settings = settings;
    const IntensitySpectrum wideband = irsg.measureSpectrum({2200.0, 2500.0});
    EXPECT_EQ(wideband.intensity_W_sr_um, spectral.intensity_W_sr_um);
    ASSERT_FALSE(wideband.warnings.empty());
    EXPECT_THAT(wideband.warnings.back(), HasSubstr("spectral mode"));
    EXPECT_EQ(trainings(irsg), 0);
}

TEST(WidebandScene, OfAnAircraftWithItsPlumesHasTheIntensityOfTheSpectralMode) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = environmentOf(smartAtmosphere(2));
    irsg.scene.entities = {sampleAircraft()};
    for (const double range_m : {900.0, 3000.0, 8000.0}) {
        look(irsg, {.range_m = range_m,
                    .azimuth_rad = radians(150.0),
                    .elevation_rad = radians(12.0),
                    .fieldOfView_rad = 45.0 / range_m});
        const RenderReport spectral = measured(irsg, CalculationMode::spectral);
        const RenderReport wideband = measured(irsg, CalculationMode::wideband);
        EXPECT_GT(spectral.all.intensity_W_sr, 0.0);
        EXPECT_NEAR(wideband.all.intensity_W_sr / spectral.all.intensity_W_sr, 1.0, 5e-3)
            << range_m;
    }
    EXPECT_EQ(trainings(irsg), 1);
}

TEST(WidebandScene, IsRefusedByNameWithoutAirThatHasTheMode) {
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.entities = {entityOf(ball(), greyDatabase(0.9, 300.0))};
    look(irsg, {});
    irsg.scene.environment = Environment::vacuum();
    EXPECT_THAT(refusal(irsg), HasSubstr("wideband-ck over 3-5 um"));
    EXPECT_THROW(irsg.check(), InputError);

    SpectraAtmosphereParameters measured;
    measured.name = "measured";
    measured.spectra[AtmosphereProperty::transmittance] = Spectrum({2.0, 6.0}, {0.5, 0.6});
    measured.path = AtmosphericPath{0.0, 0.0, 1000.0};
    irsg.scene.environment = environmentOf(std::make_shared<SpectraAtmosphere>(measured));
    EXPECT_THAT(refusal(irsg), HasSubstr("measured (has no wideband mode: it knows one line"));

    irsg.scene.environment = environmentOf(smartAtmosphere(2, 8.0, 12.0));
    EXPECT_THAT(refusal(irsg), HasSubstr("holds only 8-12 um"));

    irsg.scene.environment = environmentOf(smartAtmosphere(2, 3.0, 5.0, 1));
    EXPECT_THAT(refusal(irsg), HasSubstr("wideband upward flux over 3-5 um"));
    EXPECT_THAT(refusal(irsg), HasSubstr("ScatteringMode 2"));
}

} // namespace
