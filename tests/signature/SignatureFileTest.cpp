#include "irsg/signature/SignatureFile.h"

#include <algorithm>
#include <cstring>
#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>

#include "Support.h"
#include "irsg/core/ProgramVersion.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(SignatureFile, BringsACompleteDatabaseBackUnchanged) {
    const TemporaryFolder folder;
    const fs::path file = folder / "complete.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const LoadedSignature loaded = loadSignatureFile(file);
    EXPECT_TRUE(loaded.database == completeDatabase());
    EXPECT_THAT(loaded.changedOutside, IsEmpty());
}

/// The names of the files in a folder, in order.
std::vector<std::string> namesIn(const fs::path& folder) {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

TEST(SignatureFile, WithAWriteAheadLogIsReadAndLeavesNothingBesideIt) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA journal_mode = WAL");
    const std::string bytes = readBytes(file);
    ASSERT_EQ(bytes.at(18), 2) << "a log";
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
    EXPECT_THAT(namesIn(folder / "."), ElementsAre("a.sigdb"));
    EXPECT_EQ(readBytes(file), bytes);

    // What a program that was killed wrote into the log counts.
    const fs::path killed = folder / "killed";
    fs::create_directory(killed);
    {
        SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
        other.exec("CREATE TABLE others (x); UPDATE written_by SET program = 'smat 99.0.0'");
        fs::copy(file, killed / "b.sigdb");
        fs::copy(folder / "a.sigdb-wal", killed / "b.sigdb-wal");
        // While the other program works on it, too.
        EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
        EXPECT_TRUE(other.tableExists("others"));
    }
    EXPECT_TRUE(loadSignatureFile(killed / "b.sigdb").database == completeDatabase());
    EXPECT_THAT(namesIn(killed), ElementsAre("b.sigdb", "b.sigdb-wal"));
    fs::resize_file(killed / "b.sigdb-wal", 0);
    EXPECT_TRUE(loadSignatureFile(killed / "b.sigdb").database == completeDatabase());
    EXPECT_THAT(namesIn(killed), ElementsAre("b.sigdb", "b.sigdb-wal"));

    // A save makes it one without.
    saveSignatureFile(completeDatabase(), file);
    EXPECT_THAT(namesIn(folder / "."), ElementsAre("a.sigdb", "killed"));
    EXPECT_EQ(readBytes(file).at(18), 1);
}

TEST(SignatureFile, WithADamagedLogIsReadAsItWasBeforeOrRefused) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA journal_mode = WAL");
    std::ofstream(folder / "a.sigdb-wal") << "no log at all";
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
    EXPECT_THAT(namesIn(folder / "."), ElementsAre("a.sigdb", "a.sigdb-wal"));
    fs::resize_file(file, 700);
    EXPECT_THROW(loadSignatureFile(file), InputError);
}

TEST(SignatureFile, NamesTheVersionThatWroteItWhichNobodyNeeds) {
    const TemporaryFolder folder;
    const fs::path file = folder / "a.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const std::string bytes = readBytes(file);
    const auto programs = [&] {
        return SQLite::Database(file.string())
            .execAndGet("SELECT group_concat(program) FROM written_by")
            .getString();
    };
    EXPECT_EQ(programs(), programWithVersion());
    // What another version wrote names it until this one saves, once.
    for (const char* sql :
         {"UPDATE written_by SET program = 'smat 99.0.0'",
          "INSERT INTO written_by VALUES ('smat 0.1.0')", "DROP TABLE written_by"}) {
        SCOPED_TRACE(sql);
        SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
        const LoadedSignature loaded = loadSignatureFile(file);
        EXPECT_TRUE(loaded.database == completeDatabase());
        saveSignatureFile(loaded.database, file, loaded.database);
        EXPECT_EQ(programs(), programWithVersion());
    }
    saveSignatureFile(completeDatabase(), folder / "b.sigdb");
    EXPECT_EQ(readBytes(folder / "b.sigdb"), bytes);
}

TEST(SignatureFile, OfAnEmptyDatabaseComesBack) {
    const TemporaryFolder folder;
    saveSignatureFile({}, folder / "empty.sigdb");
    EXPECT_TRUE(loadSignatureFile(folder / "empty.sigdb").database == SignatureDatabase{});
}

