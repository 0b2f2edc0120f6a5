#pragma once

#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/Command.h"
#include "irsg/signature/SignatureFile.h"

namespace smat::batch {

/// The commands of `db` that have a file of their own.
void addDatabaseImport(CLI::App& database, Context& context);
void addDatabaseLint(CLI::App& database, Context& context);
void addDatabaseCopy(CLI::App& database, Context& context);
void addDatabaseInfo(CLI::App& database, Context& context);

/// The database of a command, with a warning for each entry that was changed outside this program
/// and accepted.
irsg::SignatureDatabase loadedDatabase(const std::string& file, bool acceptChanges,
                                       Context& context);

} // namespace smat::batch
