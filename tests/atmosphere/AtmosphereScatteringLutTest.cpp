#include "irsg/atmosphere/AtmosphereScatteringLut.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/atmosphere/AtmosphereFile.h"
#include "irsg/atmosphere/Vacuum.h"
#include "irsg/atmosphere/import/EnvironmentXml.h"
#include "irsg/core/Errors.h"
#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

using smat::test::TemporaryFolder;
using testing::HasSubstr;

void put(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string lutXml(const std::string& parameters) {
    return "<data><fileType>Parameters</fileType>"
           "<type>/Environment/Root/Atmosphere/AtmosphereScatteringLUT</type>\n" +
           parameters + "</data>";
}
const std::string database =
    "<parameter name=\"MTFDatabase\"><string>fog.mtf</string></parameter>\n";

TEST(AtmosphereScatteringLut, IsReadFromItsFile) {
    const TemporaryFolder folder;
    put(folder / "fog.mtf", "x");
    put(folder / "lut.xml",
        lutXml(database +
               "<parameter name=\"ScatteringCoefficient\"><double>2.5</double></parameter>\n"));
    const auto air = loadAtmosphere(folder / "lut.xml");
    const auto* lut = dynamic_cast<const AtmosphereScatteringLut*>(air.get());
    ASSERT_NE(lut, nullptr);
    EXPECT_EQ(lut->database().filename(), "fog.mtf");
    EXPECT_DOUBLE_EQ(lut->coefficient_per_m(), 2.5e-3);
    const AtmosphericPath path{.sensorAltitude_m = 10, .targetAltitude_m = 10, .range_m = 800};
    EXPECT_NEAR(lut->scatteringOpticalDepth(path, {3, 5}).at(4.0), 2.0, 1e-12);
    EXPECT_FALSE(lut->supports(AtmosphereProperty::transmittance));
}

TEST(AtmosphereScatteringLut, IsAMemberOfAnEnvironment) {
    const TemporaryFolder folder;
    put(folder / "fog.mtf", "x");
    put(folder / "lut.xml", lutXml(database));
    put(folder / "e.xml",
        "<data><fileType>Parameters</fileType><type>/Environment/Root/Environment</type>"
        "<parameter name=\"SunAzimuth\"><double>0</double></parameter>"
        "<parameter name=\"SunElevation\"><double>0.5</double></parameter>"
        "<composition><composite name=\"a\"><component>AtmosphereScatteringLUT</component>"
        "<parameters>lut.xml</parameters><composition>none</composition><priority>1</priority>"
        "</composite></composition></data>");
    const Environment environment = loadEnvironment(folder / "e.xml").environment;
    const AtmosphereScatteringLut* lut = scatteringLutOf(environment);
    ASSERT_NE(lut, nullptr);
    EXPECT_EQ(lut->coefficient_per_m(), 0.0);
    // It leaves the optical depth to others then.
    EXPECT_FALSE(lut->supports(AtmosphereProperty::scatteringOpticalDepth));
    EXPECT_EQ(scatteringLutOf(Environment::vacuum()), nullptr);
}

TEST(AtmosphereScatteringLut, RefusesWhatIsWrongWithItsFile) {
    struct Wrong {
        const char *name, *parameters, *message;
    };
    const TemporaryFolder folder;
    put(folder / "fog.mtf", "x");
    for (const Wrong& wrong :
         {Wrong{"no database", "", "MTFDatabase"},
          Wrong{"a number in its place",
                "<parameter name=\"MTFDatabase\"><double>1</double></parameter>", "a string"},
          Wrong{"no such file",
                "<parameter name=\"MTFDatabase\"><string>none.mtf</string></parameter>",
                "none.mtf"},
          Wrong{"a negative coefficient",
                "<parameter name=\"MTFDatabase\"><string>fog.mtf</string></parameter>"
                "<parameter name=\"ScatteringCoefficient\"><double>-1</double></parameter>",
                "at least 0"}}) {
        SCOPED_TRACE(wrong.name);
        put(folder / "lut.xml", lutXml(wrong.parameters));
        try {
            loadAtmosphere(folder / "lut.xml");
            ADD_FAILURE() << "was read";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), HasSubstr("lut.xml"));
            EXPECT_THAT(error.what(), HasSubstr(wrong.message));
        }
    }
}

} // namespace
} // namespace irsg
