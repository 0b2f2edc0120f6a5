#include "irsg/sensor/SensorFile.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "tests/sensor/SensorSupport.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

const fs::path library = fs::path(SMAT_SOURCE_DIR) / "resources/sensors";

std::string messageOf(const std::string& text) {
    try {
        sensorFromJson(text, "one.smatsensor");
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(SensorFile, WritesWhatItReads) {
    SensorDescription sensor = test::staringSensor();
    sensor.source = "a test";
    sensor.optics.pupil = PupilShape::annular;
    sensor.optics.obscuration = 0.3;
    sensor.optics.transmission = Spectrum({3.0, 5.0}, {0.7, 0.8});
    sensor.optics.temperature_K = 290.0;
    sensor.optics.emissivity = 0.1;
    sensor.optics.coldShieldEfficiency = 0.95;
    sensor.optics.housingTemperature_K = 295.0;
    sensor.optics.defocus_waves = 0.25;
    sensor.optics.defocusWavelength_um = 4.0;
    sensor.optics.aberrationBlur_urad = 5.0;
    sensor.detector.fillFactor = 0.9;
    sensor.detector.darkCurrent_e_per_s = 1e5;
    sensor.detector.timeConstant_s = 1e-3;
    sensor.motion = {.jitter_urad = 3.0, .lineOfSightRate_urad_per_s = 100.0};
    sensor.electronics.offset_counts = 12.0;
    sensor.electronics.readNoise_e = 50.0;
    sensor.noise = {.referenceTemperature_K = 290.0,
                    .tv = 0.1,
                    .th = 0.2,
                    .t = 0.3,
                    .vh = 0.4,
                    .v = 0.5,
                    .h = 0.6,
                    .deadPixelFraction = 1e-3,
                    .hotPixelFraction = 2e-3};
    const std::string text = sensorToJson(sensor);
    const SensorDescription again = sensorFromJson(text, "again");
    EXPECT_EQ(sensorToJson(again), text);
    EXPECT_EQ(again.optics.obscuration, 0.3);
    EXPECT_EQ(again.optics.transmission, sensor.optics.transmission);
    EXPECT_EQ(again.noise.h, 0.6);
    EXPECT_EQ(again.detector.timeConstant_s, 1e-3);

    const fs::path file = fs::path(testing::TempDir()) / "one.smatsensor";
    saveSensor(sensor, file);
    EXPECT_EQ(sensorToJson(loadSensor(file)), text);
    sensor.optics.aperture_m = -1.0;
    EXPECT_THROW(saveSensor(sensor, file), InputError);
}

TEST(SensorFile, AnFNumberGivesTheFocalLength) {
    const std::string text =
        replaced(sensorToJson(test::staringSensor()), "\"focalLength_m\": 0.2", "\"fNumber\": 3");
    EXPECT_NEAR(sensorFromJson(text, "f").optics.focalLength_m, 0.3, 1e-15);
}

TEST(SensorFile, RefusesByKeyAndLine) {
    const std::string good = sensorToJson(test::staringSensor());
    struct Row {
        const char *from, *to, *said;
    };
    for (const Row& row : {
             Row{"\"well_e\": 7000000.0", "\"well_e\": 0.1", "detector.well_e, line"},
             Row{"\"focalLength_m\": 0.2", "\"focalLength_m\": 0.03", "F/0.3"},
             Row{"\"focalLength_m\": 0.2", "\"focalLength_m\": 0.2, \"fNumber\": 2",
                 "either focalLength_m or fNumber"},
             Row{"\"aperture_m\": 0.1", "\"aperture_mm\": 100", "aperture_mm"},
             Row{"\"aperture_m\": 0.1", "\"aperture_m\": \"wide\"", "optics.aperture_m, line"},
             Row{"\"pupil\": \"circular\"", "\"pupil\": \"round\"", "annular"},
             Row{"\"quantumEfficiency\": 0.7", "\"quantumEfficiency\": 1.7", "from 0 to 1"},
             Row{"\"quantumEfficiency\": 0.7",
                 "\"quantumEfficiency\": {\"wavelength_um\": [5, 3], \"values\": [1, 1]}",
                 "detector.quantumEfficiency"},
             Row{"\"quantumEfficiency\": 0.7", "\"absorption\": 0.7", "no response"},
             Row{"\"quantumEfficiency\": 0.7",
                 "\"quantumEfficiency\": 0.7, \"responsivity_A_per_W\": 2", "several responses"},
             Row{"\"gain_e_per_count\"", "\"gain_W_per_count\"", "gain_e_per_count"},
             Row{"\"format\": \"smat-sensor\"", "\"format\": \"smat-codes\"", "smat-sensor"},
             Row{"\"version\": 1", "\"version\": 2", "version"},
             Row{"\"bits\": 20", "\"bits\": 20.5", "electronics.bits, line"},
             Row{"\"bits\": 20", "\"bits\": 20, \"bits\": 21", "electronics.bits"},
         }) {
        const std::string said = messageOf(replaced(good, row.from, row.to));
        EXPECT_NE(said.find(row.said), std::string::npos) << row.to << ": " << said;
    }
    EXPECT_NE(messageOf("[").find("line 1"), std::string::npos);
    EXPECT_NE(messageOf("{}").find("format"), std::string::npos);
}

TEST(SensorFile, TheLibraryIsWholeAndStatesItsSources) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(library)) {
        const SensorDescription sensor = loadSensor(entry.path());
        EXPECT_FALSE(sensor.title.empty()) << entry.path();
        EXPECT_GT(sensor.source.size(), 40u) << entry.path();
        ++count;
    }
    EXPECT_EQ(count, 6);
}

} // namespace

} // namespace irsg
