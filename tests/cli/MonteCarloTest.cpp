#include <algorithm>
#include <cmath>

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
  "render": {"lightError": 0.02},
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
    const Ran ran =
        run({"--samples", "300", "--seed", "5", "--subpixel-shifts", "2", "--ranking-pairs", "256",
             "--percentiles", "10,90", "--out", "mc.csv", "--out", "mc.json"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("turn (polar): complete"));
    EXPECT_THAT(ran.out, HasSubstr("Draws"));
    const ResultTable bands = ResultTable::load(folder / "mc.csv");
    EXPECT_EQ(bands.rowCount(), 6u);
    for (const char* key : {"angle", "nominal", "mean", "standard_deviation", "standard_error",
                            "minimum", "p10", "p90", "maximum", "error_numerical"}) {
        EXPECT_NE(bands.find(key), nullptr) << key;
    }
    // No less than the error that a sweep states.
    ASSERT_EQ(run({"--samples", "2", "--subpixel-shifts", "2", "--errors", "sum", "--out", "e.csv"})
                  .exitCode,
              0);
    const ResultTable stated = ResultTable::load(folder / "e.csv");
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_GT(stated.find("error_nominal")->values[i], 0.0);
        EXPECT_GE(bands.find("error_numerical")->values[i],
                  stated.find("error_nominal")->values[i]);
    }
    EXPECT_EQ(bands.provenance.value("monte carlo"), "300 draws of the sobol sequence, seed 5");
    EXPECT_THAT(bands.provenance.value("command"), HasSubstr("montecarlo"));
    EXPECT_EQ(ResultTable::load(folder / "mc-ranking.csv").rowCount(), 11u);
    const auto json = nlohmann::json::parse(contentOf(folder / "mc.json"));
    EXPECT_EQ(json["draws"], 300);
    EXPECT_EQ(json["ranking"].size(), 11u);
    EXPECT_EQ(json["scales"][0]["distribution"], "normal");
}

// The largest of 256 draws is below the percentile 99.9 in three of four runs: nothing bounds it.
TEST_F(SmatBatchMonteCarlo, APercentileAtTheEndsIsNotMetBeforeDrawsLieBeyondIt) {
    for (const char* sequence : {"plain", "sobol"}) {
        const Ran ran = run({"--samples", "6000", "--statistic", "p99.9", "--standard-error", "0.9",
                             "--sequence", sequence, "--subpixel-shifts", "1", "--out", "e.csv"});
        ASSERT_EQ(ran.exitCode, 0) << ran.err;
        const std::string said =
            ResultTable::load(folder / "e.csv").provenance.value("monte carlo");
        EXPECT_GE(std::stoi(said), 3688) << said; // 0.999^3688 is 0.025
    }
    const Ran few = run(
        {"--samples", "256", "--statistic", "p100", "--subpixel-shifts", "1", "--out", "e.csv"});
    ASSERT_EQ(few.exitCode, 0) << few.err;
    EXPECT_TRUE(std::isnan(ResultTable::load(folder / "e.csv").find("standard_error")->values[0]));
}

