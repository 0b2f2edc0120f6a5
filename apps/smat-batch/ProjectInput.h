#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/PlacingOptions.h"
#include "smatcore/project/Project.h"

namespace smat::batch {

/// Reads a `.smat` file; warns on standard error of former names of settings in it. Throws
/// InputError.
Project openProject(const std::string& file);

/// The project a command works on: a `.smat` file, or a bare model with the database of
/// `--database` or the one that lies beside it, placed as PlacingOptions say.
class ProjectInput {
  public:
    explicit ProjectInput(CLI::App& command);

    /// Warns on standard error of keys the file holds and this version does not know. Throws
    /// InputError.
    Project load() const;
    /// Throws InputError where there are options of a bare model, which `what`, "a scenario", has
    /// no use for.
    void refuseOptionsFor(const std::string& what) const;

    /// As it was given.
    const std::string& file() const { return file_; }

  private:
    std::string file_;
    std::string database_;
    PlacingOptions placing_;
};

} // namespace smat::batch
