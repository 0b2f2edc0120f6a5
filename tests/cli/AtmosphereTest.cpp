#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/atmosphere/SyntheticTape7.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// Writes a tape7 of a horizontal path and says where.
std::string tape7File(const TemporaryFolder& folder, const std::string& name, double range_km) {
    irsg::SyntheticRun run;
    run.range_km = range_km;
    run.depth = [range_km](double) { return 0.1 * range_km; };
    write(folder.path() / name, irsg::tape7(run));
    return (folder.path() / name).string();
}

TEST(SmatBatchAtmosphere, InfoTellsWhatARunSupports) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"atmosphere", "info", tape7File(folder, "tape7", 2.0)});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("supports transmittance, path radiance"));
    EXPECT_THAT(ran.out, HasSubstr("range up to 2000 m (1 path)"));
    EXPECT_THAT(ran.out, HasSubstr("not known, no run lies between two others"));
}

TEST(SmatBatchAtmosphere, ImportWritesOneTableOfAFamily) {
    const TemporaryFolder folder;
    const std::string out = (folder.path() / "family.smatatm").string();
    const Ran ran =
        smatBatch({"atmosphere", "import", tape7File(folder, "a", 1.0), tape7File(folder, "b", 2.0),
                   tape7File(folder, "c", 5.0), "--out", out});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("3 runs, 5 wavenumbers"));
    const auto json = nlohmann::json::parse(smatBatch({"atmosphere", "info", out, "--json"}).out);
    EXPECT_EQ(json["table"]["runs"].size(), 3u);
    EXPECT_EQ(json["table"]["interpolation_errors"][0]["quantity"], "transmittance");
    EXPECT_LT(json["table"]["interpolation_errors"][0]["worst"].get<double>(), 1e-6);
}

TEST(SmatBatchAtmosphere, InfoOfAHomogeneousAtmosphereTellsItsTemperatures) {
    const TemporaryFolder folder;
    write(folder.path() / "air.csv",
          "# air_temperature [K]: 280\nwavelength [um],extinction [km-1]\n3,0.1\n5,0.1\n");
    const Ran ran = smatBatch({"atmosphere", "info", (folder.path() / "air.csv").string()});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("base 3 to 5 um"));
    EXPECT_THAT(ran.out, HasSubstr("homogeneous air of 280 K"));
}

TEST(SmatBatchAtmosphere, WhatDoesNotBelongTogetherIsRefused) {
    const TemporaryFolder folder;
    const std::string run = tape7File(folder, "a", 1.0);
    const std::string out = (folder.path() / "x.smatatm").string();
    const Ran twice = smatBatch({"atmosphere", "import", run, run, "--out", out});
    EXPECT_EQ(twice.exitCode, 2);
    EXPECT_THAT(twice.err, HasSubstr("/a again"));
    EXPECT_FALSE(std::filesystem::exists(out));
    const Ran nothing = smatBatch({"atmosphere", "info", (folder.path() / "no").string()});
    EXPECT_EQ(nothing.exitCode, 2);
}

} // namespace
} // namespace smat::test
