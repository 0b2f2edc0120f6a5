#include "irsg/signature/SignatureFile.h"

#include <fstream>
#include <map>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/radiometry/Errors.h"
#include "irsg/signature/EntryJson.h"
#include "irsg/signature/LintErrors.h"
#include "irsg/signature/Sha256.h"
#include "irsg/signature/SignatureRows.h"

namespace irsg {

namespace {

namespace fs = std::filesystem;

/// "SMAT" as a big-endian 32-bit number, in the header field that SQLite keeps for applications.
constexpr int applicationId = 0x534D4154;
constexpr int busyTimeout_ms = 2000;
constexpr std::string_view sqliteMagic("SQLite format 3\0", 16);

InputError refusal(const fs::path& file, std::string value, std::string expected) {
    return InputError({file.string(), "", std::move(value), std::move(expected)});
}

enum class Existing { none, empty, sqlite };

/// What lies at the path, before SQLite touches it: SQLite would take an empty file for a database.
Existing inspect(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (!fs::exists(status)) {
        return Existing::none;
    }
    if (!fs::is_regular_file(status)) {
        throw refusal(file, fs::is_directory(status) ? "a folder" : "no regular file",
                      "a signature database (.sigdb)");
    }
    std::string head(sqliteMagic.size(), '\0');
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw refusal(file, "a file that cannot be read", "a readable signature database (.sigdb)");
    }
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (stream.gcount() == 0) {
        return Existing::empty;
    }
    if (!stream || head != sqliteMagic) {
        throw refusal(file, "a file that does not begin as an SQLite database does",
                      "a signature database (.sigdb)");
    }
    return Existing::sqlite;
}

int pragma(SQLite::Database& file, const std::string& name) {
    return file.execAndGet("PRAGMA " + name).getInt();
}

/// Throws unless the open file is one of ours that this program can read.
void checkOurs(SQLite::Database& database, const fs::path& file) {
    if (const int id = pragma(database, "application_id"); id != applicationId) {
        throw refusal(file, "an SQLite database with application id " + std::to_string(id),
                      "a signature database, with application id " + std::to_string(applicationId));
    }
    const int version = pragma(database, "user_version");
    if (version < 1 || version > signatureFileVersion) {
        throw refusal(file, "schema version " + std::to_string(version),
                      "schema version " + std::to_string(signatureFileVersion) +
                          (version > signatureFileVersion
                               ? " (a newer version of this program reads the file)"
                               : ""));
    }
}

void checkIntegrity(SQLite::Database& database, const fs::path& file) {
    std::vector<Offence> offences;
    const std::string expected = "an undamaged database";
    SQLite::Statement integrity(database, "PRAGMA integrity_check");
    while (integrity.executeStep()) {
        if (const std::string line = integrity.getColumn(0).getString(); line != "ok") {
            offences.push_back({file.string(), "", line, expected});
        }
    }
    SQLite::Statement references(database, "PRAGMA foreign_key_check");
    while (references.executeStep()) {
        offences.push_back({file.string(), "table " + references.getColumn(0).getString(),
                            "a row whose " + references.getColumn(2).getString() + " is missing",
                            expected});
    }
    if (!offences.empty()) {
        throw InputError(std::move(offences));
    }
}

/// Entries that differ from their stored hash, appeared without one, or left theirs behind.
std::vector<std::string> changedEntries(const SignatureDatabase& database,
                                        std::map<std::string, std::string> hashes) {
    std::set<std::string> changed;
    for (const auto& [entry, text] : canonicalEntries(database)) {
        const auto stored = hashes.find(entry);
        if (stored == hashes.end() || stored->second != sha256(text)) {
            changed.insert(entry);
        }
        hashes.erase(entry);
    }
    for (const auto& [entry, hash] : hashes) {
        changed.insert(entry);
    }
    return {changed.begin(), changed.end()};
}

LoadedSignature load(const fs::path& file, OutsideChanges outside) {
    // Only a save that was cut off leaves a journal; rolling it back needs leave to write.
    const bool interrupted = fs::exists(file.string() + "-journal");
    SQLite::Database database(file.string(),
                              interrupted ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY,
                              busyTimeout_ms);
    database.exec("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
    const SQLite::Transaction oneState(database);
    checkOurs(database, file);
    checkIntegrity(database, file);

    LoadedSignature loaded{readRows(database, file.string()), {}};
    throwOnLintErrors(loaded.database, file.string());
    loaded.changedOutside = changedEntries(loaded.database, readHashes(database));
    if (outside == OutsideChanges::refuse && !loaded.changedOutside.empty()) {
        std::vector<Offence> offences;
        for (const std::string& entry : loaded.changedOutside) {
            offences.push_back({file.string(), entry, "content changed outside this program",
                                "the content it was saved with, or leave to accept changes"});
        }
        throw InputError(std::move(offences));
    }
    return loaded;
}

void save(const SignatureDatabase& database, const fs::path& file, Existing existing) {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                            busyTimeout_ms);
    // Small pages keep small databases small; the size of a file that exists stays as it is.
    sqlite.exec("PRAGMA page_size = 1024; PRAGMA trusted_schema = OFF; PRAGMA foreign_keys = ON");
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    if (existing == Existing::sqlite) {
        checkOurs(sqlite, file);
    }
    sqlite.exec("PRAGMA application_id = " + std::to_string(applicationId));
    sqlite.exec("PRAGMA user_version = " + std::to_string(signatureFileVersion));
    resetSchema(sqlite);
    writeRows(database, sqlite);
    transaction.commit();
}

bool isWriteProtected(const fs::path& file) {
    constexpr auto anyWrite =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    return (fs::status(file).permissions() & anyWrite) == fs::perms::none;
}

} // namespace

LoadedSignature loadSignatureFile(const fs::path& file, OutsideChanges outside) {
    switch (inspect(file)) {
    case Existing::none:
        throw refusal(file, "no such file", "a signature database (.sigdb)");
    case Existing::empty:
        throw refusal(file, "an empty file", "a signature database (.sigdb)");
    case Existing::sqlite:
        break;
    }
    try {
        return load(file, outside);
    } catch (const SQLite::Exception& error) {
        throw refusal(file, error.what(), "an undamaged signature database");
    }
}

void saveSignatureFile(const SignatureDatabase& database, const fs::path& file) {
    throwOnLintErrors(database, file.string());
    const Existing existing = inspect(file);
    if (existing != Existing::none && isWriteProtected(file)) {
        throw refusal(file, "a write-protected file", "a file that can be written");
    }
    const auto removeNew = [&] {
        std::error_code ignored;
        if (existing == Existing::none) {
            fs::remove(file, ignored);
        }
    };
    try {
        save(database, file, existing);
    } catch (const InputError&) {
        removeNew();
        throw;
    } catch (const SQLite::Exception& error) {
        removeNew();
        throw refusal(file, error.what(), "a signature database that can be written");
    }
}

} // namespace irsg
