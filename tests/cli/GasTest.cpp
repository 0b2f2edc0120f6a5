#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/CsvTable.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

const std::string plume = "T_K=700,p_atm=1,length_m=0.5,CO2=0.033,H2O=0.033";

class SmatBatchGas : public testing::Test {
  protected:
    ResultTable made(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "gas");
        arguments.insert(arguments.end(), {"--out", "gas.csv"});
        const Ran ran = smatBatch(arguments, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ResultTable::load(folder / "gas.csv");
    }
    static double number(const ResultTable& table, const std::string& key) {
        return irsg::parseNumber(table.provenance.value(key)).value_or(std::nan(""));
    }

    TemporaryFolder folder;
};

TEST_F(SmatBatchGas, WritesTheSpectrumAndTheBand) {
    const ResultTable table = made({"--layer", plume, "--band", "3-5"});
    const auto& nu = table.find("wavenumber")->values;
    ASSERT_EQ(nu.size(), 268u);
    // Cells about multiples of 5 cm-1, of which the band cuts the first and the last.
    EXPECT_EQ(nu.front(), 0.5 * (2000.0 + 2002.5));
    EXPECT_EQ(nu[1], 2005.0);
    EXPECT_NEAR(nu.back(), 0.5 * (3332.5 + 1e4 / 3.0), 1e-9);
    EXPECT_EQ(table.find("spectral_radiance")->unit, "W m-2 sr-1 um-1");
    double sum = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < nu.size(); ++i) {
        const double multiple = 2000.0 + 5.0 * static_cast<double>(i);
        const double lower = std::max(2000.0, multiple - 2.5),
                     upper = std::min(1e4 / 3.0, multiple + 2.5);
        const double width_um = 1e4 / lower - 1e4 / upper;
        sum += table.find("spectral_radiance")->values[i] * width_um;
        mean += table.find("transmittance")->values[i] * width_um / 2.0;
    }
    const double radiance = number(table, "band_radiance [W m-2 sr-1]");
    EXPECT_NEAR(radiance, sum, 1e-9 * sum);
    EXPECT_NEAR(number(table, "band_transmittance"), mean, 1e-9);
    // RADCAL itself says 74 at 600 and 934 at 1000 K.
    EXPECT_GT(radiance, 150.0);
    EXPECT_LT(radiance, 220.0);
    EXPECT_GT(number(table, "error_band_radiance [W m-2 sr-1]"), 0.0);
    EXPECT_THAT(table.provenance.value("source of CO2"), testing::Not(testing::IsEmpty()));
    EXPECT_EQ(table.provenance.value("source of CO"), "") << "there is none";
    EXPECT_EQ(table.provenance.value("layer"), plume);
}

