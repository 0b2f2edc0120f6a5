#include <functional>
#include <random>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/signature/SignatureFile.h"

#include "Support.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// One of everything, in as few bytes as may be: each of them is damaged below.
SignatureDatabase smallDatabase() {
    SignatureDatabase database = completeDatabase();
    database.title = "small";
    database.temperatures.erase(-7);
    UserSpectrum& plume = database.spectra["plume core"];
    plume.components = {{"H2O", {{4.0, 4.5}, {20.5, 30.25}, Spectrum::Outside::zero}}};
    database.temperatures[2147483647].factors.pop_back();
    return database;
}

std::string goodBytes(const TemporaryFolder& folder) {
    const fs::path file = folder / "good.sigdb";
    saveSignatureFile(smallDatabase(), file);
    return readBytes(file);
}

/// Loads what may be damaged: the database as it was saved, or a refusal that names the file.
/// Returns whether it was refused.
bool isRefusedOrHarmless(const fs::path& file, const std::string& what) {
    static const SignatureDatabase saved = smallDatabase();
    try {
        const LoadedSignature loaded = loadSignatureFile(file);
        EXPECT_TRUE(loaded.database == saved) << what;
        return false;
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) {
            EXPECT_EQ(diagnostic.file, file.string()) << what;
            EXPECT_FALSE(diagnostic.value.empty()) << what;
            EXPECT_FALSE(diagnostic.expected.empty()) << what;
        }
        return true;
    }
}

/// Flips bits of one byte of a file for as long as it lives.
class Flip {
  public:
    Flip(const fs::path& file, std::size_t at, char good, int bits)
        : file_(file, std::ios::binary | std::ios::in | std::ios::out), at_(at), good_(good) {
        put(static_cast<char>(good ^ bits));
    }
    ~Flip() { put(good_); }

  private:
    void put(char byte) {
        file_.seekp(static_cast<std::streamoff>(at_));
        file_.put(byte).flush();
    }
    std::fstream file_;
    std::size_t at_;
    char good_;
};

/// One byte in `step`, and of each these bits. Returns how many damages were refused.
int refusedOfBytes(const TemporaryFolder& folder, std::size_t step,
                   const std::function<int(std::size_t at)>& bitsOf) {
    const std::string good = goodBytes(folder);
    const fs::path file = writeBytes(folder / "flipped.sigdb", good);
    int refused = 0;
    for (std::size_t at = 0; at < good.size(); at += step) {
        const Flip flip(file, at, good[at], bitsOf(at));
        refused += isRefusedOrHarmless(file, "byte " + std::to_string(at) + " xor " +
                                                 std::to_string(bitsOf(at)));
    }
    EXPECT_EQ(readBytes(file), good) << "reading changed the file";
    return refused;
}

TEST(SignatureFileDamage, OfOneBitOfEveryByteIsDetectedOrHarmless) {
    const TemporaryFolder folder;
    const auto bits = [](std::size_t at) { return 1 << (at * 5 % 8); };
    EXPECT_GT(refusedOfBytes(folder, 1, bits), 3000);
}

TEST(SignatureFileDamage, OfWholeBytesIsDetectedOrHarmless) {
    const TemporaryFolder folder;
    EXPECT_GT(refusedOfBytes(folder, 7, [](std::size_t) { return 0xff; }), 500);
}

TEST(SignatureFileDamage, OfEveryBitOfTheHeaderIsDetectedOrHarmless) {
    const TemporaryFolder folder;
    const std::string good = goodBytes(folder);
    const fs::path file = writeBytes(folder / "header.sigdb", good);
    for (std::size_t at = 0; at < 100; ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            const Flip flip(file, at, good[at], 1 << bit);
            isRefusedOrHarmless(file, "header byte " + std::to_string(at) + ", bit " +
                                          std::to_string(bit));
        }
    }
}

TEST(SignatureFileDamage, OfSeveralBytesIsDetectedOrHarmless) {
    const TemporaryFolder folder;
    const std::string good = goodBytes(folder);
    std::mt19937 random(20110301);
    std::uniform_int_distribution<std::size_t> anywhere(0, good.size() - 1);
    std::uniform_int_distribution<int> anything(0, 255);
    for (int trial = 0; trial < 300; ++trial) {
        std::string bytes = good;
        const std::size_t at = anywhere(random);
        const std::size_t end = std::min(bytes.size(), at + 1 + anywhere(random) % 40);
        for (std::size_t i = at; i < end; ++i) {
            bytes[i] = static_cast<char>(anything(random));
        }
        isRefusedOrHarmless(writeBytes(folder / "smeared.sigdb", bytes),
                            "bytes " + std::to_string(at) + " to " + std::to_string(end));
    }
}

