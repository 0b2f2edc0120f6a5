#include <cstdlib>

#include <gmock/gmock.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/SpectraAtmosphere.h"
#include "irsg/atmosphere/TabulatedAtmosphere.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "smatcore/analysis/CalculationChoice.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using irsg::CalculationMode;
using testing::HasSubstr;

SceneDescription computedAtmosphere(const irsg::AtmosphereSmartParameters& more = {}) {
    irsg::AtmosphereSmartParameters parameters = more;
    parameters.baseWavelengthMin_um = 8.0;
    parameters.baseWavelengthMax_um = 12.0;
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    return scene;
}

AnalysisPlan ranges(std::size_t count, double elevation_deg = 12.0) {
    AnalysisPlan plan;
    for (std::size_t i = 0; i < count; ++i) {
        AnalysisCase& one = plan.cases.emplace_back();
        one.range_m = 100.0 * static_cast<double>(i + 1);
        one.shownElevation_deg = elevation_deg;
    }
    return plan;
}

/// The fewest lines of sight over range that pay for training.
std::size_t fewestOf(const SceneDescription& scene, double elevation_deg = 12.0) {
    std::size_t count = 1;
    while (chooseCalculation(scene, ranges(count, elevation_deg)).mode ==
           CalculationMode::spectral) {
        ++count;
    }
    return count;
}

TEST(CalculationChoices, AreSpectralUntilLinesOfSightPayForTraining) {
    const CalculationChoice few = chooseCalculation(computedAtmosphere(), ranges(70));
    EXPECT_EQ(few.mode, CalculationMode::spectral);
    EXPECT_EQ(few.reason,
              "mode auto: spectral, as training wideband-ck pays from 71 different lines of "
              "sight on, not for 70");
    const CalculationChoice many = chooseCalculation(computedAtmosphere(), ranges(71));
    EXPECT_EQ(many.mode, CalculationMode::wideband);
    EXPECT_THAT(many.reason, HasSubstr("71 different lines of sight pay"));
}

/// Break-evens by processor time: a box before a background of one row at 72 lines, before one of 4
/// rows at 26.
TEST(CalculationChoices, CountWhatTheAirIsAskedForALineOfSight) {
    SceneDescription scene = computedAtmosphere();
    EXPECT_EQ(fewestOf(scene, 0.0), 71u) << "a sky for each range, as directions follow it";
    scene.settings.backgroundRows = 16;
    EXPECT_EQ(fewestOf(scene), 7u);
    EXPECT_EQ(fewestOf(scene, 0.0), 7u);
    scene.settings.backgroundRows = 0;
    EXPECT_EQ(fewestOf(scene), 23u) << "automatic";
    scene.settings.background = irsg::BackgroundMode::none;
    EXPECT_EQ(fewestOf(scene), 249u) << "no sky";
}

/// By processor time training costs what 370 to 400 paths do at 4.4 to 5 um, 190 at 3.5 to 4.1 um.
TEST(CalculationChoices, AreTrainedLaterWhereTheSpectrumHasManyLinesOfSeveralGases) {
    irsg::AtmosphereSmartParameters parameters;
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
    scene.sensor.band = irsg::Band::topHat(4.5, 5.0);
    const std::size_t dense = fewestOf(scene);
    scene.sensor.band = irsg::Band::topHat(3.5, 4.1);
    const std::size_t sparse = fewestOf(scene);
    EXPECT_NEAR(static_cast<double>(dense), 105.0, 12.0);
    EXPECT_NEAR(static_cast<double>(sparse), 53.0, 6.0);
}

/// By wall time 360 aspects in 100 bands of 0.02 um took twice as long with points as without.
TEST(CalculationChoices, AreSpectralInManyBandsThatAreAsNarrowAsPointsAreMany) {
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    irsg::AtmosphereSmartParameters parameters;
    scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
    const auto inParts = [&](int parts) {
        std::vector<irsg::Band> bands;
        for (int i = 0; i < parts; ++i) {
            bands.push_back(irsg::Band::topHat(3.0 + 2.0 * i / parts, 3.0 + 2.0 * (i + 1) / parts));
        }
        scene.setBands(bands);
        return chooseCalculation(scene, ranges(1000));
    };
    EXPECT_EQ(inParts(1).mode, CalculationMode::wideband);
    EXPECT_EQ(inParts(4).mode, CalculationMode::wideband);
    EXPECT_EQ(inParts(100).mode, CalculationMode::spectral);
    EXPECT_THAT(inParts(100).reason, HasSubstr("than wideband-ck has quadrature points"));
}

