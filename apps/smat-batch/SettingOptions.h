#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "apps/smat-batch/SunOptions.h"
#include "smatcore/project/Project.h"

namespace smat::batch {

/// The options of a command that set settings: the common ones, those of one kind of analysis where
/// one is given, and `--set key=value`. All come from the table of settings.
class SettingOptions {
  public:
    SettingOptions(CLI::App& command, std::optional<AnalysisKind> kind);
    /// Those of the settings that `takes` is true for. `--set` takes all.
    SettingOptions(CLI::App& command, const std::function<bool(const SettingInfo&)>& takes);

    /// What was given, with paths made absolute because they are relative to where the user stands;
    /// below it what an ImagingSensor file says, whose parameters without effect are warned of.
    /// Throws InputError with every diagnostic.
    Settings values() const;
    /// `--set` takes models.NAME.KEY=value too, for place().
    void takeModels() { takesModels_ = true; }
    /// Does to the models of a project what that says. Throws InputError with every diagnostic.
    void place(Project& project) const;
    /// Throws InputError where the ImagingSensor file turns on what these settings, all in effect,
    /// name no files for.
    void requireNamed(const Settings& inEffect) const;

  private:
    struct Given {
        const SettingInfo* setting;
        CLI::Option* option;
        std::string text;
        bool flag = false;
    };
    std::vector<std::unique_ptr<Given>> given_; ///< the parser keeps pointers into them
    /// The sun of a moment and a place, where settings of it are taken.
    void placeSun(Settings& settings) const;

    std::string imagingSensor_; ///< file
    std::vector<std::string> assignments_;
    bool takesModels_ = false;
    std::optional<SunOptions> sun_;
};

/// Arguments of a command line in which what is true or false of scene and models may be followed
/// by either word, as every other setting by its value: "--sun-disc", "false" becomes
/// "--sun-disc=false".
std::vector<std::string> withJoinedFlags(std::vector<std::string> arguments);

} // namespace smat::batch
