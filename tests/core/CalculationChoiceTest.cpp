#include <cstdlib>

#include <gmock/gmock.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/atmosphere/BeerLambert.h"
#include "irsg/atmosphere/ck/SensorCkData.h"
#include "smatcore/analysis/CalculationChoice.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using irsg::CalculationMode;
using testing::HasSubstr;

SceneDescription computedAir(const irsg::AtmosphereSmartParameters& more = {}) {
    irsg::AtmosphereSmartParameters parameters = more;
    parameters.baseWavelengthMin_um = 8.0;
    parameters.baseWavelengthMax_um = 12.0;
    SceneDescription scene;
    scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    return scene;
}

AnalysisPlan ranges(std::size_t count) {
    AnalysisPlan plan;
    for (std::size_t i = 0; i < count; ++i) {
        plan.cases.emplace_back().range_m = 100.0 * static_cast<double>(i + 1);
    }
    return plan;
}

TEST(CalculationChoices, AreSpectralUntilLinesOfSightPayForTraining) {
    const CalculationChoice few = chooseCalculation(computedAir(), ranges(399));
    EXPECT_EQ(few.mode, CalculationMode::spectral);
    EXPECT_EQ(few.reason,
              "mode auto: spectral, as training wideband-ck pays from 400 different lines of "
              "sight on, not for 399");
    const CalculationChoice many = chooseCalculation(computedAir(), ranges(400));
    EXPECT_EQ(many.mode, CalculationMode::wideband);
    EXPECT_THAT(many.reason, HasSubstr("400 different lines of sight pay"));
}

TEST(CalculationChoices, CountALineOfSightOnceHoweverManyAspectsShareIt) {
    AnalysisPlan turn;
    for (int i = 0; i < 1000; ++i) {
        AnalysisCase& one = turn.cases.emplace_back();
        one.range_m = 500.0;
        one.shownAzimuth_deg = 0.36 * i;
    }
    const CalculationChoice choice = chooseCalculation(computedAir(), turn);
    EXPECT_EQ(choice.mode, CalculationMode::spectral);
    EXPECT_THAT(choice.reason, HasSubstr("not for 1"));
}

TEST(CalculationChoices, DoNotDependOnWhatWasTrainedBefore) {
    const test::TemporaryFolder folder;
    setenv("SMAT_CACHE", folder.path().c_str(), 1);
    const SceneDescription scene = computedAir();
    irsg::CkRequest request;
    request.band = scene.sensor.band;
    request.sun = scene.environment.sun;
    (void)scene.environment.prepareCk(request);
    EXPECT_EQ(chooseCalculation(scene, ranges(20)).mode, CalculationMode::spectral);
    setenv("SMAT_CACHE", "", 1);
}

TEST(CalculationChoices, AreNoneWhereOtherAirAnswersInEitherMode) {
    const AnalysisPlan many = ranges(1000);
    EXPECT_EQ(chooseCalculation(SceneDescription(), many).reason, "") << "no air";

    SceneDescription scene;
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    scene.environment.add(std::make_shared<irsg::BeerLambert>(
        irsg::BeerLambert::fromCsv(SMAT_SOURCE_DIR "/resources/atmospheres/haze-23km.csv")));
    EXPECT_EQ(chooseCalculation(scene, many).reason, "") << "air without wideband-ck";
    scene.environment.add(computedAir().environment.atmospheres().front());
    const CalculationChoice mixed = chooseCalculation(scene, many);
    EXPECT_EQ(mixed.mode, CalculationMode::spectral) << "the haze answers in the spectral mode";
    EXPECT_EQ(mixed.reason, "");
}

TEST(CalculationChoices, AreNoneForAirThatLacksWhatTheWidebandModeWouldRefuse) {
    irsg::AtmosphereSmartParameters parameters;
    parameters.scatteringMode = 1; // without fluxes
    EXPECT_EQ(chooseCalculation(computedAir(parameters), ranges(1000)).reason, "");
}

} // namespace
} // namespace smat
