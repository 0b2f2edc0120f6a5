#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// "1", or "1 to 2": what the version of a file may be.
std::string signatureVersionsExpected();

/// The `.sigdb` file: SQLite with an application id, a schema version in user_version, foreign keys
/// on, put in place whole at each save; any SQLite tool opens it. A hash of the canonical content
/// of each entry tells what was changed outside this program. Each file has the least version that
/// holds what it says (formatVersionOf), so that what uses nothing new is read by programs of
/// before.
struct LoadedSignature {
    SignatureDatabase database;
    /// Entries whose content no longer matches its stored hash: "materials.3".
    std::vector<std::string> changedOutside;
};

enum class OutsideChanges { refuse, accept };
/// Whether a database with lint errors is given out, to be shown and repaired.
enum class LintErrors { refuse, accept };

/// Throws InputError for a file that is missing, not a database of ours, damaged (integrity_check),
/// of a newer version, locked by another program, or, with `refuse`, physically wrong (lint errors)
/// or changed outside.
LoadedSignature loadSignatureFile(const std::filesystem::path& file,
                                  OutsideChanges outside = OutsideChanges::refuse,
                                  LintErrors errors = LintErrors::refuse);

/// Puts the new state in place of the old in one step, with what others keep in the file, while
/// other writers are locked out: `kill -9` at any moment leaves the old or the new state and no
/// other file. Throws InputError for a database that could not be loaded again (lint errors), for a
/// full disk, a file or folder that cannot be written, one that another program has locked, that is
/// write-protected, not ours or of a newer version; the file is then as it was.
void saveSignatureFile(const SignatureDatabase& database, const std::filesystem::path& file);

/// The same for a file that was opened or saved before: only while it still holds `opened` (or is
/// gone), so that what another window saved in the meantime is never lost. Else InputError, with
/// "another content than was opened here" as the value.
void saveSignatureFile(const SignatureDatabase& database, const std::filesystem::path& file,
                       const SignatureDatabase& opened);

/// Makes a new file. Throws InputError where one is there already.
void createSignatureFile(const SignatureDatabase& database, const std::filesystem::path& file);

/// Sorted, complete JSON for review and version control; equal databases give equal text. Throws
/// InputError for a database with lint errors.
std::string signatureToJson(const SignatureDatabase& database);
/// Throws InputError listing every diagnostic with its key path; unknown and doubled keys are
/// diagnostics, and so are lint errors. A material may state its `reflectivity`, which must close
/// to 1e-4.
SignatureDatabase signatureFromJson(const std::string& text, const std::string& fileName = "JSON",
                                    LintErrors errors = LintErrors::refuse);

/// The same form for work under way: lint errors do not keep a draft from being written. For
/// recovery copies, never in place of a database; read back with LintErrors::accept.
std::string draftToJson(const SignatureDatabase& database);

} // namespace irsg
