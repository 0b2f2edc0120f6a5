#pragma once

#include <CLI/CLI.hpp>

#include "apps/smat-batch/Command.h"

namespace smat::batch {

/// `db import`, the one command of `db` that has more than one source.
void addDatabaseImport(CLI::App& database, Context& context);

} // namespace smat::batch
