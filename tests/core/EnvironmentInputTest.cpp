#include "smatcore/project/EnvironmentInput.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereSmart.h"
#include "irsg/core/Errors.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/tools/RadiativeOutput.h"
#include "tests/atmosphere/KarmaSupport.h"
#include "tests/support/BinComparison.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::HasSubstr;

const irsg::AtmosphereSmart& smartOf(const irsg::Environment& environment, std::size_t place) {
    return dynamic_cast<const irsg::AtmosphereSmart&>(*environment.atmospheres().at(place));
}

class EnvironmentInput : public testing::Test {
  protected:
    std::filesystem::path written(const std::string& name, const std::string& text) const {
        return irsg::writtenFile(folder_ / name, text);
    }
    irsg::Environment environmentOf(const std::filesystem::path& file,
                                    std::optional<int> resolution_per_cm = {}) const {
        irsg::Environment environment;
        addAtmosphere(environment, {file}, resolution_per_cm);
        return environment;
    }
    std::filesystem::path haze() const {
        return written("haze.csv", "wavelength [um],extinction [km-1]\n2,0.1\n12,0.1\n");
    }

  private:
    const test::TemporaryFolder folder_;
};

TEST_F(EnvironmentInput, AResolutionTakesThePlaceOfTheFilesOwn) {
    const auto file = written("air.xml", irsg::smartXml(irsg::numberXml("Resolution", "15") +
                                                        irsg::numberXml("Visibility", "9000")));
    EXPECT_EQ(smartOf(environmentOf(file), 0).parameters().resolution_per_cm, 15);
    const irsg::Environment fine = environmentOf(file, 1);
    const irsg::AtmosphereSmart& air = smartOf(fine, 0);
    EXPECT_EQ(air.parameters().resolution_per_cm, 1);
    EXPECT_EQ(air.parameters().visibility_m, 9000.0);
    EXPECT_EQ(air.name(), "AtmosphereSmart (air.xml)");
    EXPECT_THAT(air.remarks(), testing::Contains(HasSubstr("no AerosolModel")));
}

TEST_F(EnvironmentInput, AResolutionReachesEveryAtmosphereOfAnEnvironmentThatHasBins) {
    haze();
    written("air.xml", irsg::smartXml(""));
    const auto world = written(
        "sub/world.xml",
        irsg::environmentXml("<composition>\n" + irsg::compositeXml("one", "../air.xml", 1) +
                             irsg::compositeXml("two", "../haze.csv", 2) +
                             irsg::compositeXml("three", "../air.xml", 3) + "</composition>"));
    const irsg::Environment environment = environmentOf(world, 15);
    ASSERT_EQ(environment.atmospheres().size(), 3u);
    EXPECT_EQ(smartOf(environment, 0).parameters().resolution_per_cm, 15);
    EXPECT_EQ(environment.atmospheres()[1]->name(), "Beer-Lambert (haze.csv)");
    EXPECT_EQ(smartOf(environment, 2).parameters().resolution_per_cm, 15);
}

TEST_F(EnvironmentInput, AResolutionOfAirWithoutBinsIsRefused) {
    EXPECT_THAT(irsg::refusalOf([&] { environmentOf(haze(), 5); }),
                HasSubstr("Beer-Lambert (haze.csv): resolution: found 5 cm-1"));
    EXPECT_THAT(
        irsg::refusalOf([&] { environmentOf(written("world.xml", irsg::environmentXml("")), 5); }),
        HasSubstr("environment: resolution"));
}

TEST_F(EnvironmentInput, ARadiosondeIsLookedForBesideTheFileAtEveryResolution) {
    written("sub/ascent.csv", "altitude [m],pressure [hPa],temperature [K],relative_humidity [%]\n"
                              "0,1010,290,60\n1000,896,283,50\n");
    written("sub/air.xml",
            irsg::smartXml("<parameter name=\"Radiosonde\"><string>ascent.csv</string>"
                           "</parameter>\n"));
    const auto world =
        written("world.xml", irsg::environmentXml("<composition>\n" +
                                                  irsg::compositeXml("one", "sub/air.xml", 1) +
                                                  "</composition>"));
    EXPECT_EQ(environmentOf(world, 15).ambientTemperature_K(500.0).value, 286.5);
}

TEST_F(EnvironmentInput, TheFirstSunAndDefaultBackgroundAreGivenBack) {
    const auto world = written(
        "world.xml", irsg::environmentXml(irsg::numberXml("SunElevation", "0.25") +
                                          irsg::vectorXml("BackgroundRadianceWavelengths", "3 5") +
                                          irsg::vectorXml("BackgroundRadianceValues", "2 2")));
    irsg::Environment environment;
    EXPECT_FALSE(addAtmosphere(environment, {haze()}).has_value());
    EXPECT_EQ(addAtmosphere(environment, {world})->elevation_rad, 0.25);
    EXPECT_EQ(environment.defaultBackground->at(4.0), 2.0);
}

