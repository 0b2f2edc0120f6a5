#pragma once

#include <map>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// Makes the tables of docs/formats-sigdb.md anew, empty, in place of those that are there.
void resetSchema(SQLite::Database& file);

/// Inserts every entry with its hash. The tables must be empty.
void writeRows(const SignatureDatabase& database, SQLite::Database& file);

/// Reads every table back. Throws InputError, with `name` for the file, that lists each row whose
/// content cannot be: a value of the wrong type, axes that do not ascend.
SignatureDatabase readRows(SQLite::Database& file, const std::string& name);

/// The stored hash of each entry.
std::map<std::string, std::string> readHashes(SQLite::Database& file);

} // namespace irsg
