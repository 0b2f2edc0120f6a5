// Files and command lines of before: tests/kept/README.md.
#include <cmath>
#include <map>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/image/ImageFile.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

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
        EXPECT_EQ(irsg::signatureToJson(loaded.database), contentOf(kept / text));
        EXPECT_TRUE(loaded.database == irsg::signatureFromJson(contentOf(kept / text), text));
    }
}

TEST(KeptFiles, DatabaseSavedAnewIsReadByTheProgramOfBefore) {
    // What that one asks of a file: version 1, and the hash of each entry as it was.
    const TemporaryFolder folder;
    const fs::path file = folder / "again.sigdb";
    irsg::saveSignatureFile(irsg::loadSignatureFile(kept / "box.sigdb").database, file);
    EXPECT_EQ(smatBatch({"db", "export", file, folder / "again.json"}).exitCode, 0);
    EXPECT_EQ(contentOf(folder / "again.json"), contentOf(kept / "signature.json"));
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
    EXPECT_EQ(nlohmann::json::parse(contentOf(folder / "again.smat")),
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
        EXPECT_EQ(ran.exitCode, 0) << line << "\n" << ran.err;
    }
    EXPECT_GE(count, 22);
}

} // namespace
} // namespace smat::test
