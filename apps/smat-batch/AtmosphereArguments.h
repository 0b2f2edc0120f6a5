#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "irsg/atmosphere/Environment.h"

namespace smat::batch {

/// The air a command asks: one or more ATMOSPHERE, files or `none`, as the atmospheres of a
/// project.
class AtmosphereArguments {
  public:
    explicit AtmosphereArguments(CLI::App& command);

    /// As smat::addAtmosphere with what was given; InputError as there.
    std::optional<irsg::SunPosition> addTo(irsg::Environment& environment,
                                           std::optional<int> resolution_per_cm = {}) const;

  private:
    std::vector<std::string> inputs_;
};

} // namespace smat::batch