TEST_F(SmatBatchGas, WritesJsonWithTheSameNumbers) {
    const ResultTable csv = made({"--layer", plume, "--source", "radcal"});
    const Ran ran = smatBatch({"gas", "--layer", plume, "--source", "radcal", "--out", "gas.json"},
                              folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable json = ResultTable::load(folder / "gas.json");
    EXPECT_EQ(json.columns(), csv.columns());
    EXPECT_EQ(csv.provenance.value("band_radiance_source_radcal [W m-2 sr-1]"), "");
    EXPECT_NEAR(number(made({"--layer", plume}), "band_radiance_source_radcal [W m-2 sr-1]"),
                number(json, "band_radiance [W m-2 sr-1]"), 1e-9)
        << "beside what lines say";
    EXPECT_EQ(number(json, "band_radiance [W m-2 sr-1]"),
              number(csv, "band_radiance [W m-2 sr-1]"));
}

TEST_F(SmatBatchGas, SeesALayerThroughThoseBeforeIt) {
    const std::string cold = "T_K=300,p_atm=1,length_m=1,CO2=0.2,H2O=0.2";
    const auto radiance = [&](std::vector<std::string> layers) {
        std::vector<std::string> words;
        for (const std::string& layer : layers) {
            words.insert(words.end(), {"--layer", layer});
        }
        return number(made(words), "band_radiance [W m-2 sr-1]");
    };
    EXPECT_LT(radiance({cold, plume}), 0.5 * radiance({plume, cold}));
    EXPECT_NEAR(radiance({plume, cold}), radiance({plume}), 0.1 * radiance({plume}));
}

TEST_F(SmatBatchGas, IsSeenThroughAnAtmosphere) {
    write(folder / "haze.csv", "# name: haze\n# air_temperature [K]: 290\n"
                               "wavelength [um],extinction [km-1]\n2.5,1\n6,1\n");
    const ResultTable near =
        made({"--layer", plume, "--atmosphere", "haze.csv", "--altitude", "10", "--range", "1000"});
    const ResultTable alone = made({"--layer", plume});
    const double tau = std::exp(-1.0);
    const char* const radiance = "band_radiance [W m-2 sr-1]";
    EXPECT_NEAR(number(near, radiance), tau * number(alone, radiance),
                1e-4 * number(near, radiance));
    EXPECT_NEAR(number(near, "band_transmittance"), tau * number(alone, "band_transmittance"),
                1e-4);
    EXPECT_NEAR(number(near, "band_radiance_source [W m-2 sr-1]"), number(alone, radiance), 1e-9);
    EXPECT_GT(number(near, "band_path_radiance [W m-2 sr-1]"), 0.0);
    EXPECT_EQ(near.provenance.value("range [m]"), "1000");
}

TEST_F(SmatBatchGas, KnowsThatItsLinesCoincideWithThoseOfAComputedAtmosphere) {
    const std::string air = (std::filesystem::path(SMAT_SOURCE_DIR) / "resources" / "atmospheres" /
                             "midlatitude-summer-rural-23km.xml")
                                .string();
    const std::string water = "T_K=700,p_atm=1,length_m=1,H2O=0.05";
    const ResultTable table = made({"--layer", water, "--band", "4.55-5", "--atmosphere", air,
                                    "--altitude", "20", "--range", "1000"});
    const double radiance = number(table, "band_radiance [W m-2 sr-1]");
    const double product = number(table, "band_radiance_product [W m-2 sr-1]");
    EXPECT_GT(radiance, 0.25 * product);
    EXPECT_LT(radiance, 0.5 * product);
    EXPECT_GT(number(table, "error_band_radiance [W m-2 sr-1]"), 0.03 * radiance);
    EXPECT_THAT(table.provenance.value("correlation of lines"), HasSubstr("line by line"));
    EXPECT_EQ(table.provenance.value("warning"), "");
    // An atmosphere that is a transmittance alone cannot tell.
    write(folder / "haze.csv", "# name: haze\n# air_temperature [K]: 290\n"
                               "wavelength [um],extinction [km-1]\n2.5,1\n6,1\n");
    const ResultTable grey = made({"--layer", water, "--band", "4.55-5", "--atmosphere", "haze.csv",
                                   "--altitude", "20", "--range", "1000"});
    EXPECT_EQ(number(grey, "band_radiance [W m-2 sr-1]"),
              number(grey, "band_radiance_product [W m-2 sr-1]"));
    EXPECT_THAT(grey.provenance.value("warning"), HasSubstr("haze"));
}

struct Row {
    const char* name;
    std::vector<std::string> arguments, named;
};
class SmatBatchGasRefuses : public testing::TestWithParam<Row> {};

TEST_P(SmatBatchGasRefuses, ByName) {
    const TemporaryFolder folder;
    std::vector<std::string> words{"gas", "--out", "gas.csv"};
    words.insert(words.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    const Ran ran = smatBatch(words, folder.path());
    EXPECT_EQ(ran.exitCode, 2);
    for (const std::string& part : GetParam().named) {
        EXPECT_THAT(ran.err, HasSubstr(part));
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "gas.csv"));
}

INSTANTIATE_TEST_SUITE_P(
    Options, SmatBatchGasRefuses,
    testing::Values(
        Row{"NoLayer", {}, {"--layer", "found nothing"}},
        Row{"UnknownGas", {"--layer", plume + ",C0=0.1"}, {"--layer 1", "did you mean 'CO'"}},
        Row{"SecondLayer",
            {"--layer", plume, "--layer", "T_K=9,p_atm=1,length_m=1"},
            {"--layer 2: T_K", "250 to 3000"}},
        Row{"OpenBand", {"--layer", plume, "--band", "3-"}, {"band", "3-"}},
        Row{"WideBand", {"--layer", plume, "--band", "0.4-5"}, {"0.4-5", "within 1-200 um"}},
        Row{"UnknownSource", {"--layer", plume, "--source", "radcel"}, {"did you mean 'radcal'"}},
        Row{"Step", {"--layer", plume, "--step", "0"}, {"step", "from 1 to 100"}},
        Row{"WordForANumber", {"--layer", plume, "--step", "fine"}, {"--step", "fine"}},
        Row{"RangeInVacuum", {"--layer", plume, "--range", "5"}, {"--range", "--atmosphere"}},
        Row{"NoRange",
            {"--layer", plume, "--atmosphere", "x.csv", "--altitude", "5"},
            {"--range", "found nothing"}},
        Row{"NoAtmosphere",
            {"--layer", plume, "--atmosphere", "x.csv", "--altitude", "5", "--range", "5"},
            {"x.csv"}}),
    [](const auto& row) { return std::string(row.param.name); });

} // namespace
} // namespace smat::test
