#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/signature/ScalingXml.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;

/// The sample aircraft in a folder of its own, small and without air, so that a run takes a second.
class SmatBatchMonteCarlo : public testing::Test {
  protected:
    SmatBatchMonteCarlo() {
        for (const char* name :
             {"turboprop4.flt", "turboprop4.sigdb", "turboprop4(temperaturesScalings).xml",
              "turboprop4(emissivitiesScalings).xml"}) {
            std::filesystem::copy(sample("turboprop4") / std::filesystem::path(name),
                                  folder / name);
        }
        write(folder / "t.smat", R"({"version": 1,
  "models": [{"file": "turboprop4.flt", "database": "turboprop4.sigdb"}],
  "sensor": {"fov": 4, "width": 160, "height": 128},
  "state": {"power": 0.7},
  "polar": {"step": 60},
  "analyses": {"picture": {"kind": "image"}, "turn": {"kind": "polar"}}})");
    }
    Ran run(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"montecarlo", "t.smat"});
        return smatBatch(arguments, folder.path());
    }
    std::string image(const std::string& name, std::vector<std::string> more) {
        more.insert(more.begin(), {"image", "t.smat", "--out", name});
        const Ran ran = smatBatch(more, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        // The command in the provenance may differ, the numbers count.
        std::string numbers;
        std::istringstream lines(contentOf(folder / name));
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line.front() != '#') {
                numbers += line + "\n";
            }
        }
        return numbers;
    }
    void rewriteScales(irsg::ScalingKind kind, double low, double high) {
        const std::filesystem::path file = irsg::scalingFile(folder / "turboprop4.flt", kind);
        irsg::ScalingTable table = irsg::readScalingFile(file, kind);
        for (auto& [index, entry] : table) {
            entry.distribution = irsg::Distribution(irsg::DistributionKind::uniform, low, high);
        }
        write(file, irsg::scalingXml(table));
    }

    TemporaryFolder folder;
};