TEST(SignatureFile, KeepsEveryBitOfEveryNumber) {
    const TemporaryFolder folder;
    const double values[] = {0.1,  1.0 / 3.0,          5e-324, 1.7976931348623157e308, 0.0,
                             -1.5, 9007199254740993.0, 4.0};
    SignatureDatabase database;
    int index = 0;
    for (const double value : values) {
        database.temperatures[index++] = {
            "t", {}, {300.0, 0.0, 0.0, value, {}, {{0.0, 1.0}, {0.0, value / 1e308}}, {}, {}},
            "",  {}, ""};
    }
    saveSignatureFile(database, folder / "bits.sigdb");
    const auto again = loadSignatureFile(folder / "bits.sigdb").database.temperatures;
    index = 0;
    for (const double value : values) {
        const TemperatureTerms& terms = again.at(index++).terms;
        const double scaled = value / 1e308;
        EXPECT_EQ(std::memcmp(&terms.ambientOffset_K, &value, sizeof value), 0) << value;
        EXPECT_EQ(std::memcmp(&terms.power.y()[1], &scaled, sizeof value), 0) << value;
    }
}

TEST(SignatureFile, TakesMinusZeroForTheZeroItEquals) {
    const TemporaryFolder folder;
    SignatureDatabase database = completeDatabase();
    database.temperatures[0].terms.ambientOffset_K = -0.0;
    saveSignatureFile(database, folder / "zero.sigdb");
    EXPECT_TRUE(loadSignatureFile(folder / "zero.sigdb").database == database);
}

