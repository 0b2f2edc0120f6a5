// Files and command lines of before: tests/kept/README.md.
#include <cmath>
#include <map>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ImageFile.h"
#include "irsg/render/rays/RaysBuilt.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/analysis/SampleStatistics.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/results/ResultFolder.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"
#include "tests/support/WithoutProgram.h"

namespace smat::test {
namespace {

namespace fs = std::filesystem;

const fs::path kept = fs::path(SMAT_SOURCE_DIR) / "tests" / "kept";
const char* const tables[] = {"around", "away", "later", "colours"};
const char* const pictures[] = {"picture@3-5um", "picture@8-12um"};
/// Drawings of another version of a renderer may differ by this much.
constexpr double tolerance = 1e-4;

void expectTheSame(const ResultTable& now, const ResultTable& before) {
    ASSERT_EQ(now.rowCount(), before.rowCount());
    for (const ResultColumn& column : before.columns()) {
        const ResultColumn* const same = now.find(column.key);
        ASSERT_NE(same, nullptr) << column.key;
        EXPECT_EQ(same->unit, column.unit) << column.key;
        for (std::size_t i = 0; i < column.values.size(); ++i) {
            EXPECT_NEAR(same->values[i], column.values[i], tolerance * std::abs(column.values[i]))
                << column.key << ", row " << i;
        }
    }
}

TEST(KeptFiles, DatabasesOfBothVersionsAreThoseOfTheirJsonFormInEveryByteOfIt) {
    for (const auto& [name, text] :
         {std::pair{"box.sigdb", "signature.json"}, {"box-2.sigdb", "signature-2.json"}}) {
        SCOPED_TRACE(name);
        const irsg::LoadedSignature loaded = irsg::loadSignatureFile(kept / name);
        EXPECT_TRUE(loaded.changedOutside.empty());
        EXPECT_EQ(withoutProgram(irsg::signatureToJson(loaded.database)), contentOf(kept / text));
        EXPECT_TRUE(loaded.database == irsg::signatureFromJson(contentOf(kept / text), text));
    }
}

TEST(KeptFiles, DatabaseSavedAnewIsReadByTheProgramOfBefore) {
    // What that one asks of a file: version 1, and the hash of each entry as it was.
    const TemporaryFolder folder;
    const fs::path file = folder / "again.sigdb";
    irsg::saveSignatureFile(irsg::loadSignatureFile(kept / "box.sigdb").database, file);
    EXPECT_EQ(smatBatch({"db", "export", file, folder / "again.json"}).exitCode, 0);
    EXPECT_EQ(withoutProgram(contentOf(folder / "again.json")), contentOf(kept / "signature.json"));
    const auto hashesIn = [](const fs::path& of) {
        SQLite::Database sqlite(of.string());
        std::map<std::string, std::string> hashes;
        SQLite::Statement rows(sqlite, "SELECT entry, sha256 FROM content_hash");
        while (rows.executeStep()) {
            hashes[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
        }
        hashes["version"] = sqlite.execAndGet("PRAGMA user_version").getString();
        return hashes;
    };
    EXPECT_EQ(hashesIn(file), hashesIn(kept / "box.sigdb"));
}

TEST(KeptFiles, ProjectSavedAnewSaysTheSame) {
    const TemporaryFolder folder;
    for (const char* const name : {"kept.smat", "box.flt", "box.sigdb"}) {
        fs::copy_file(kept / name, folder / name);
    }
    const Project project = loadProject(folder / "kept.smat");
    saveProject(project, folder / "again.smat");
    EXPECT_EQ(nlohmann::json::parse(withoutProgram(contentOf(folder / "again.smat"))),
              nlohmann::json::parse(contentOf(kept / "kept.smat")));
}

TEST(KeptFiles, ProjectComesToTheNumbersOfBefore) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"run", kept / "kept.smat", "--out", folder / "now"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    for (const std::string name : tables) {
        SCOPED_TRACE(name);
        expectTheSame(ResultTable::load(folder / "now" / (name + ".csv")),
                      ResultTable::load(kept / "results" / (name + ".csv")));
    }
    for (const std::string name : pictures) {
        SCOPED_TRACE(name);
        const Ran compared =
            smatBatch({"compare", kept / "results" / (name + ".exr"),
                       folder / "now" / (name + ".exr"), "--fail", "1e-3", "--warn", "1e-3"});
        EXPECT_EQ(compared.exitCode, 0) << compared.out << compared.err;
    }
}

TEST(KeptFiles, ResultsAreReadInEveryForm) {
    for (const std::string name : tables) {
        SCOPED_TRACE(name);
        const AnalysisData csv = loadResult(kept / "results" / (name + ".csv"));
        const AnalysisData json = loadResult(kept / "results" / (name + ".json"));
        EXPECT_EQ(csv.name, name);
        EXPECT_EQ(csv.kind, json.kind);
        EXPECT_NE(csv.kind, AnalysisKind::other);
        EXPECT_EQ(csv.state, AnalysisState::complete);
        expectTheSame(csv.table, json.table);
    }
    for (const std::string name : pictures) {
        SCOPED_TRACE(name);
        const AnalysisData exr = loadResult(kept / "results" / (name + ".exr"));
        EXPECT_EQ(exr.kind, AnalysisKind::image);
        EXPECT_EQ(exr.image.width(), 40);
        const auto csv = irsg::readImageFile(kept / "results" / (name + ".csv"));
        EXPECT_EQ(csv.height(), exr.image.height());
    }
}

TEST(KeptFiles, MonteCarloBesideItsProjectHasItsDrawsAndComesToTheSameNumbers) {
    const ResultFolder results(kept / "kept.smat");
    ASSERT_THAT(results.documents(), testing::ElementsAre("001-montecarlo"));
    const ResultDocument document = results.load("001-montecarlo");
    EXPECT_EQ(document.title, "1  Monte Carlo: around");
    ASSERT_NE(document.monteCarlo, nullptr);
    const MonteCarloData& run = *document.monteCarlo;
    EXPECT_EQ(run.analysis.kind, AnalysisKind::polar);
    EXPECT_EQ(run.analysis.settings.text("render.bounces"), "0");
    EXPECT_EQ(run.realisations(), 64U);
    ASSERT_EQ(run.values.size(), 16U);
    const TemporaryFolder folder;
    const Ran ran =
        smatBatch({"montecarlo", kept / "kept.smat", "--analysis", "around", "--bounces", "0",
                   "--samples", "64", "--seed", "7", "--phases", "2", "--out", folder / "now.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable now = ResultTable::load(folder / "now.csv");
    for (std::size_t place = 0; place < run.values.size(); ++place) {
        const std::size_t band = place / run.abscissae.size(), row = place % run.abscissae.size();
        SCOPED_TRACE(place);
        for (const std::string what : {"nominal", "mean", "p95"}) {
            const std::string key = run.columnKey(what, band);
            const double before = run.analysis.table.find(key)->values[row];
            ASSERT_NE(now.find(key), nullptr) << key;
            EXPECT_NEAR(now.find(key)->values[row], before, tolerance * std::abs(before)) << key;
        }
        // They are kept to the digits of a float.
        const double mean = run.analysis.table.find(run.columnKey("mean", band))->values[row];
        EXPECT_NEAR(meanOf(run.values[place]), mean, 1e-6 * mean);
    }
}

TEST(KeptFiles, TableOfAirAttenuatesAsItDid) {
    const TemporaryFolder folder;
    const Ran ran = smatBatch({"radiative", kept / "family.smatatm", "--quantity", "transmittance",
                               "--band", "4.91-4.99", "--sensor-altitude", "1500", "--altitude",
                               "1500", "--range", "2000", "--out", folder / "air.csv"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    const ResultTable table = ResultTable::load(folder / "air.csv");
    const ResultColumn* const transmittance = table.find("transmittance");
    ASSERT_NE(transmittance, nullptr);
    for (const double value : transmittance->values) {
        EXPECT_NEAR(value, std::exp(-0.2), 1e-6);
    }
}

TEST(KeptFiles, RulesBesideAModelGiveTheCodesOfBefore) {
    const Ran ran = smatBatch({"model", "codes", kept / "ruled.flt"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_THAT(ran.out, testing::HasSubstr("ruled.codes.json: 3 rules, 0 painted surfaces"));
    for (const char* const object : {"nose +1 +2 +6,2", "tail +1 +2 +5,2", "port +1 +4 +4,2"}) {
        EXPECT_THAT(ran.out, testing::ContainsRegex(object));
    }
}

TEST(KeptFiles, CommandLinesRunAsTheyStand) {
    std::istringstream lines(contentOf(kept / "commands.txt"));
    const TemporaryFolder folder;
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        std::istringstream words(line);
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) {
            const std::size_t out = word.find("OUT");
            arguments.push_back(out == 0 ? folder.path().string() + word.substr(out + 3) : word);
        }
        const Ran ran = smatBatch(arguments, kept);
        const bool isLeftOut = arguments.front() == "explain" && !irsg::areRaysBuilt();
        EXPECT_EQ(ran.exitCode, isLeftOut ? 2 : 0) << line << "\n" << ran.err;
    }
    EXPECT_GE(count, 32);
}

} // namespace
} // namespace smat::test
