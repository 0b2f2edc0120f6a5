#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smatcore/settings/SettingInfo.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

/// Values of settings by key. A setting that was never set has its default; a value that was set
/// stays set even where it equals the default, so that the settings of an analysis can override
/// those of its project.
class Settings {
  public:
    /// Throws InputError naming key, value and what was expected, also for an unknown key. A former
    /// name stands for that of today. `file` is what the error calls the place the text came from.
    void set(std::string_view key, std::string_view text, const std::string& file = "");
    void set(std::string_view key, double value);
    void set(std::string_view key, int value);
    /// "key=value", the argument of `--set`.
    void setFromArgument(std::string_view argument);
    void reset(std::string_view key);

    /// Canonical text of the value in effect. LogicError for an unknown key.
    const std::string& text(std::string_view key) const;
    /// The value in effect. A key that is no row of the table, or one of another type, is a
    /// LogicError.
    double operator[](RealKey key) const;
    int operator[](IntegerKey key) const;
    bool operator[](BooleanKey key) const;
    const std::string& operator[](TextKey key) const { return text(key); }
    /// The number; no value where it is one of the choices.
    std::optional<double> operator[](OptionalRealKey key) const;
    /// The numbers; none where it is one of the choices.
    std::vector<double> operator[](RealListKey key) const;
    /// The files as written; empty where there are none.
    std::vector<std::filesystem::path> operator[](PathsKey key) const;

    bool isSet(std::string_view key) const { return values_.find(key) != values_.end(); }
    /// True where the value in effect is the default, set or not.
    bool isDefault(std::string_view key) const;
    /// Everything that was set, by key.
    const std::map<std::string, std::string, std::less<>>& values() const { return values_; }
    /// These settings, with everything that is set in `overrides` on top.
    Settings with(const Settings& overrides) const;

    bool operator==(const Settings&) const = default;

  private:
    std::map<std::string, std::string, std::less<>> values_;
};

} // namespace smat