TEST(SignatureFileDamage, ByTruncationAtAnyLengthIsDetected) {
    const TemporaryFolder folder;
    const std::string good = goodBytes(folder);
    const fs::path file = writeBytes(folder / "cut.sigdb", good);
    for (std::size_t length = good.size(); length-- > 0;) {
        fs::resize_file(file, length);
        ASSERT_TRUE(isRefusedOrHarmless(file, "length " + std::to_string(length))) << length;
        ASSERT_EQ(fs::file_size(file), length) << "reading changed the file";
    }
}

TEST(SignatureFileDamage, ByBytesAppendedIsDetectedOrHarmless) {
    const TemporaryFolder folder;
    const std::string good = goodBytes(folder);
    for (const std::size_t count : {1U, 100U, 1024U, 5000U}) {
        isRefusedOrHarmless(writeBytes(folder / "long.sigdb", good + std::string(count, 'x')),
                            std::to_string(count) + " bytes more");
    }
}

struct Unusable {
    const char* name;
    std::function<void(const fs::path&)> make;
    const char* value;
    const char* expected;
};
void PrintTo(const Unusable& row, std::ostream* out) {
    *out << row.name;
}

void change(const fs::path& file, const std::string& sql) {
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(sql);
}

const Unusable unusable[] = {
    {"PlainText", [](const auto& file) { writeBytes(file, "name,value\n1,2\n"); },
     "does not begin as an SQLite database", "signature database"},
    {"Folder", [](const auto& file) { fs::create_directory(file); }, "a folder",
     "signature database"},
    {"OtherSqliteDatabase",
     [](const auto& file) {
         SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
             .exec("CREATE TABLE bookmark (url TEXT)");
     },
     "application id 0", "application id 1397571924"},
    {"WrongApplicationId",
     [](const auto& file) { change(file, "PRAGMA application_id = 252006673"); },
     "application id 252006673", "application id 1397571924"},
    {"NewerVersion", [](const auto& file) { change(file, "PRAGMA user_version = 8"); },
     "schema version 8", "a newer version of this program"},
    {"VersionZero", [](const auto& file) { change(file, "PRAGMA user_version = 0"); },
     "schema version 0", "schema version 1"},
};

class UnusableFile : public testing::TestWithParam<Unusable> {};

TEST_P(UnusableFile, IsNamedOnLoadAndOnSaveAndLeftAlone) {
    const TemporaryFolder folder;
    const fs::path file = folder / "unusable.sigdb";
    GetParam().make(file);
    const std::string before = fs::is_directory(file) ? "" : readBytes(file);
    for (const bool saving : {false, true}) {
        const auto diagnostics = refusalOf([&] {
            if (saving) {
                saveSignatureFile(completeDatabase(), file);
            } else {
                loadSignatureFile(file);
            }
        });
        ASSERT_EQ(diagnostics.size(), 1U);
        EXPECT_EQ(diagnostics[0].file, file.string());
        EXPECT_THAT(diagnostics[0].value, HasSubstr(GetParam().value));
        EXPECT_THAT(diagnostics[0].expected, HasSubstr(GetParam().expected));
    }
    EXPECT_EQ(fs::is_directory(file) ? "" : readBytes(file), before);
}

INSTANTIATE_TEST_SUITE_P(SignatureFileDamage, UnusableFile, testing::ValuesIn(unusable),
                         [](const auto& row) { return row.param.name; });

TEST(SignatureFileDamage, AMissingFileIsNamed) {
    const TemporaryFolder folder;
    const auto diagnostics = refusalOf([&] { loadSignatureFile(folder / "absent.sigdb"); });
    EXPECT_EQ(diagnostics[0].file, (folder / "absent.sigdb").string());
    EXPECT_EQ(diagnostics[0].value, "no such file");
    EXPECT_FALSE(fs::exists(folder / "absent.sigdb"));
}

