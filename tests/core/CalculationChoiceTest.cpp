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

/// A folder of kept terms for one test; ctest has none.
class CalculationChoices : public testing::Test {
  protected:
    CalculationChoices() { setenv("SMAT_CACHE", folder_.path().c_str(), 1); }
    ~CalculationChoices() override { setenv("SMAT_CACHE", "", 1); }

    static SceneDescription computedAir() {
        irsg::AtmosphereSmartParameters parameters;
        parameters.baseWavelengthMin_um = 8.0;
        parameters.baseWavelengthMax_um = 12.0;
        SceneDescription scene;
        scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
        scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
        return scene;
    }
    /// What a program before would have left behind.
    static void train(const SceneDescription& scene) {
        for (const irsg::Band& band : scene.allBands()) {
            irsg::CkRequest request;
            request.band = band;
            request.sun = scene.environment.sun;
            (void)scene.environment.prepareCk(request);
        }
    }

  private:
    test::TemporaryFolder folder_;
};

TEST_F(CalculationChoices, AreSpectralUntilCasesPayForTraining) {
    const SceneDescription scene = computedAir();
    const CalculationChoice few = chooseCalculation(scene, 399);
    EXPECT_EQ(few.mode, CalculationMode::spectral);
    EXPECT_EQ(few.reason, "mode auto: spectral, as 399 cases are fewer than the 400 that training "
                          "wideband terms pays for");
    const CalculationChoice many = chooseCalculation(scene, 400);
    EXPECT_EQ(many.mode, CalculationMode::wideband);
    EXPECT_THAT(many.reason, HasSubstr("400 cases pay for training"));
}

TEST_F(CalculationChoices, TakeTermsThatAreKeptForAFewCases) {
    const SceneDescription scene = computedAir();
    train(scene);
    EXPECT_EQ(chooseCalculation(scene, 3).mode, CalculationMode::spectral);
    const CalculationChoice kept = chooseCalculation(scene, 4);
    EXPECT_EQ(kept.mode, CalculationMode::wideband);
    EXPECT_EQ(kept.reason, "mode auto: wideband-ck, as its terms are kept from before");
    setenv("SMAT_CACHE", "", 1);
    EXPECT_EQ(chooseCalculation(scene, 4).mode, CalculationMode::spectral) << "nothing is kept";
}

TEST_F(CalculationChoices, AreOfTheDearestBand) {
    SceneDescription scene = computedAir();
    train(scene);
    scene.bands = {scene.sensor.band, irsg::Band::topHat(10.4, 10.6)};
    EXPECT_EQ(chooseCalculation(scene, 4).mode, CalculationMode::spectral);
    train(scene);
    EXPECT_EQ(chooseCalculation(scene, 4).mode, CalculationMode::wideband);
}

TEST_F(CalculationChoices, AreOfTheTermsSun) {
    SceneDescription scene = computedAir();
    train(scene);
    scene.environment.sun.elevation_rad = 0.1;
    EXPECT_EQ(chooseCalculation(scene, 4).mode, CalculationMode::spectral);
}

TEST_F(CalculationChoices, AreNoneWhereOtherAirAnswersInEitherMode) {
    EXPECT_EQ(chooseCalculation(SceneDescription(), 1000).reason, "") << "no air";

    SceneDescription scene;
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    scene.environment.add(std::make_shared<irsg::BeerLambert>(
        irsg::BeerLambert::fromCsv(SMAT_SOURCE_DIR "/resources/atmospheres/haze-23km.csv")));
    EXPECT_EQ(chooseCalculation(scene, 1000).reason, "") << "air without terms";
    scene.environment.add(computedAir().environment.atmospheres().front());
    const CalculationChoice mixed = chooseCalculation(scene, 1000);
    EXPECT_EQ(mixed.mode, CalculationMode::spectral) << "the haze answers in the spectral mode";
    EXPECT_EQ(mixed.reason, "");
}

TEST_F(CalculationChoices, AreNoneForAirThatLacksWhatTheWidebandModeWouldRefuse) {
    irsg::AtmosphereSmartParameters parameters;
    parameters.baseWavelengthMin_um = 8.0;
    parameters.baseWavelengthMax_um = 12.0;
    parameters.scatteringMode = 1; // without fluxes
    SceneDescription scene;
    scene.sensor.band = irsg::Band::topHat(9.9, 10.1);
    scene.environment.add(std::make_shared<irsg::AtmosphereSmart>(parameters));
    EXPECT_EQ(chooseCalculation(scene, 1000).reason, "");
}

} // namespace
} // namespace smat