TEST_F(SmatBatchMonteCarlo, TheRankingSaysWhereItIs) {
    const Ran ran = run({"--samples", "256", "--ranking-pairs", "256", "--ranking-at", "85",
                         "--subpixel-shifts", "1", "--out", "e.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("the ranking is of 60 deg, the case that is nearest to 85"));
    EXPECT_THAT(ran.out, HasSubstr(" at 60 deg"));
    EXPECT_EQ(ResultTable::load(folder / "e-ranking.csv").provenance.value("ranked at"), "60 deg");
}

TEST_F(SmatBatchMonteCarlo, ExportsRawDrawsAlikeInBothForms) {
    const Ran ran =
        run({"--samples", "64", "--seed", "3", "--subpixel-shifts", "1", "--sequence", "plain",
             "--draws", "draws.csv", "--draws", "draws.json", "--out", "bands.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable csv = ResultTable::load(folder / "draws.csv");
    EXPECT_EQ(csv.columns(), ResultTable::load(folder / "draws.json").columns());
    EXPECT_EQ(csv.rowCount(), 64u);
    EXPECT_EQ(csv.provenance.value("monte carlo"), "64 draws of the plain sequence, seed 3");
    const ResultTable bands = ResultTable::load(folder / "bands.csv");
    double sum = 0.0, most = 0.0;
    for (const double value : csv.find("contrast_intensity at 60 deg")->values) {
        sum += value;
        most = std::max(most, value);
    }
    EXPECT_NEAR(bands.find("mean")->values[1] / (sum / 64.0), 1.0, 1e-9);
    EXPECT_EQ(bands.find("maximum")->values[1], most);

    // Draw 0 of the plain sequence is what an analysis with --scalings says that it drew.
    const Ran polar = smatBatch(
        {"polar", "t.smat", "--scalings", "--seed", "3", "--out", "one.csv"}, folder.path());
    ASSERT_EQ(polar.exitCode, 0) << polar.err;
    const ResultTable one = ResultTable::load(folder / "one.csv");
    int told = 0;
    for (const auto& [key, value] : one.provenance.entries) {
        if (key != "drawn scale") {
            continue;
        }
        const std::size_t colon = value.find(": ");
        const ResultColumn* column = csv.find("scale " + value.substr(0, colon));
        ASSERT_NE(column, nullptr) << value;
        EXPECT_EQ(std::stod(value.substr(colon + 2)), column->values[0]) << value;
        ++told;
    }
    EXPECT_EQ(told, 11);
    EXPECT_EQ(run({"--draws", "draws.txt"}).exitCode, 2);
}

TEST_F(SmatBatchMonteCarlo, OverAScenarioTellsWhatEachSensorSeesOfEachEntity) {
    const auto entity = [](const std::string& name, const std::string& place) {
        return R"({"name": ")" + name +
               R"(", "model": "turboprop4.flt", "database": "turboprop4.sigdb", "power": 0.7,
  "position_m": )" +
               place + "}";
    };
    write(folder / "s.json", R"({"version": 1, "dt_s": 1, "end_s": 1, "render": {"bounces": 0},
  "sensor": {"width": 96, "height": 64, "fov": 6},
  "entities": [)" + entity("near", "[0, 0, 500]") +
                                 ", " + entity("far", "[20, 300, 500]") + R"(],
  "sensors": [{"name": "south", "position_m": [0, -900, 500], "track": "near"}]})");
    const auto batch = [&](std::vector<std::string> words) {
        const Ran ran = smatBatch(words, folder.path());
        EXPECT_EQ(ran.exitCode, 0) << ran.err;
        return ran;
    };
    batch({"simulate", "s.json", "--scalings", "false", "--out", "plain"});
    batch({"simulate", "s.json", "--seed", "4", "--out", "drawn"});
    const auto montecarlo = [&](const std::string& threads, const std::string& name) {
        return batch({"--threads", threads, "montecarlo", "s.json", "--samples", "300", "--seed",
                      "4", "--sequence", "plain", "--out", name + ".csv", "--draws",
                      "draws-" + name + ".csv"});
    };
    const Ran ran = montecarlo("1", "one");
    EXPECT_THAT(ran.out, HasSubstr("south-near"));
    const ResultTable plain = ResultTable::load(folder / "plain/south.csv");
    const ResultTable drawn = ResultTable::load(folder / "drawn/south.csv");
    const ResultTable realisations = ResultTable::load(folder / "draws-one-south.csv");
    for (const std::string name : {"near", "far"}) {
        SCOPED_TRACE(name);
        const ResultTable bands = ResultTable::load(folder / ("one-south-" + name + ".csv"));
        ASSERT_EQ(bands.rowCount(), 2u);
        for (std::size_t row = 0; row < 2; ++row) {
            // Scales of 1 give the simulation, and draw 0 gives what it draws itself.
            const double atOne = plain.find(name + ".contrast_intensity")->values[row];
            EXPECT_NEAR(bands.find("nominal")->values[row] / atOne, 1.0, 1e-6);
            const double first = drawn.find(name + ".contrast_intensity")->values[row];
            const std::string key = name + ".contrast_intensity at " + std::to_string(row) + " s";
            ASSERT_NE(realisations.find(key), nullptr) << key;
            EXPECT_NEAR(realisations.find(key)->values[0] / first, 1.0, 1e-4);
            EXPECT_GT(std::abs(first / atOne - 1.0), 1e-2);
        }
    }
    // Both have their own scales, and together they are the sum.
    EXPECT_NE(realisations.find("scale near temperature 5 (exhaust pipes)"), nullptr);
    for (std::size_t row = 0; row < 300; ++row) {
        EXPECT_NEAR(realisations.find("near.contrast_intensity at 0 s")->values[row] +
                        realisations.find("far.contrast_intensity at 0 s")->values[row],
                    realisations.find("contrast_intensity at 0 s")->values[row],
                    1e-4 * std::abs(realisations.find("contrast_intensity at 0 s")->values[row]));
    }
    montecarlo("4", "four");
    const auto numbers = [&](const std::string& name) {
        return ResultTable::load(folder / (name + "-south-near.csv")).columns();
    };
    EXPECT_EQ(numbers("one"), numbers("four"));
    const auto refusal = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"montecarlo", "s.json", "--out", "x.csv"});
        const Ran refused = smatBatch(more, folder.path());
        EXPECT_EQ(refused.exitCode, 2);
        return refused.err;
    };
    EXPECT_THAT(refusal({"--ranking"}), HasSubstr("a project in place of a scenario"));
    EXPECT_THAT(refusal({"--kind", "polar"}), HasSubstr("a project in place of a scenario"));
    EXPECT_THAT(refusal({"--subpixel-shifts", "2"}),
                HasSubstr("subpixel shifts: found 2, expected 1"));
    EXPECT_THAT(refusal({"--sensor", "north"}), HasSubstr("the name of a sensor: south"));
    EXPECT_THAT(refusal({"--database", "x.sigdb"}), HasSubstr("a scenario names its own"));
    EXPECT_THAT(refusal({"--set", "camera.range=9"}), HasSubstr("the scenario says the rest"));
    EXPECT_THAT(run({"--sensor", "south", "--out", "x.csv"}).err,
                HasSubstr("a scenario in place of a project"));
}

