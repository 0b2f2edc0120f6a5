#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/signature/EntryFields.h"
#include "irsg/signature/ReflectanceCsv.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A copy of a sample's database, changed.
template <typename Change>
std::filesystem::path changedSample(const TemporaryFolder& folder, const std::string& from,
                                    Change change) {
    irsg::SignatureDatabase database = irsg::loadSignatureFile(sample(from)).database;
    change(database);
    const std::filesystem::path file = folder / "changed.sigdb";
    irsg::saveSignatureFile(database, file);
    return file;
}

TEST(SmatBatchLint, FindsNothingInTheSamplesWithTheirModelsAndProjects) {
    for (const std::string name :
         {"sphere", "chessboard", "ship", "turboprop4", "box", "heron", "corvette", "tern"}) {
        const std::filesystem::path folder = sample(name);
        std::vector<std::string> arguments{"db", "lint", folder / (name + ".sigdb"), "--project",
                                           folder / (name + ".smat")};
        // One database may serve several models, each with codes of its own.
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            if (file.path().extension() == ".flt") {
                arguments.insert(arguments.end(), {"--model", file.path().string()});
            }
        }
        const Ran ran = smatBatch(arguments);
        EXPECT_EQ(ran.exitCode, 0) << ran.out << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("nothing to find fault with"));
    }
}

TEST(SmatBatchLint, WarnsWithCodeOneAndRepairsIntoAnotherFile) {
    const TemporaryFolder folder;
    const auto file = changedSample(folder, "ship/ship.sigdb", [](auto& database) {
        database.temperatures.at(11).terms = {};
        database.temperatures.at(11).terms.base_K = 27.0;
        database.temperatures.at(11).terms.ambientFactor = 0.0;
    });
    const std::string before = contentOf(file);
    const Ran lint = smatBatch({"db", "lint", file});
    EXPECT_EQ(lint.exitCode, 1) << lint.out << lint.err;
    EXPECT_THAT(lint.out, HasSubstr("warning: temperatures."));
    EXPECT_THAT(lint.out, HasSubstr("Celsius"));

    const Ran repaired = smatBatch({"db", "lint", file, "--repair", "--out", folder / "b.sigdb"});
    EXPECT_EQ(repaired.exitCode, 0) << repaired.out << repaired.err;
    EXPECT_THAT(repaired.out, HasSubstr("repaired: temperatures."));
    EXPECT_THAT(repaired.out, HasSubstr("1 repaired, 0 left"));
    EXPECT_EQ(smatBatch({"db", "lint", folder / "b.sigdb"}).exitCode, 0);
    EXPECT_EQ(contentOf(file), before);
}

TEST(SmatBatchLint, RepairsErrorsThatKeepAJsonFileFromBeingOpened) {
    const TemporaryFolder folder;
    write(folder / "a.json", R"({"format": "smat-signature", "version": 1, "temperatures": {},
        "materials": {"1": {"name": "paint", "emissivity": 92}}})");
    EXPECT_EQ(smatBatch({"db", "import", folder / "a.json", folder / "a.sigdb"}).exitCode, 2);
    const Ran lint = smatBatch({"db", "lint", folder / "a.json", "--json"});
    EXPECT_EQ(lint.exitCode, 2) << lint.err;
    const auto finding = nlohmann::json::parse(lint.out)["findings"][0];
    EXPECT_EQ(finding["severity"], "error");
    EXPECT_EQ(finding["entry"], "materials.1");
    EXPECT_EQ(finding["repairable"], true);

    const Ran repaired = smatBatch(
        {"db", "lint", folder / "a.json", "--repair", "--out", folder / "b.json", "--json"});
    EXPECT_EQ(repaired.exitCode, 0) << repaired.out << repaired.err;
    EXPECT_EQ(nlohmann::json::parse(repaired.out)["repaired"].size(), 1u);
    EXPECT_THAT(contentOf(folder / "b.json"), HasSubstr("\"emissivity\": 0.92"));
}

TEST(SmatBatchLint, WritesNothingThatCouldNotBeOpened) {
    const TemporaryFolder folder;
    write(folder / "a.json", R"({"format": "smat-signature", "version": 1, "temperatures": {},
        "materials": {"1": {"name": "paint", "emissivity": 1.3}}})");
    const Ran ran =
        smatBatch({"db", "lint", folder / "a.json", "--repair", "--out", folder / "b.sigdb"});
    EXPECT_EQ(ran.exitCode, 2);
    EXPECT_THAT(ran.out, HasSubstr("not written"));
    EXPECT_FALSE(std::filesystem::exists(folder / "b.sigdb"));
}