TEST(SignatureFile, IsReplacedAsAWholeByTheNextSave) {
    const TemporaryFolder folder;
    const fs::path file = folder / "twice.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SignatureDatabase other;
    other.title = "other";
    other.materials[8].name = "steel";
    saveSignatureFile(other, file);
    EXPECT_TRUE(loadSignatureFile(file).database == other);
    saveSignatureFile(completeDatabase(), file);
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

TEST(SignatureFile, HoldsAsMuchAsTheJsonForm) {
    const TemporaryFolder folder;
    saveSignatureFile(completeDatabase(), folder / "a.sigdb");
    const SignatureDatabase loaded = loadSignatureFile(folder / "a.sigdb").database;
    EXPECT_EQ(signatureToJson(loaded), signatureToJson(completeDatabase()));
}

TEST(SignatureFile, IsAnSqliteDatabaseThatOthersRead) {
    const TemporaryFolder folder;
    saveSignatureFile(completeDatabase(), folder / "a.sigdb");
    SQLite::Database file((folder / "a.sigdb").string());
    EXPECT_EQ(file.execAndGet("PRAGMA application_id").getInt(), 0x534D4154);
    EXPECT_EQ(file.execAndGet("PRAGMA user_version").getInt(), 1);
    EXPECT_EQ(file.execAndGet("SELECT name FROM material WHERE id = 3").getString(), "glass");
    EXPECT_EQ(file.execAndGet("SELECT emissivity FROM material WHERE id = 0").getDouble(), 0.9);
    EXPECT_EQ(file.execAndGet("SELECT value FROM material_node WHERE material = 3 AND"
                              " property = 'emissivity' AND wavelength_um = 4.5")
                  .getDouble(),
              0.2);
    EXPECT_EQ(file.execAndGet("SELECT count(*) FROM user_spectrum_node").getInt(), 82);
    EXPECT_EQ(file.execAndGet("SELECT length(sha256) FROM content_hash WHERE entry = 'materials.3'")
                  .getInt(),
              64);
}

struct OutsideChange {
    const char* name;
    const char* sql;
    const char* entry;
};
void PrintTo(const OutsideChange& row, std::ostream* out) {
    *out << row.name;
}

class ChangedOutside : public testing::TestWithParam<OutsideChange> {};

TEST_P(ChangedOutside, IsRefusedOrAcceptedButNeverSilent) {
    const TemporaryFolder folder;
    const fs::path file = folder / "changed.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec(std::string("PRAGMA foreign_keys = ON; ") + GetParam().sql);

    const auto diagnostics = refusalOf([&] { loadSignatureFile(file); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics[0].file, file.string());
    EXPECT_EQ(diagnostics[0].position, GetParam().entry);
    EXPECT_THAT(diagnostics[0].value, HasSubstr("changed outside"));

    const LoadedSignature accepted = loadSignatureFile(file, OutsideChanges::accept);
    EXPECT_THAT(accepted.changedOutside, ElementsAre(GetParam().entry));
    EXPECT_FALSE(accepted.database == completeDatabase());

    // Saved again by this program, the change is its own.
    saveSignatureFile(accepted.database, file);
    EXPECT_TRUE(loadSignatureFile(file).database == accepted.database);
}

INSTANTIATE_TEST_SUITE_P(
    SignatureFile, ChangedOutside,
    testing::Values(
        OutsideChange{"Emissivity", "UPDATE material SET emissivity = 0.91 WHERE id = 0",
                      "materials.0"},
        OutsideChange{"LastBit",
                      "UPDATE material SET emissivity = 0.90000000000000013 WHERE id = 0",
                      "materials.0"},
        OutsideChange{"Node",
                      "UPDATE material_node SET value = 0.15 WHERE node = 0 AND"
                      " property = 'emissivity'",
                      "materials.3"},
        OutsideChange{"Notes", "UPDATE temperature SET notes = 'x' WHERE id = -7",
                      "temperatures.-7"},
        OutsideChange{"Title", "UPDATE about SET value = 'x' WHERE key = 'title'", "title"},
        OutsideChange{"Loop", "UPDATE temperature_table SET loop = 0 WHERE term = 'time_s'",
                      "temperatures.0"},
        OutsideChange{"Factor", "UPDATE factor SET constant = 0.2 WHERE position = 0",
                      "temperatures.2147483647"},
        OutsideChange{"Radiance",
                      "UPDATE user_spectrum_node SET radiance_W_m2_sr_um = 1 WHERE"
                      " node = 3 AND position = 1",
                      "spectra.plume core"},
        OutsideChange{"EntryAdded", "INSERT INTO material VALUES (9, 'new', 0.5, 0, 0, '')",
                      "materials.9"},
        OutsideChange{"EntryRemoved", "DELETE FROM material WHERE id = 3", "materials.3"},
        OutsideChange{"IndexMoved", "UPDATE temperature SET name = 'cold' WHERE id = -7",
                      "temperatures.-7"}),
    [](const auto& row) { return row.param.name; });

TEST(SignatureFile, WithWrongPhysicsFromOutsideIsRefusedEvenWhenChangesAreAccepted) {
    const TemporaryFolder folder;
    const fs::path file = folder / "wrong.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE)
        .exec("UPDATE material SET emissivity = 1.5 WHERE id = 0");
    const auto diagnostics = refusalOf([&] { loadSignatureFile(file, OutsideChanges::accept); });
    ASSERT_EQ(diagnostics.size(), 1U);
    EXPECT_EQ(diagnostics[0].position, "materials.0.emissivity");
    EXPECT_EQ(diagnostics[0].value, "1.5");
}

TEST(SignatureFile, RefusesToSaveWhatIsPhysicallyWrongAndLeavesTheFileAlone) {
    const TemporaryFolder folder;
    const fs::path file = folder / "kept.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const std::string before = readBytes(file);
    SignatureDatabase wrong = completeDatabase();
    wrong.materials[0].nAngleFactor = -1.0;
    const auto diagnostics = refusalOf([&] { saveSignatureFile(wrong, file); });
    EXPECT_EQ(diagnostics[0].position, "materials.0.nAngleFactor");
    wrong = completeDatabase();
    wrong.materials[0].notes = "\xff";
    EXPECT_THROW(saveSignatureFile(wrong, file), InputError);
    EXPECT_EQ(readBytes(file), before);
    EXPECT_THROW(saveSignatureFile(wrong, folder / "new.sigdb"), InputError);
    EXPECT_FALSE(fs::exists(folder / "new.sigdb"));
}

TEST(SignatureFile, RollsASaveBackThatWasCutOff) {
    // A save that spills to the file before it commits, as after a power cut: both the file and its
    // journal are taken away in the middle.
    const TemporaryFolder folder;
    const fs::path file = folder / "cut.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const fs::path victim = folder / "victim.sigdb";
    {
        SQLite::Database half(file.string(), SQLite::OPEN_READWRITE);
        half.exec("PRAGMA cache_size = 1; BEGIN IMMEDIATE; DELETE FROM user_spectrum_node;"
                  "UPDATE material SET name = hex(zeroblob(20000));"
                  "UPDATE temperature SET notes = hex(zeroblob(20000))");
        fs::copy_file(file, victim);
        fs::copy_file(file.string() + "-journal", victim.string() + "-journal");
        half.exec("ROLLBACK");
    }
    ASSERT_NE(readBytes(victim), readBytes(file)) << "the half save did not reach the file";
    EXPECT_TRUE(loadSignatureFile(victim).database == completeDatabase());
}

} // namespace
} // namespace irsg
