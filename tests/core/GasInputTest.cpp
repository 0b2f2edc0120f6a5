#include "smatcore/tools/GasInput.h"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/tools/GasLayerText.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

GasInput exhaust() {
    GasInput input;
    input.gas.layers = {gasLayerFromText(gasLayerExample, "layer 1")};
    return input;
}

double numberOf(const GasOutput& output, const std::string& label) {
    for (const SummaryItem& item : output.summary) {
        if (item.label == label) {
            return item.value;
        }
    }
    return std::nan("");
}

TEST(GasInput, HasTheCommandOfTheSameFile) {
    GasInput input = exhaust();
    EXPECT_EQ(gasCommand(input, "gas.csv"), std::string("smat-batch gas --layer ") +
                                                gasLayerExample + " --band 3-5 --out gas.csv");
    input.gas.layers.push_back(gasLayerFromText("T_K=300,p_atm=1,length_m=1,CO2=0.1", "layer 2"));
    input.gas.band = {4.2, 4.55};
    input.gas.step_per_cm = 10.0;
    input.gas.source = irsg::GasSource::radcal;
    input.gas.background_K = 300.0;
    input.atmosphere = {"my air.xml", "haze.csv"};
    input.altitude_m = 20.0;
    input.range_m = 1500.5;
    input.sensorAltitude_m = 10.0;
    EXPECT_EQ(gasCommand(input, "my gas.csv"),
              std::string("smat-batch gas --layer ") + gasLayerExample +
                  " --layer T_K=300,p_atm=1,length_m=1,CO2=0.1 --band 4.2-4.55 --step=10 --source "
                  "radcal --background-temperature=300 --atmosphere 'my air.xml' --atmosphere "
                  "haze.csv --altitude=20 --range=1500.5 --sensor-altitude=10 --out 'my gas.csv'");
}

TEST(GasInput, SaysAllThatIsWrongAtOnce) {
    GasInput input = exhaust();
    EXPECT_TRUE(gasInputDiagnostics(input).empty());
    input.gas.layers[0].temperature_K = 9.0;
    input.gas.step_per_cm = 0.0;
    input.gas.band = {0.4, 5.0};
    input.gas.background_K = 0.0;
    input.range_m = 5.0;
    const std::string message = refusalOf([&] { gasOutputRequest(input); });
    for (const char* part : {"layer 1: T_K", "step", "0.4-5", "background", "--range"}) {
        EXPECT_THAT(message, HasSubstr(part));
    }
    EXPECT_EQ(gasInputDiagnostics(input).size(), 5U);
    EXPECT_EQ(gasPathDiagnostics(input).size(), 1U);
}

struct Path {
    const char* name;
    std::optional<double> altitude_m, range_m, sensorAltitude_m;
    const char *option, *part; ///< of what is wrong; empty for nothing
};
class GasInputPath : public testing::TestWithParam<Path> {};

TEST_P(GasInputPath, IsCheckedBeforeAnythingIsRead) {
    const Path& row = GetParam();
    GasInput input = exhaust();
    input.atmosphere = {"not-there.csv"};
    input.altitude_m = row.altitude_m;
    input.range_m = row.range_m;
    input.sensorAltitude_m = row.sensorAltitude_m;
    const std::vector<irsg::Diagnostic> found = gasPathDiagnostics(input);
    ASSERT_EQ(found.size(), *row.option == 0 ? 0U : 1U);
    if (!found.empty()) {
        EXPECT_EQ(found[0].file, row.option);
        EXPECT_THAT(found[0].message(), HasSubstr(row.part));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Paths, GasInputPath,
    testing::Values(Path{"Sound", 20.0, 1000.0, 10.0, "", ""},
                    Path{"Level", 20.0, 0.0, std::nullopt, "", ""},
                    Path{"Upright", 20.0, 1000.0, 1020.0, "", ""},
                    Path{"NoRange", 20.0, std::nullopt, std::nullopt, "--range", "found nothing"},
                    Path{"NoAltitude", std::nullopt, 5.0, std::nullopt, "--altitude", "nothing"},
                    Path{"Underground", -1.0, 5.0, std::nullopt, "--altitude", "at least 0 m"},
                    Path{"SensorUnderground", 5.0, 5.0, -2.0, "--sensor-altitude", "at least 0 m"},
                    Path{"Backwards", 5.0, -5.0, std::nullopt, "--range", "at least 0 m"},
                    Path{"NotFinite", 5.0, INFINITY, std::nullopt, "--range", "at least 0 m"},
                    Path{"TooShort", 20.0, 999.0, 1020.0, "--range", "1000 m"}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(GasInput, HasTheSpectrumOfRadcalBesideThatOfLines) {
    TemporaryFolder folder;
    const std::string file = (folder / "haze.csv").string();
    std::ofstream(file) << "# name: haze\n# air_temperature [K]: 290\n"
                           "wavelength [um],extinction [km-1]\n2.5,1\n6,1\n";
    for (const bool hasAtmosphere : {false, true}) {
        GasInput input = exhaust();
        if (hasAtmosphere) {
            input.atmosphere = {file};
            input.altitude_m = 10.0;
            input.range_m = 1000.0;
        }
        const GasOutput lines = gasOutput(gasOutputRequest(input));
        input.gas.source = irsg::GasSource::radcal;
        const GasOutput radcal = gasOutput(gasOutputRequest(input));
        EXPECT_TRUE(radcal.radcal_W_m2_sr_um.empty());
        EXPECT_EQ(lines.radcal_W_m2_sr_um, radcal.table.find("spectral_radiance")->values);
        EXPECT_NE(lines.radcal_W_m2_sr_um, lines.table.find("spectral_radiance")->values);
        // That of the summary is of the gas alone.
        EXPECT_NEAR(numberOf(lines, "band_radiance_source_radcal") *
                        (hasAtmosphere ? std::exp(-1.0) : 1.0),
                    numberOf(radcal, "band_radiance"), 1e-4 * numberOf(radcal, "band_radiance"));
    }
}

TEST(GasInput, NamesWhoAnsweredForEachGasInTheBand) {
    GasInput input = exhaust();
    using Words = std::array<std::string, irsg::hotGasCount>;
    EXPECT_EQ(gasOutput(gasOutputRequest(input)).answeredBy, (Words{"lines", "lines", "", ""}));
    input.gas.band = {1.7, 2.3}; // beyond 5200 cm-1, where the lines of CO2 end, and 5350 of H2O
    EXPECT_EQ(gasOutput(gasOutputRequest(input)).answeredBy,
              (Words{"lines, radcal", "lines, radcal", "", ""}));
    input.gas.source = irsg::GasSource::radcal;
    EXPECT_EQ(gasOutput(gasOutputRequest(input)).answeredBy, (Words{"radcal", "radcal", "", ""}));
}

} // namespace
} // namespace smat::test
