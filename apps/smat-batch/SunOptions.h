#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "irsg/atmosphere/SolarPosition.h"

namespace smat::batch {

/// `--date --utc --latitude --longitude`: where and when, in place of azimuth, elevation and
/// distance of the sun.
class SunOptions {
  public:
    explicit SunOptions(CLI::App& command);

    struct Sun {
        irsg::SunPosition position;
        int dayOfYear = 1;
    };
    /// No value where none of the options was given. Throws InputError that names every one that is
    /// missing or cannot be used.
    std::optional<Sun> sun() const;

  private:
    std::string date_, utc_, latitude_, longitude_;
};

} // namespace smat::batch