TEST(SignatureFileDamage, AnEmptyFileIsNoDatabaseButMayBecomeOne) {
    const TemporaryFolder folder;
    const fs::path file = writeBytes(folder / "empty.sigdb", "");
    EXPECT_EQ(refusalOf([&] { loadSignatureFile(file); })[0].value, "an empty file");
    saveSignatureFile(completeDatabase(), file);
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

TEST(SignatureFileDamage, AWriteProtectedFileIsReadButNotSavedTo) {
    const TemporaryFolder folder;
    const fs::path file = folder / "protected.sigdb";
    saveSignatureFile(completeDatabase(), file);
    const std::string before = readBytes(file);
    fs::permissions(file, fs::perms::owner_read);
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
    const auto diagnostics = refusalOf([&] { saveSignatureFile({}, file); });
    EXPECT_EQ(diagnostics[0].file, file.string());
    EXPECT_EQ(diagnostics[0].value, "a write-protected file");
    EXPECT_EQ(readBytes(file), before);
}

TEST(SignatureFileDamage, AFolderThatIsMissingIsNamedOnSave) {
    const TemporaryFolder folder;
    const fs::path file = folder / "nowhere/a.sigdb";
    const auto diagnostics = refusalOf([&] { saveSignatureFile({}, file); });
    EXPECT_EQ(diagnostics[0].file, file.string());
    EXPECT_THAT(diagnostics[0].value, HasSubstr("a folder that does not exist"));
}

TEST(SignatureFileDamage, AFileInUseByAnotherProgramIsNamed) {
    const TemporaryFolder folder;
    const fs::path file = folder / "busy.sigdb";
    saveSignatureFile(completeDatabase(), file);
    SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
    other.exec("BEGIN EXCLUSIVE");
    EXPECT_THAT(refusalOf([&] { loadSignatureFile(file); })[0].value, HasSubstr("locked"));
    EXPECT_THAT(refusalOf([&] { saveSignatureFile({}, file); })[0].value, HasSubstr("locked"));
    other.exec("ROLLBACK");
    EXPECT_TRUE(loadSignatureFile(file).database == completeDatabase());
}

struct BadRow {
    const char* name;
    const char* sql;
    const char* position;
    const char* value;
};
void PrintTo(const BadRow& row, std::ostream* out) {
    *out << row.name;
}

class BadRows : public testing::TestWithParam<BadRow> {};

TEST_P(BadRows, AreNamedWithTableOrEntry) {
    const TemporaryFolder folder;
    const fs::path file = folder / "rows.sigdb";
    change(file, std::string("PRAGMA foreign_keys = OFF; PRAGMA ignore_check_constraints = ON; ") +
                     GetParam().sql);
    const auto diagnostics = refusalOf([&] { loadSignatureFile(file, OutsideChanges::accept); });
    bool found = false;
    std::string all;
    for (const Diagnostic& diagnostic : diagnostics) {
        EXPECT_EQ(diagnostic.file, file.string());
        all += diagnostic.message() + "\n";
        found |= diagnostic.position.find(GetParam().position) != std::string::npos &&
                 diagnostic.value.find(GetParam().value) != std::string::npos;
    }
    EXPECT_TRUE(found) << all;
}

INSTANTIATE_TEST_SUITE_P(
    SignatureFileDamage, BadRows,
    testing::Values(
        BadRow{"TextForNumber", "UPDATE temperature SET base_K = 'hot' WHERE id = 0",
               "table temperature, row 2", "base_K = 'hot'"},
        BadRow{"BlobForText", "UPDATE material SET notes = x'00ff' WHERE id = 0",
               "table material, row 1", "notes"},
        BadRow{"NoEmissivity", "UPDATE material SET emissivity = NULL WHERE id = 0",
               "table material, row 1", "nothing in emissivity"},
        BadRow{"EmissivityTwice", "UPDATE material SET emissivity = 0.5 WHERE id = 3",
               "table material, row 2", "as a number and as nodes"},
        BadRow{"AxisDescends", "UPDATE material_node SET wavelength_um = 1 WHERE node = 1",
               "materials.3.emissivity, node 2", "1"},
        BadRow{"Infinity", "UPDATE material_node SET value = 9e999 WHERE node = 1",
               "materials.3.emissivity, node 2", "inf"},
        BadRow{"TableDescends",
               "UPDATE temperature_node SET x = -1 WHERE term = 'time_s' AND"
               " node = 2",
               "temperatures.0.terms.time_s, node 3", "-1 after 10"},
        BadRow{"TableWithoutNodes", "DELETE FROM temperature_node WHERE term = 'mach'",
               "temperatures.0.terms.mach", "0 nodes"},
        BadRow{"UnknownMode", "UPDATE temperature SET mode = 'magic' WHERE id = 0", "", "magic"},
        BadRow{"UnknownTerm",
               "UPDATE temperature_table SET term = 'x' WHERE term = 'mach';"
               "UPDATE temperature_node SET term = 'x' WHERE term = 'mach'",
               "table temperature_table", "'x'"},
        BadRow{"UnknownAxis",
               "UPDATE factor_table SET axis = 'x' WHERE axis = 'angle_deg';"
               "UPDATE factor_node SET axis = 'x' WHERE axis = 'angle_deg'",
               "table factor_table", "'x'"},
        BadRow{"UnknownAboutKey", "INSERT INTO about VALUES ('author', 'me')", "table about",
               "author"},
        BadRow{"OrphanNode", "INSERT INTO material_node VALUES (77, 'emissivity', 0, 1, 1)",
               "table material_node", "material"},
        BadRow{"IndexTooLarge", "UPDATE material SET id = 4294967296 WHERE id = 0",
               "table material", "id = '4294967296'"},
        BadRow{"MissingTable", "DROP TABLE factor_node", "", "no such table"},
        BadRow{"MissingColumn", "ALTER TABLE material DROP COLUMN notes", "", "no such column"}),
    [](const auto& row) { return row.param.name; });

} // namespace
} // namespace irsg
