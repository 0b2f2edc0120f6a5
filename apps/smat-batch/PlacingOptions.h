#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "irsg/geometry/reading/ModelValues.h"

namespace smat::batch {

/// How a bare model's file is turned and scaled: `--up-axis`, `--nose-axis`, `--unit`, `--origin`;
/// and whether its textures cut: `--cut-texture-alpha`.
class PlacingOptions {
  public:
    enum class Kind { all, axesAndUnit }; ///< the latter: without origin and textures
    explicit PlacingOptions(CLI::App& command, Kind kind = Kind::all);

    /// May be followed by true or false.
    static constexpr const char* textureFlag = "--cut-texture-alpha";

    /// What was given, in place of what `options` say of it. Throws InputError that names the
    /// option.
    irsg::ModelOptions over(irsg::ModelOptions options) const;
    /// The first option that was given, "" for none.
    std::string given() const;

  private:
    bool isTextureGiven() const { return textureOption_ && textureOption_->count() > 0; }

    std::string up_, nose_, unit_, origin_;
    CLI::Option* textureOption_ = nullptr;
    bool cutsTextureAlpha_ = false;
};

/// A placing as projects have it: "upAxis" and so on.
nlohmann::ordered_json placingJson(const irsg::ModelPlacing& placing);

} // namespace smat::batch
