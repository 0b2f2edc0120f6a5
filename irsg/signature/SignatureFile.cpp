#include "irsg/signature/SignatureFile.h"

#include <map>
#include <memory>
#include <set>
#include <string_view>

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/ScratchFolder.h"
#include "irsg/signature/EntryFields.h"
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
    if (!fs::exists(status))
        return Existing::none;
    if (!fs::is_regular_file(status)) {
        throw refusal(file, fs::is_directory(status) ? "a folder" : "no regular file",
                      "a signature database (.sigdb)");
    }
    const std::string head = readFileBeginning(file, sqliteMagic.size());
    if (head.empty())
        return Existing::empty;
    if (head != sqliteMagic) {
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
    if (version < 1 || version > newestFormatVersion()) {
        throw refusal(file, "schema version " + std::to_string(version),
                      "schema version " + signatureVersionsExpected() +
                          (version > newestFormatVersion()
                               ? " (a newer version of this program reads the file)"
                               : ""));
    }
}

void checkIntegrity(SQLite::Database& database, const fs::path& file) {
    std::vector<Diagnostic> diagnostics;
    const std::string expected = "an undamaged database";
    SQLite::Statement integrity(database, "PRAGMA integrity_check");
    while (integrity.executeStep())
        if (const std::string line = integrity.getColumn(0).getString(); line != "ok")
            diagnostics.push_back({file.string(), "", line, expected});
    SQLite::Statement references(database, "PRAGMA foreign_key_check");
    while (references.executeStep()) {
        diagnostics.push_back({file.string(), "table " + references.getColumn(0).getString(),
                               "a row whose " + references.getColumn(2).getString() + " is missing",
                               expected});
    }
    if (!diagnostics.empty())
        throw InputError(std::move(diagnostics));
}

/// Entries that differ from their stored hash, appeared without one, or left theirs behind.
std::vector<std::string> changedEntries(const SignatureDatabase& database,
                                        std::map<std::string, std::string> hashes) {
    std::set<std::string> changed;
    for (const auto& [entry, text] : canonicalEntries(database)) {
        const auto stored = hashes.find(entry);
        if (stored == hashes.end() || stored->second != sha256(text))
            changed.insert(entry);
        hashes.erase(entry);
    }
    for (const auto& [entry, hash] : hashes)
        changed.insert(entry);
    return {changed.begin(), changed.end()};
}

/// What SQLite says, in words that name what to do about it.
InputError refusal(const fs::path& file, const SQLite::Exception& error, bool saving) {
    constexpr const char* unchanged = "; the old file is unchanged";
    switch (error.getErrorCode()) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return refusal(file, "a database that another program has locked",
                       "a file that no other program is working on: try again, or close it there");
    case SQLITE_FULL:
        return refusal(file, "a full disk", std::string("room to save the database") + unchanged);
    case SQLITE_IOERR:
        return refusal(file,
                       std::string("a file that cannot be read or written (") + error.what() + ")",
                       saving ? std::string("a disk with room, that works") + unchanged
                              : "a readable signature database (.sigdb)");
    case SQLITE_READONLY:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
        return refusal(file,
                       saving ? "a file or folder that cannot be written"
                              : "a file that cannot be opened, or whose interrupted save cannot be "
                                "undone in a folder that is read-only",
                       saving ? "a file that may be written, in a folder that may be written"
                              : "a readable signature database (.sigdb)");
    default:
        return refusal(file, error.what(),
                       saving ? "a signature database that can be written"
                              : "an undamaged signature database");
    }
}

