#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/PlacingOptions.h"
#include "smatcore/project/Project.h"

namespace smat::batch {

/// The project a command works on: a `.smat` file, or a bare model with the database of
/// `--database` or the one that lies beside it, placed as PlacingOptions say.
class ProjectInput {
  public:
    explicit ProjectInput(CLI::App& command);

    /// Warns on standard error of keys the file holds and this version does not know. Throws
    /// InputError.
    Project load() const;

  private:
    std::string file_;
    std::string database_;
    PlacingOptions placing_;
};

} // namespace smat::batch
