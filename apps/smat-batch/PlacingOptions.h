#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "irsg/scene/model/ModelValues.h"

namespace smat::batch {

/// How a bare model's file is turned and scaled: `--up-axis`, `--nose-axis`, `--unit`, `--origin`.
class PlacingOptions {
  public:
    explicit PlacingOptions(CLI::App& command);

    /// Throws InputError that names the option.
    irsg::ModelPlacing placing() const;
    /// The first option that was given, "" for none.
    std::string given() const;

  private:
    std::string up_, nose_, unit_, origin_;
};

} // namespace smat::batch