SignatureDatabase readContent(SQLite::Database& database, const fs::path& file) {
    database.exec("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
    checkOurs(database, file);
    checkIntegrity(database, file);
    return readRows(database, pragma(database, "user_version"), file.string());
}

bool wasInterrupted(const fs::path& file) {
    return fs::exists(file.string() + "-journal");
}

/// `file` is what messages call it.
LoadedSignature load(SQLite::Database& database, const fs::path& file, OutsideChanges outside,
                     LintErrors errors) {
    const SQLite::Transaction oneState(database);
    LoadedSignature loaded{readContent(database, file), {}};
    if (errors == LintErrors::refuse)
        throwOnLintErrors(loaded.database, file.string());
    loaded.changedOutside = changedEntries(loaded.database, readHashes(database));
    if (outside == OutsideChanges::refuse && !loaded.changedOutside.empty()) {
        std::vector<Diagnostic> diagnostics;
        for (const std::string& entry : loaded.changedOutside) {
            diagnostics.push_back({file.string(), entry, "content changed outside this program",
                                   "the content it was saved with, or leave to accept changes"});
        }
        throw InputError(std::move(diagnostics));
    }
    return loaded;
}

LoadedSignature load(const fs::path& file, OutsideChanges outside, LintErrors errors, int mode) {
    SQLite::Database database(file.string(), mode, busyTimeout_ms);
    return load(database, file, outside, errors);
}

fs::path besides(const fs::path& file, const char* ending) {
    return file.string() + ending;
}

bool hasContent(const fs::path& file) {
    std::error_code absent;
    const std::uintmax_t size_B = fs::file_size(file, absent);
    return !absent && size_B > 0;
}

/// Versions of the file format to write and to read, in its header: 1 with a journal, 2 with a
/// write-ahead log.
constexpr std::size_t formatVersions = 18;
constexpr char withLog = 2, withJournal = 1;

bool hasLog(const fs::path& file) {
    const std::string head = readFileBeginning(file, formatVersions + 2);
    return head.size() == formatVersions + 2 && head.back() == withLog;
}

/// A database with a write-ahead log. SQLite would leave files beside it that it makes for reading:
/// it is read from memory, or, where a program that was killed left its log, from a copy.
LoadedSignature loadWithLog(const fs::path& file, OutsideChanges outside, LintErrors errors) {
    if (hasContent(besides(file, "-shm"))) // another program has it open
        return load(file, outside, errors, SQLite::OPEN_READONLY);
    if (hasContent(besides(file, "-wal"))) {
        const ScratchFolder folder("a copy of " + file.filename().string());
        const fs::path copy = folder / "copy.sigdb";
        writeFileDurably(copy, readFile(file));
        writeFileDurably(besides(copy, "-wal"), readFile(besides(file, "-wal")));
        SQLite::Database database(copy.string(), SQLite::OPEN_READWRITE, busyTimeout_ms);
        return load(database, file, outside, errors);
    }
    std::string bytes = readFile(file);
    bytes.at(formatVersions) = bytes.at(formatVersions + 1) = withJournal;
    SQLite::Database database(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    const int failure = sqlite3_deserialize(database.getHandle(), "main",
                                            reinterpret_cast<unsigned char*>(bytes.data()), size,
                                            size, SQLITE_DESERIALIZE_READONLY);
    if (failure != SQLITE_OK)
        throw SQLite::Exception(database.getHandle(), failure);
    return load(database, file, outside, errors);
}

/// The bytes of a database as it stands in a connection.
class Serialized {
  public:
    explicit Serialized(SQLite::Database& sqlite)
        : bytes_(sqlite3_serialize(sqlite.getHandle(), "main", &size_, 0), sqlite3_free) {
        if (!bytes_)
            throw SQLite::Exception("no memory for the file", SQLITE_NOMEM);
    }
    std::string_view view() const {
        return {reinterpret_cast<const char*>(bytes_.get()), static_cast<std::size_t>(size_)};
    }
    /// Hands them to an empty connection.
    void openIn(SQLite::Database& sqlite) && {
        constexpr unsigned keeps = SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE;
        const int failure =
            sqlite3_deserialize(sqlite.getHandle(), "main", bytes_.release(), size_, size_, keeps);
        if (failure != SQLITE_OK)
            throw SQLite::Exception(sqlite.getHandle(), failure);
    }

  private:
    sqlite3_int64 size_ = 0;
    std::unique_ptr<unsigned char, void (*)(void*)> bytes_;
};

void write(const SignatureDatabase& database, SQLite::Database& sqlite) {
    sqlite.exec("PRAGMA foreign_keys = ON");
    SQLite::Transaction transaction(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    sqlite.exec("PRAGMA application_id = " + std::to_string(applicationId));
    const int version = formatVersionOf(database);
    sqlite.exec("PRAGMA user_version = " + std::to_string(version));
    resetSchema(sqlite, version);
    writeRows(database, sqlite, version);
    transaction.commit();
}

/// Whether the file that was opened still has its name.
bool hasMoved(SQLite::Database& sqlite) {
    int moved = 0;
    sqlite3_file_control(sqlite.getHandle(), "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    return moved != 0;
}

/// Puts the new state in the place of a file that is there, while other writers are locked out.
/// What others keep in it besides (tables of their own) stays. False where the file was replaced
/// while its lock was waited for.
bool replaceLocked(const SignatureDatabase& database, const fs::path& file,
                   const SignatureDatabase* opened) {
    SQLite::Database sqlite(file.string(), SQLite::OPEN_READWRITE, busyTimeout_ms);
    // What lies in a log beside the file comes into it.
    sqlite.exec("PRAGMA trusted_schema = OFF; PRAGMA journal_mode = DELETE");
    const SQLite::Transaction locked(sqlite, SQLite::TransactionBehavior::IMMEDIATE);
    if (sqlite3_db_readonly(sqlite.getHandle(), "main") == 1)
        throw SQLite::Exception("a file that is not this user's to write", SQLITE_READONLY);
    if (hasMoved(sqlite))
        return false;
    checkOurs(sqlite, file);
    if (opened != nullptr && readContent(sqlite, file) != *opened) {
        throw refusal(file, "another content than was opened here",
                      "the content that was opened: another program or window saved the file in "
                      "the meantime; save under another name, or open it again");
    }
    SQLite::Database changed(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    Serialized(sqlite).openIn(changed);
    write(database, changed);
    FileReplacement replacement(file, FileReplacement::Input::allow);
    replacement.write(Serialized(changed).view());
    replacement.commit();
    // The lock was ours, so that no save is under way that it could belong to.
    std::error_code absent;
    fs::remove(file.string() + "-journal", absent);
    return true;
}

void saveOver(const SignatureDatabase& database, const fs::path& file,
              const SignatureDatabase* opened) {
    constexpr int mostTries = 20;
    for (int i = 0; i < mostTries; ++i)
        if (replaceLocked(database, file, opened))
            return;
    throw SQLite::Exception("others save it all the time", SQLITE_BUSY);
}

/// The bytes of a new file. Small pages keep small databases small.
std::string bytesOf(const SignatureDatabase& database) {
    SQLite::Database sqlite(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    sqlite.exec("PRAGMA page_size = 1024");
    write(database, sqlite);
    return std::string(Serialized(sqlite).view());
}

/// A new file comes whole: made beside its place and then put there.
void saveNew(const SignatureDatabase& database, const fs::path& file,
             FileReplacement::Existing existing) {
    FileReplacement replacement(file);
    replacement.write(bytesOf(database));
    replacement.commit(existing);
}

bool isWriteProtected(const fs::path& file) {
    constexpr auto anyWrite =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    return (fs::status(file).permissions() & anyWrite) == fs::perms::none;
}

void save(const SignatureDatabase& database, const fs::path& file,
          const SignatureDatabase* opened) {
    throwOnLintErrors(database, file.string());
    const Existing existing = inspect(file);
    if (existing != Existing::none && isWriteProtected(file))
        throw refusal(file, "a write-protected file", "a file that can be written");
    try {
        switch (existing) {
        case Existing::none:
            saveNew(database, file, FileReplacement::Existing::refuse);
            break;
        case Existing::empty:
            saveNew(database, file, FileReplacement::Existing::replace);
            break;
        case Existing::sqlite:
            saveOver(database, file, opened);
            break;
        }
    } catch (const SQLite::Exception& error) {
        throw refusal(file, error, true);
    }
}

} // namespace

std::string signatureVersionsExpected() {
    const int newest = newestFormatVersion();
    return newest == 1 ? "1" : "1 to " + std::to_string(newest);
}

LoadedSignature loadSignatureFile(const fs::path& file, OutsideChanges outside, LintErrors errors) {
    switch (inspect(file)) {
    case Existing::none:
        throw refusal(file, "no such file", "a signature database (.sigdb)");
    case Existing::empty:
        throw refusal(file, "an empty file", "a signature database (.sigdb)");
    case Existing::sqlite:
        break;
    }
    try {
        if (hasLog(file))
            return loadWithLog(file, outside, errors);
        // Only a save that was cut off leaves a journal; undoing it needs leave to write.
        if (!wasInterrupted(file)) {
            try {
                return load(file, outside, errors, SQLite::OPEN_READONLY);
            } catch (const SQLite::Exception&) {
                // It may have been cut off between the two lines.
                if (!wasInterrupted(file))
                    throw;
            }
        }
        return load(file, outside, errors, SQLite::OPEN_READWRITE);
    } catch (const SQLite::Exception& error) {
        throw refusal(file, error, false);
    }
}

void saveSignatureFile(const SignatureDatabase& database, const fs::path& file) {
    save(database, file, nullptr);
}

void saveSignatureFile(const SignatureDatabase& database, const fs::path& file,
                       const SignatureDatabase& opened) {
    save(database, file, &opened);
}

void createSignatureFile(const SignatureDatabase& database, const fs::path& file) {
    throwOnLintErrors(database, file.string());
    try {
        saveNew(database, file, FileReplacement::Existing::refuse);
    } catch (const SQLite::Exception& error) {
        throw refusal(file, error, true);
    }
}

} // namespace irsg
