#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// The `.sigdb` file: SQLite with an application id, a schema version in user_version, foreign keys
/// on and one transaction a save; any SQLite tool opens it. A hash of the canonical content of each
/// entry tells what was changed outside this program.
inline constexpr int signatureFileVersion = 1;

struct LoadedSignature {
    SignatureDatabase database;
    /// Entries whose content no longer matches its stored hash: "materials.3".
    std::vector<std::string> changedOutside;
};

enum class OutsideChanges { refuse, accept };

/// Throws InputError for a file that is missing, not a database of ours, damaged (integrity_check),
/// of a newer version, physically wrong (lint errors), or, with `refuse`, changed outside.
LoadedSignature loadSignatureFile(const std::filesystem::path& file,
                                  OutsideChanges outside = OutsideChanges::refuse);

/// Replaces the content of the file (made where absent) in one transaction: a crash leaves the old
/// or the new state. Throws InputError for a database that could not be loaded again (lint errors)
/// and for a file that cannot be written, is write-protected, is not ours or is of a newer version;
/// such a file is left as it is.
void saveSignatureFile(const SignatureDatabase& database, const std::filesystem::path& file);

/// Sorted, complete JSON for review and version control; equal databases give equal text. Throws
/// InputError for a database with lint errors.
std::string signatureToJson(const SignatureDatabase& database);
/// Throws InputError listing every offence with its key path; unknown and doubled keys are
/// offences, and so are lint errors. A material may state its `reflectivity`, which must close to
/// 1e-4.
SignatureDatabase signatureFromJson(const std::string& text, const std::string& fileName = "JSON");

} // namespace irsg