TEST(SmatBatchLint, LooksAtTheStatesAndBandsOfAProject) {
    const TemporaryFolder folder;
    const auto file = changedSample(folder, "ship/ship.sigdb", [](auto& database) {
        // Right at time 0, when analyses over the first hours are not.
        database.temperatures.at(11).terms.time = irsg::LookupTable({0, 3600}, {0, 9000});
    });
    write(folder / "p.smat",
          R"({"version": 1, "models": [{"file": ")" + sample("ship/ship.flt").string() +
              R"(", "database": "changed.sigdb"}], "analyses": {"hour": {"kind": "time",
              "time": {"from": 0, "to": 7200, "step": 1800}, "sensor": {"band": "20-60"}}}})");
    const Ran ran = smatBatch({"db", "lint", file, "--project", folder / "p.smat"});
    EXPECT_EQ(ran.exitCode, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("at time 3600 s, power 0, Mach 0"));
    EXPECT_THAT(ran.out, HasSubstr("(hour)"));
    EXPECT_THAT(ran.out,
                HasSubstr("temperatures.11.terms.time_s: found an end value held in 2 of 5"));
    EXPECT_THAT(ran.out, HasSubstr("nodes from 20 to 60 um"));
}

TEST(SmatBatchCopy, BringsEntriesWithTheirSpectraAndRenumbers) {
    const TemporaryFolder folder;
    std::filesystem::copy(sample("sphere/sphere.sigdb"), folder / "to.sigdb");
    const std::string from = sample("turboprop4/turboprop4.sigdb");
    const Ran refused = smatBatch(
        {"db", "copy", from, folder / "to.sigdb", "--temperatures", "6,1", "--materials", "1"});
    EXPECT_EQ(refused.exitCode, 2) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("materials.1"));

    const Ran ran = smatBatch({"db", "copy", from, folder / "to.sigdb", "--temperatures", "6,1",
                               "--materials", "1", "--renumber", "--json"});
    EXPECT_EQ(ran.exitCode, 0) << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json["spectra"][0]["from"], "plume core");
    const irsg::SignatureDatabase made = irsg::loadSignatureFile(folder / "to.sigdb").database;
    const irsg::SignatureDatabase source = irsg::loadSignatureFile(from).database;
    EXPECT_TRUE(made.materials.at(json["materials"][0]["to"]) == source.materials.at(1));
    EXPECT_TRUE(made.temperatures.at(6) == source.temperatures.at(6));
    EXPECT_TRUE(made.spectra.at("plume core") == source.spectra.at("plume core"));
}

TEST(SmatBatchExport, WritesASpectrumAndAMaterialThatCanBeImported) {
    const TemporaryFolder folder;
    const std::string from = sample("ship/ship.sigdb");
    EXPECT_EQ(
        smatBatch({"db", "export", from, folder / "s.csv", "--spectrum", "funnel plume"}).exitCode,
        0);
    EXPECT_EQ(smatBatch({"db", "export", from, folder / "m.csv", "--material", "5"}).exitCode, 0);
    EXPECT_EQ(smatBatch({"db", "export", from, "--material", "5"}).exitCode, 2);
    EXPECT_THAT(smatBatch({"db", "export", "--help"}).out, HasSubstr("CSV needs one"));
    EXPECT_EQ(smatBatch({"db", "create", folder / "new.sigdb"}).exitCode, 0);
    EXPECT_EQ(smatBatch({"db", "import", folder / "s.csv", folder / "new.sigdb"}).exitCode, 0);
    const Ran material = smatBatch({"db", "import", folder / "m.csv", folder / "new.sigdb", "--as",
                                    "material", "--material", "5", "--name", "gas"});
    EXPECT_EQ(material.exitCode, 0) << material.err;
    const irsg::SignatureDatabase made = irsg::loadSignatureFile(folder / "new.sigdb").database;
    const irsg::SignatureDatabase source = irsg::loadSignatureFile(from).database;
    EXPECT_EQ(made.materials.at(5).name, "gas");
    EXPECT_TRUE(made.materials.at(5).transmissivity == source.materials.at(5).transmissivity);
    EXPECT_TRUE(made.spectra.at("s").components == source.spectra.at("funnel plume").components);
    EXPECT_EQ(made.spectra.at("s").referenceDistance_m,
              source.spectra.at("funnel plume").referenceDistance_m);
}