TEST_F(SmatBatchMonteCarlo, RepeatsAKindWithTheSettingsOfTheProject) {
    const Ran ran = run({"--kind", "range", "--samples", "64", "--subpixel-shifts", "1", "--set",
                         "range.points=3", "--out", "mc.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_EQ(ResultTable::load(folder / "mc.csv").rowCount(), 3u);
    EXPECT_THAT(run({"--kind", "image", "--out", "mc.csv"}).err,
                HasSubstr("spectrum, polar, time, range, condition"));
    EXPECT_THAT(run({"--kind", "polar", "--analysis", "turn", "--out", "mc.csv"}).err,
                HasSubstr("nothing beside --analysis"));
}

TEST_F(SmatBatchMonteCarlo, GivesTheSameBytesTwiceAndOthersWithAnotherSeed) {
    for (const char* name : {"a.csv", "b.csv"}) {
        ASSERT_EQ(
            run({"--samples", "64", "--subpixel-shifts", "1", "--sequence", "plain", "--out", name})
                .exitCode,
            0);
    }
    const auto numbers = [&](const char* name) {
        return ResultTable::load(folder / name).columns();
    };
    EXPECT_EQ(numbers("a.csv"), numbers("b.csv"));
    ASSERT_EQ(run({"--samples", "64", "--subpixel-shifts", "1", "--sequence", "plain", "--seed",
                   "2", "--out", "c.csv"})
                  .exitCode,
              0);
    EXPECT_NE(numbers("a.csv"), numbers("c.csv"));
}

TEST_F(SmatBatchMonteCarlo, AgreesWithTheAnalysisOfTheFirstDraw) {
    ASSERT_EQ(run({"--samples", "2", "--subpixel-shifts", "1", "--sequence", "plain",
                   "--percentiles", "50", "--light-error", "0.005", "--out", "mc.csv"})
                  .exitCode,
              0);
    ASSERT_EQ(smatBatch({"polar", "t.smat", "--analysis", "turn", "--scalings", "--light-error",
                         "0.005", "--out", "one.csv"},
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
        {"no draws", {"--samples", "0", "--out", "a.csv"}, "from 2 to 10000000"},
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
    Ran ran = run({"--samples", "20000", "--subpixel-shifts", "1", "--standard-error", "0.01",
                   "--out", "a.csv"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ResultTable::load(folder / "a.csv").provenance.value("monte carlo"),
                testing::Not(HasSubstr("20000")));
    ran = run({"--samples", "300", "--subpixel-shifts", "1", "--standard-error", "1e-9", "--out",
               "b.csv"});
    EXPECT_THAT(ran.out, HasSubstr("1e-09 was asked for"));
}

} // namespace
} // namespace smat::test
