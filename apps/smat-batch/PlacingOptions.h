#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "irsg/geometry/reading/ModelValues.h"

namespace smat::batch {

/// How a bare model's file is turned and scaled: `--up-axis`, `--nose-axis`, `--unit`, `--origin`;
/// and whether its textures cut: `--cut-texture-alpha`.
class PlacingOptions {
  public:
    explicit PlacingOptions(CLI::App& command);

    /// May be followed by true or false.
    static constexpr const char* textureFlag = "--cut-texture-alpha";

    /// What was given, in place of what `options` say of it. Throws InputError that names the
    /// option.
    irsg::ModelOptions over(irsg::ModelOptions options) const;
    /// The first option that was given, "" for none.
    std::string given() const;

  private:
    std::string up_, nose_, unit_, origin_;
    CLI::Option* textureOption_ = nullptr;
    bool cutsTextureAlpha_ = false;
};

} // namespace smat::batch