TEST_F(SmatBatchMonteCarlo, WritesBandsAndRankingOfTheFirstAnalysisThatIsNoImage) {
    const Ran ran = run({"--samples", "300", "--seed", "5", "--phases", "2", "--ranking-pairs",
                         "256", "--percentiles", "10,90", "--out", "mc.csv", "--out", "mc.json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("turn (polar): complete"));
    EXPECT_THAT(ran.out, HasSubstr("Draws"));
    const ResultTable bands = ResultTable::load(folder / "mc.csv");
    EXPECT_EQ(bands.rowCount(), 6u);
    for (const char* key : {"angle", "nominal", "mean", "standard_deviation", "standard_error",
                            "minimum", "p10", "p90", "maximum", "error_numerical"}) {
        EXPECT_NE(bands.find(key), nullptr) << key;
    }
    EXPECT_EQ(bands.provenance.value("monte carlo"), "300 draws of the sobol sequence, seed 5");
    EXPECT_THAT(bands.provenance.value("command"), HasSubstr("montecarlo"));
    EXPECT_EQ(ResultTable::load(folder / "mc-ranking.csv").rowCount(), 11u);
    const auto json = nlohmann::json::parse(contentOf(folder / "mc.json"));
    EXPECT_EQ(json["draws"], 300);
    EXPECT_EQ(json["ranking"].size(), 11u);
    EXPECT_EQ(json["scales"][0]["distribution"], "normal");
}

TEST_F(SmatBatchMonteCarlo, RepeatsAKindWithTheSettingsOfTheProject) {
    const Ran ran = run({"--kind", "range", "--samples", "64", "--phases", "1", "--set",
                         "range.points=3", "--out", "mc.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(ResultTable::load(folder / "mc.csv").rowCount(), 3u);
    EXPECT_THAT(run({"--kind", "image", "--out", "mc.csv"}).err, HasSubstr("polar, range, time"));
    EXPECT_THAT(run({"--kind", "polar", "--analysis", "turn", "--out", "mc.csv"}).err,
                HasSubstr("nothing beside --analysis"));
}

TEST_F(SmatBatchMonteCarlo, GivesTheSameBytesTwiceAndOthersWithAnotherSeed) {
    for (const char* name : {"a.csv", "b.csv"}) {
        ASSERT_EQ(run({"--samples", "64", "--phases", "1", "--sequence", "plain", "--out", name})
                      .exitCode,
                  0);
    }
    const auto numbers = [&](const char* name) {
        return ResultTable::load(folder / name).columns();
    };
    EXPECT_EQ(numbers("a.csv"), numbers("b.csv"));
    ASSERT_EQ(run({"--samples", "64", "--phases", "1", "--sequence", "plain", "--seed", "2",
                   "--out", "c.csv"})
                  .exitCode,
              0);
    EXPECT_NE(numbers("a.csv"), numbers("c.csv"));
}

TEST_F(SmatBatchMonteCarlo, AgreesWithTheAnalysisOfTheFirstDraw) {
    ASSERT_EQ(run({"--samples", "2", "--phases", "1", "--sequence", "plain", "--percentiles", "50",
                   "--out", "mc.csv"})
                  .exitCode,
              0);
    ASSERT_EQ(smatBatch({"polar", "t.smat", "--analysis", "turn", "--scalings", "--out", "one.csv"},
                        folder.path())
                  .exitCode,
              0);
    const ResultTable bands = ResultTable::load(folder / "mc.csv");
    const ResultTable one = ResultTable::load(folder / "one.csv");
    for (std::size_t k = 0; k < one.rowCount(); ++k) {
        // Of two draws, draw 0 is the least or the largest.
        const double found = one.find("contrast_intensity")->values[k];
        const double low = bands.find("minimum")->values[k];
        const double high = bands.find("maximum")->values[k];
        EXPECT_LT(std::min(std::abs(found - low), std::abs(found - high)), 1e-4 * std::abs(found));
    }
}

TEST_F(SmatBatchMonteCarlo, ScalesOfOneGiveTheIdenticalImageAndSeedsRepeat) {
    const std::string plain = image("plain.csv", {});
    const std::string seed1 = image("seed1.csv", {"--scalings", "--seed", "1"});
    EXPECT_NE(plain, seed1);
    EXPECT_EQ(seed1, image("again.csv", {"--scalings", "--seed", "1"}));
    EXPECT_NE(seed1, image("seed2.csv", {"--scalings", "--seed", "2"}));
    for (const auto kind : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity}) {
        rewriteScales(kind, 1.0, 1.0);
    }
    EXPECT_EQ(plain, image("ones.csv", {"--scalings", "--seed", "2"}));
}

TEST_F(SmatBatchMonteCarlo, SavingADatabaseWritesScalingFilesOnlyWhereThereAreNone) {
    const std::filesystem::path scales =
        irsg::scalingFile(folder / "turboprop4.flt", irsg::ScalingKind::temperature);
    const std::string mine = contentOf(scales);
    std::filesystem::remove(
        irsg::scalingFile(folder / "turboprop4.flt", irsg::ScalingKind::emissivity));
    const Ran ran =
        smatBatch({"db", "create", "new.sigdb", "--model", "turboprop4.flt"}, folder.path());
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(contentOf(scales), mine);
    EXPECT_THAT(
        contentOf(irsg::scalingFile(folder / "turboprop4.flt", irsg::ScalingKind::emissivity)),
        HasSubstr("<vector3>"));
    std::filesystem::remove(scales);
    ASSERT_EQ(smatBatch({"db", "export", "turboprop4.sigdb", "t.json"}, folder.path()).exitCode, 0);
    ASSERT_EQ(smatBatch({"db", "import", "t.json", "copy.sigdb", "--model", "turboprop4.flt"},
                        folder.path())
                  .exitCode,
              0);
    EXPECT_THAT(contentOf(scales), HasSubstr("exhaust"));
}

TEST_F(SmatBatchMonteCarlo, RefusesWhatItCannotDo) {
    const struct {
        const char* name;
        std::vector<std::string> arguments;
        const char* says;
    } rows[] = {
        {"no file", {}, "--out"},
        {"another extension", {"--out", "mc.png"}, ".csv or .json"},
        {"an image", {"--analysis", "picture", "--out", "a.csv"}, "an image"},
        {"an analysis that is not there",
         {"--analysis", "x", "--out", "a.csv"},
         "one of picture, turn"},
        {"a word for a number", {"--samples", "many", "--out", "a.csv"}, "a finite number"},
        {"half a draw", {"--samples", "2.5", "--out", "a.csv"}, "a whole number"},
        {"no draws", {"--samples", "0", "--out", "a.csv"}, "from 2 to 1e7"},
        {"another sequence", {"--sequence", "halton", "--out", "a.csv"}, "sobol or plain"},
        {"another statistic",
         {"--statistic", "p200", "--out", "a.csv"},
         "a percentile such as p95"},
        {"another quantity", {"--quantity", "heat", "--out", "a.csv"}, "irradiance"},
        {"percentiles that are none",
         {"--percentiles", "5,x", "--out", "a.csv"},
         "separated by commas"},
        {"a standard error of 2", {"--standard-error", "2", "--out", "a.csv"}, "below 1"},
    };
    for (const auto& row : rows) {
        const Ran ran = run(row.arguments);
        EXPECT_EQ(ran.exitCode, 2) << row.name;
        EXPECT_THAT(ran.err, HasSubstr(row.says)) << row.name;
    }
    write(irsg::scalingFile(folder / "turboprop4.flt", irsg::ScalingKind::temperature), "<data>");
    EXPECT_THAT(run({"--out", "a.csv"}).err, HasSubstr("well-formed"));
    for (const auto kind : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity}) {
        std::filesystem::remove(irsg::scalingFile(folder / "turboprop4.flt", kind));
    }
    EXPECT_THAT(run({"--out", "a.csv"}).err, HasSubstr("a scaling file beside the model"));
}

TEST_F(SmatBatchMonteCarlo, StopsAtAStandardErrorOrSaysThatItDidNot) {
    Ran ran =
        run({"--samples", "20000", "--phases", "1", "--standard-error", "0.01", "--out", "a.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ResultTable::load(folder / "a.csv").provenance.value("monte carlo"),
                testing::Not(HasSubstr("20000")));
    ran = run({"--samples", "300", "--phases", "1", "--standard-error", "1e-9", "--out", "b.csv"});
    EXPECT_THAT(ran.out, HasSubstr("1e-09 was asked for"));
}

} // namespace
} // namespace smat::test