TEST(CalculationChoices, CountALineOfSightOnceHoweverManyAspectsShareIt) {
    AnalysisPlan turn;
    for (int i = 0; i < 1000; ++i) {
        AnalysisCase& one = turn.cases.emplace_back();
        one.range_m = 500.0;
        one.shownAzimuth_deg = 0.36 * i;
    }
    const CalculationChoice choice = chooseCalculation(computedAtmosphere(), turn);
    EXPECT_EQ(choice.mode, CalculationMode::spectral);
    EXPECT_THAT(choice.reason, HasSubstr("not for 1"));
}

TEST(CalculationChoices, DoNotDependOnWhatWasTrainedBefore) {
    const test::TemporaryFolder folder;
    setenv("SMAT_CACHE", folder.path().c_str(), 1);
    const SceneDescription scene = computedAtmosphere();
    irsg::CkRequest request;
    request.band = scene.sensor.band;
    request.sun = scene.environment.sun;
    (void)scene.environment.prepareCk(request);
    EXPECT_EQ(chooseCalculation(scene, ranges(50)).mode, CalculationMode::spectral);
    setenv("SMAT_CACHE", "", 1);
}

TEST(CalculationChoices, AreNoneWhereOtherAirAnswersInEitherMode) {
    const AnalysisPlan many = ranges(1000);
    EXPECT_EQ(chooseCalculation(SceneDescription(), many).reason, "") << "no air";

    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    irsg::SpectraAtmosphereParameters known;
    known.spectra[irsg::AtmosphereProperty::transmittance] =
        irsg::Spectrum({9.0, 11.0}, {0.9, 0.8});
    known.path = irsg::AtmosphericPath{0.0, 0.0, 1000.0};
    scene.environment.add(std::make_shared<irsg::SpectraAtmosphere>(known));
    EXPECT_EQ(chooseCalculation(scene, many).reason, "") << "air without wideband-ck";
    scene.environment.add(computedAtmosphere().environment.atmospheres().front());
    const CalculationChoice mixed = chooseCalculation(scene, many);
    EXPECT_EQ(mixed.mode, CalculationMode::spectral) << "other air answers in the spectral mode";
    EXPECT_EQ(mixed.reason, "");
}

TEST(CalculationChoices, PayFromThreeLinesOfSightOnInAirOfAFile) {
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    scene.environment.add(std::make_shared<irsg::BeerLambert>(
        irsg::BeerLambert::fromCsv(SMAT_SOURCE_DIR "/resources/atmospheres/haze-23km.csv")));
    EXPECT_EQ(chooseCalculation(scene, ranges(2)).mode, CalculationMode::spectral);
    EXPECT_EQ(chooseCalculation(scene, ranges(3)).mode, CalculationMode::wideband);
    scene.environment.add(computedAtmosphere().environment.atmospheres().front());
    EXPECT_EQ(chooseCalculation(scene, ranges(3)).mode, CalculationMode::wideband)
        << "which answers all, too, and last";
}

/// Runs have no diffuse fluxes: the mode is there for scenes that ask for none.
TEST(CalculationChoices, AreThereForRunsWhereNothingIsAskedThatTheyLack) {
    irsg::SpectralRun run;
    run.source = "run";
    run.kind = irsg::RunKind::thermalRadiance;
    run.geometry = {irsg::RunPath::horizontal, 0.0, 0.0, 5000.0, 0.0, {}};
    for (double nu = 980.0; nu < 1020.0; nu += 1.0) {
        run.wavenumbers_per_cm.push_back(nu);
        run.transmittance.push_back(0.6);
        run.pathRadiance_W_m2_sr_um.push_back(2.0);
        run.totalRadiance_W_m2_sr_um.push_back(4.0);
    }
    SceneDescription scene;
    scene.settings = irsg::RenderSettings::direct();
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    scene.environment.add(
        std::make_shared<irsg::TabulatedAtmosphere>(std::vector<irsg::SpectralRun>{run}, "runs"));
    EXPECT_EQ(chooseCalculation(scene, ranges(50)).reason, "");
    scene.settings.ambientReflection = irsg::ReflectionMode::off;
    scene.settings.sun = irsg::ReflectionMode::off;
    scene.settings.background = irsg::BackgroundMode::none;
    EXPECT_EQ(chooseCalculation(scene, ranges(50)).mode, CalculationMode::wideband);
}

TEST(CalculationChoices, AreNoneForAirThatLacksWhatTheWidebandModeWouldRefuse) {
    irsg::AtmosphereSmartParameters parameters;
    parameters.scatteringMode = 1; // without fluxes
    EXPECT_EQ(chooseCalculation(computedAtmosphere(parameters), ranges(1000)).reason, "");
}

} // namespace
} // namespace smat
