#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smat {

/// What a setting holds. Every kind has one canonical text, which files, forms and the command line
/// share.
enum class SettingKind {
    real,         ///< "12.5"
    integer,      ///< "640"
    boolean,      ///< "false" or "true"
    choice,       ///< one of `choices`
    choiceOrReal, ///< one of `choices`, or a number in the range
    realList,     ///< "1000,3000": numbers in the range, in order, each once, or one of `choices`
    band,         ///< "3-5" or "3-5,8-12": bands in order, each once, in um
    path,         ///< a file, or empty; relative to the project file
    pathList      ///< files in order, separated by ';', or "none"
};

/// Who needs to see a setting: forms hide the expert ones until asked.
enum class SettingAudience { basic, expert };

/// A page of the dialog of settings, in the order of the dialog.
enum class SettingPage {
    bandAndMode,
    sensor,
    cameraAndModel,
    sunAndFluxes,
    atmosphere,
    scattering,
    background,
    skybox,
    terrain,
    antialiasing,
    colours,
    scalings,
    none ///< of the settings of one kind of analysis, which its own form has
};

/// What a setting, its option and its values were called by earlier versions. They are still read,
/// with a remark (formerNameRemarks); what is written has the names of today.
struct FormerNames {
    std::vector<std::string> keys = {};                            ///< "render.fluxes"
    std::vector<std::string> options = {};                         ///< "--fluxes"
    std::vector<std::pair<std::string, std::string>> choices = {}; ///< "inAll", today "perPixel"
};

/// The one description of a setting. The form, the project file, `--set key=value`, the short
/// option of the command line, the validation and the manual all come from it.
struct SettingInfo {
    std::string key;       ///< "sensor.width": section and name, the path in the project file
    std::string label;     ///< "Width"
    std::string unit = {}; ///< "px", "" without
    SettingKind kind = SettingKind::real;
    double minimum = 0.0; ///< of numbers, inclusive
    double maximum = 0.0;
    std::vector<std::string> choices = {};
    /// For forms, where the values do not speak for themselves: of the choices in their order, or
    /// of an integer's values from the minimum on.
    std::vector<std::string> names = {};
    std::string defaultText;
    std::string option; ///< "--width"; every setting has one
    std::string help;   ///< documentation string: one or more sentences
    SettingAudience audience = SettingAudience::basic;
    SettingPage page = SettingPage::none;
    int place = 0; ///< on the page, the least first; those of one place in the order of the table
    FormerNames former = {};

    /// "sensor".
    std::string section() const;
    /// "a number from 1 to 16384 (px)": what a value must be, as errors and the manual say it.
    std::string expected() const;
    /// The same of a value that is none: with the choices that are spelt nearly like it.
    std::string expectedInsteadOf(std::string_view text) const;
};

/// All settings, in the order of forms and manual. Sections: sensor, camera, target, state,
/// scaling, environment, render, display, and one for each kind of analysis (AnalysisSections.h).
const std::vector<SettingInfo>& settingTable();
/// By its key of today or a former one. Null for an unknown key.
const SettingInfo* findSetting(std::string_view key);
/// By its key of today. LogicError for an unknown key.
const SettingInfo& settingInfo(std::string_view key);
/// Keys of the settings on a page of the dialog, in the order of their fields.
std::vector<std::string> settingsOn(SettingPage page);
/// "sensor" -> "Sensor": heading of a section in forms and manual.
std::string sectionTitle(std::string_view section);
/// True for the sections that concern one kind of analysis only.
bool isAnalysisSection(std::string_view section);

/// "a setting that exists (smat-batch settings lists them)", with those that are spelt nearly like
/// `key`: what a message expects in place of an unknown key.
std::string expectedSetting(std::string_view key);
/// The end of a message about an unknown key in a section of settings, "sensors.0.render.fluxs":
/// didYouMean() among the settings of that section. "" for a path without one.
std::string settingsLike(std::string_view path);
/// One sentence for each former name in `key = text`: "render.fluxes is called
/// render.ambientReflection now". None where both are of today, or unknown.
std::vector<std::string> formerNameRemarks(std::string_view key, std::string_view text);

/// The canonical text of `text` as a value of this setting ("0640" -> "640", a former name of
/// a choice -> that of today), or no value where it is not one.
std::optional<std::string> canonicalText(const SettingInfo& setting, std::string_view text);

/// The reference manual of all settings, docs/settings.md.
std::string settingsManual();

} // namespace smat