// F29: of an Environment without any atmosphere the background is its own, and there is no air.
TEST_F(EnvironmentInput, TheBackgroundOfAnEnvironmentWithoutAtmospheresIsSeenThroughVacuum) {
    const auto world = written(
        "world.xml", irsg::environmentXml(irsg::vectorXml("BackgroundRadianceWavelengths", "3 5") +
                                          irsg::vectorXml("BackgroundRadianceValues", "2 3")));
    Project project;
    Settings settings;
    settings.set("environment.atmospheres", world.string());
    const irsg::Environment environment = smat::environmentOf(project, settings);
    const irsg::SpectralPoints points({3.0, 4.0, 5.0});
    const auto seen = environment.provide(
        irsg::AtmosphericQuery::backgroundRadiance({0.0, 0.2, 0.0}, environment.sun), points);
    EXPECT_EQ(seen.value, (std::vector<double>{2.0, 2.5, 3.0}));
    EXPECT_EQ(seen.providedBy, "default");
    EXPECT_EQ(
        environment.provide(irsg::AtmosphericQuery::transmittance({0.0, 0.0, 1e4}), points).value,
        (std::vector<double>{1.0, 1.0, 1.0}));
    settings.set("environment.atmospheres", "none");
    EXPECT_EQ(
        smat::environmentOf(project, settings)
            .provide(irsg::AtmosphericQuery::backgroundRadiance({0.0, 0.2, 0.0}, environment.sun),
                     points)
            .providedBy,
        "vacuum");
}

TEST_F(EnvironmentInput, TheSunAloneIsThatOfTheWholeEnvironment) {
    const auto world =
        written("world.xml", irsg::environmentXml(irsg::numberXml("SunAzimuth", "4.0") +
                                                  irsg::numberXml("SunElevation", "0.25")));
    const auto other =
        written("other.xml", irsg::environmentXml(irsg::numberXml("SunAzimuth", "1.0") +
                                                  irsg::numberXml("SunElevation", "1.25")));
    const auto both = haze().string() + ";" + world.string() + ";" + other.string();
    Project project;
    struct Row {
        const char* name;
        std::string air;
        const char *azimuth_deg, *elevation_deg; ///< null where the project does not set it
        double azimuth_rad, elevation_rad;
    };
    const double degree = std::numbers::pi / 180.0;
    for (const Row& row :
         {Row{"settings alone", "none", "30", "10", 30 * degree, 10 * degree},
          Row{"defaults", haze().string(), nullptr, nullptr, 180 * degree, 45 * degree},
          Row{"the first file", both, nullptr, nullptr, 4.0, 0.25},
          Row{"own azimuth", both, "30", nullptr, 30 * degree, 0.25},
          Row{"own elevation", both, nullptr, "10", 4.0, 10 * degree}}) {
        Settings settings;
        settings.set("environment.atmospheres", row.air);
        if (row.azimuth_deg != nullptr) {
            settings.set("environment.sunAzimuth", row.azimuth_deg);
        }
        if (row.elevation_deg != nullptr) {
            settings.set("environment.sunElevation", row.elevation_deg);
        }
        const irsg::SunPosition sun = sunOf(project, settings);
        EXPECT_NEAR(sun.azimuth_rad, row.azimuth_rad, 1e-12) << row.name;
        EXPECT_NEAR(sun.elevation_rad, row.elevation_rad, 1e-12) << row.name;
        const irsg::SunPosition whole = smat::environmentOf(project, settings).sun;
        EXPECT_EQ(sun.azimuth_rad, whole.azimuth_rad) << row.name;
        EXPECT_EQ(sun.elevation_rad, whole.elevation_rad) << row.name;
    }
    // A file that cannot be read says nothing of the sun; the analysis says what is wrong with it.
    Settings broken;
    broken.set(
        "environment.atmospheres",
        written("broken.xml", irsg::environmentXml(irsg::numberXml("SunAzimuth", "9"))).string());
    EXPECT_NEAR(sunOf(project, broken).elevation_rad, 45 * degree, 1e-12);
}

TEST_F(EnvironmentInput, WideBinsAreTheMeansOfTheNarrowOnesInside) {
    const auto file = written("air.xml", irsg::smartXml(irsg::numberXml("IrradianceMode", "2")));
    RadiativeRequest request;
    for (const RadiativeQuantity& known : radiativeQuantities()) {
        request.quantities.push_back(known.property);
    }
    request.geometry = {.sensorAltitude_m = 200.0, .targetAltitude_m = 3000.0, .range_m = 6000.0};
    request.band = {3.0, 5.0};
    const ResultTable narrow = radiativeOutput(environmentOf(file, 1), request).table;
    // Each width has nodes of its own, so that they agree to the error of the nodes: RMS, and the
    // worst bin, of the largest value.
    for (const double width_per_cm : {5.0, 15.0}) {
        const ResultTable wide =
            radiativeOutput(environmentOf(file, static_cast<int>(width_per_cm)), request).table;
        for (const char* column :
             {"transmittance", "path_radiance", "background_radiance", "solar_irradiance",
              "up_flux", "down_flux", "scattering_optical_depth"}) {
            const test::BinComparison found =
                test::compareBins(narrow, 1.0, wide, width_per_cm, column);
            EXPECT_GE(found.bins, width_per_cm == 5.0 ? 265u : 87u) << column;
            EXPECT_LE(found.rms, 0.006 * found.largest) << column << ", " << width_per_cm;
            EXPECT_LE(found.worst, 0.03 * found.largest) << column << ", " << width_per_cm;
        }
    }
}

} // namespace
} // namespace smat
