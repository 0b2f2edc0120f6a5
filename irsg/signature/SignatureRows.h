#pragma once

#include <map>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// Makes the tables of docs/formats-sigdb.md anew, empty, in place of those that are there, with
/// the columns of a version of the format.
void resetSchema(SQLite::Database& file, int version);

/// Inserts every entry with its hash. The tables must be empty and of this version, which must hold
/// what the database says (formatVersionOf).
void writeRows(const SignatureDatabase& database, SQLite::Database& file, int version);

/// Reads every table of a file of this version back: what later ones brought keeps its default.
/// Throws InputError, with `name` for the file, that lists each row whose content cannot be: a
/// value of the wrong type, axes that do not ascend.
SignatureDatabase readRows(SQLite::Database& file, int version, const std::string& name);

/// The stored hash of each entry.
std::map<std::string, std::string> readHashes(SQLite::Database& file);

} // namespace irsg