TEST(SmatBatchImport, TakesIndexAndTablesOfReflectanceAndGivesTheseBack) {
    const TemporaryFolder folder;
    const std::string file = folder / "new.sigdb";
    EXPECT_EQ(smatBatch({"db", "create", file}).exitCode, 0);
    write(folder / "index.csv", "wl,n\n3,2\n5,3\n\nwl,k\n3,20\n5,30\n");
    write(folder / "table.csv", "incidence_deg,3,5\n0,0.2,0.4\n90,1,1\n");
    EXPECT_EQ(smatBatch({"db", "import", folder / "index.csv", file, "--as", "material",
                         "--material", "3"})
                  .exitCode,
              0);
    EXPECT_EQ(smatBatch({"db", "import", folder / "table.csv", file, "--as", "reflectance",
                         "--material", "4"})
                  .exitCode,
              0);
    const irsg::SignatureDatabase made = irsg::loadSignatureFile(file).database;
    EXPECT_EQ(made.materials.at(3).extinction.at(4.0), 25.0);
    EXPECT_EQ(made.materials.at(4).surfaceModel, "tabulated");
    EXPECT_EQ(smatBatch({"db", "export", file, folder / "back.csv", "--reflectance", "4"}).exitCode,
              0);
    EXPECT_TRUE(irsg::readReflectanceTable(folder / "back.csv") ==
                made.materials.at(4).reflectanceTable);
    const Ran none = smatBatch({"db", "export", file, folder / "none.csv", "--reflectance", "3"});
    EXPECT_EQ(none.exitCode, 2);
    EXPECT_THAT(none.err, testing::HasSubstr("reflectanceTable"));
}

TEST(SmatBatchImport, WarnsOfUnitsThatAreNotLikely) {
    const TemporaryFolder folder;
    EXPECT_EQ(smatBatch({"db", "create", folder / "a.sigdb"}).exitCode, 0);
    write(folder / "s.csv", "# unit: W m-2 sr-1 um-1\num,CO2\n4,0.00001\n5,0.00002\n");
    const Ran ran = smatBatch({"db", "import", folder / "s.csv", folder / "a.sigdb"});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.err, HasSubstr("warning: "));
    EXPECT_THAT(ran.err, HasSubstr("brightness temperature"));
    // It is said once, not with every later import.
    write(folder / "t.csv", "# unit: W m-2 sr-1 um-1\num,CO2\n4,10\n5,20\n");
    EXPECT_THAT(smatBatch({"db", "import", folder / "t.csv", folder / "a.sigdb"}).err,
                Not(HasSubstr("warning")));
}

TEST(SmatBatchInfo, TellsEntriesApart) {
    const Ran ran = smatBatch({"db", "info", sample("turboprop4/turboprop4.sigdb")});
    EXPECT_EQ(ran.exitCode, 0);
    EXPECT_THAT(ran.out, HasSubstr("K at rest"));
    EXPECT_THAT(ran.out, HasSubstr("spectrum plume core"));
    EXPECT_THAT(ran.out, HasSubstr("table power"));
    EXPECT_THAT(ran.out, HasSubstr("reference distance 100 m"));
}

/// Fields of these that the entry, as it is told in JSON, does not name by their columns.
template <typename Entry>
std::vector<std::string> untold(const nlohmann::json& told,
                                std::span<const irsg::EntryField<Entry>> fields) {
    std::vector<std::string> missing;
    for (const irsg::EntryField<Entry>& field : fields) {
        // What makes a gas of a material is told of a gas alone.
        const bool isValue = std::string_view(field.page) != "gas" &&
                             (field.template as<std::string>() || field.template as<double>() ||
                              field.template as<irsg::Spectrum>());
        if (isValue && !told.contains(field.column)) {
            missing.emplace_back(field.column);
        }
    }
    return missing;
}

TEST(SmatBatchInfo, TellsEveryTextNumberAndSpectrumOfTheTableOfFields) {
    const nlohmann::json info = nlohmann::json::parse(
        smatBatch({"db", "info", sample("turboprop4/turboprop4.sigdb"), "--json"}).out);
    bool usesSpectrum = false;
    for (const auto& entry : info["temperatures"]) {
        EXPECT_THAT(untold(entry, irsg::temperatureFields()),
                    testing::ElementsAre("user_spectrum"));
        EXPECT_NE(entry.contains("spectrum"), entry.contains("at_rest_K"));
        usesSpectrum = usesSpectrum || entry.contains("spectrum");
    }
    EXPECT_TRUE(usesSpectrum);
    for (const auto& material : info["materials"]) {
        EXPECT_THAT(untold(material, irsg::materialFields()), testing::IsEmpty());
    }
    ASSERT_FALSE(info["spectra"].empty());
    for (const auto& spectrum : info["spectra"]) {
        EXPECT_THAT(untold(spectrum, irsg::spectrumFields()), testing::IsEmpty());
    }
}

} // namespace
} // namespace smat::test
