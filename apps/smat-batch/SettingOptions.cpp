#include "apps/smat-batch/SettingOptions.h"

#include <algorithm>
#include <filesystem>

#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/PlacingOptions.h"
#include "irsg/core/Collect.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/project/ModelFields.h"
#include "smatcore/settings/AnalysisSections.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/ImagingSensorXml.h"

namespace smat::batch {

namespace {

std::string absolutePath(const std::string& path) {
    return path.empty() || path == "vacuum" ? path : std::filesystem::absolute(path).string();
}

/// A value with its paths made absolute; other values as they are.
std::string placed(const SettingInfo& setting, const std::string& text) {
    if (setting.kind == SettingKind::path)
        return absolutePath(text);
    if (setting.kind != SettingKind::pathList || text == "none")
        return text;
    std::string list;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(';', begin), text.size());
        const std::string item(irsg::trimmed(std::string_view(text).substr(begin, end - begin)));
        list += (begin == 0 ? "" : ";") + absolutePath(item);
        begin = end + 1;
    }
    return list;
}

bool isFlagWithValue(const std::string& option) {
    return option == PlacingOptions::textureFlag ||
           std::ranges::any_of(settingTable(), [&](const SettingInfo& setting) {
               return setting.kind == SettingKind::boolean && setting.option == option;
           });
}

} // namespace

std::vector<std::string> withJoinedFlags(std::vector<std::string> arguments) {
    std::vector<std::string> joined;
    for (std::string& argument : arguments) {
        const bool isValue = argument == "true" || argument == "false";
        if (isValue && !joined.empty() && isFlagWithValue(joined.back()))
            joined.back() += "=" + argument;
        else
            joined.push_back(std::move(argument));
    }
    return joined;
}

SettingOptions::SettingOptions(CLI::App& command, std::optional<AnalysisKind> kind)
    : SettingOptions(command, [kind](const SettingInfo& setting) {
          return concerns(setting, kind ? name(*kind) : "");
      }) {
    takeModels();
}

SettingOptions::SettingOptions(CLI::App& command,
                               const std::function<bool(const SettingInfo&)>& takes) {
    for (const SettingInfo& setting : settingTable()) {
        if (!takes(setting))
            continue;
        auto given = std::make_unique<Given>();
        given->setting = &setting;
        const std::string help = setting.help + " (" + setting.expected() + "; " +
                                 (setting.defaultText.empty() ? "nothing" : setting.defaultText) +
                                 ")";
        if (setting.kind == SettingKind::boolean) {
            given->option = command.add_flag(setting.option, given->flag, help)->take_last();
        } else {
            given->option = command.add_option(setting.option, given->text, help);
            given->option->type_name(setting.unit.empty() ? "" : setting.unit);
            // A list may also be given word by word.
            if (setting.kind == SettingKind::pathList)
                given->option->join(';');
            else if (setting.kind == SettingKind::band || setting.kind == SettingKind::realList)
                given->option->join(',');
            else
                given->option->take_last();
        }
        given->option->group(sectionTitle(setting.section()));
        given_.push_back(std::move(given));
    }
    if (takes(settingInfo(key::environmentSunElevation)))
        sun_.emplace(command);
    if (takes(settingInfo(key::sensorMode))) {
        command
            .add_option("--imaging-sensor", imagingSensor_,
                        "An ImagingSensor file of KARMA (XML): calculation mode, antialiasing and "
                        "backgrounds, over those of the project and below other options")
            ->type_name("FILE")
            ->take_last()
            ->group(sectionTitle("sensor"));
    }
    command
        .add_option("--set", assignments_,
                    "Any setting: key=value, as often as needed; and of a model beside the "
                    "target models.NAME.KEY=value, KEY as project set has it")
        ->type_name("KEY=VALUE")
        ->expected(1)
        ->take_all();
}

void SettingOptions::place(Project& project) const {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::string& assignment : assignments_) {
        if (!isModelAssignment(assignment))
            continue;
        irsg::collect(diagnostics, [&] { assignToModel(project, assignment); });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

Settings SettingOptions::values() const {
    Settings settings;
    std::vector<irsg::Diagnostic> diagnostics;
    const auto collect = [&](const auto& work) { irsg::collect(diagnostics, work); };
    for (const std::string& assignment : assignments_) {
        if (takesModels_ && isModelAssignment(assignment))
            continue;
        collect([&] {
            const std::size_t equals = assignment.find('=');
            const std::string_view key =
                irsg::trimmed(std::string_view(assignment).substr(0, equals));
            const SettingInfo* setting = findSetting(key);
            if (equals != std::string::npos)
                warnOnce(formerNameRemarks(key, assignment.substr(equals + 1)));
            settings.setFromArgument(setting != nullptr && equals != std::string::npos
                                         ? setting->key + "=" +
                                               placed(*setting, assignment.substr(equals + 1))
                                         : assignment);
        });
    }
    for (const auto& given : given_) {
        if (given->option->count() > 0) {
            collect([&] {
                warnOnce(formerNameRemarks(given->setting->key, given->text));
                settings.set(given->setting->key,
                             given->setting->kind == SettingKind::boolean
                                 ? (given->flag ? "true" : "false")
                                 : placed(*given->setting, given->text),
                             given->setting->option);
            });
        }
    }
    if (sun_)
        collect([&] { placeSun(settings); });
    if (!imagingSensor_.empty()) {
        collect([&] {
            const ImagingSensorFile read = readImagingSensor(imagingSensor_);
            settings = read.set.settings.with(settings);
            for (const std::string& remark : read.remarks)
                warn(remark);
        });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return settings;
}

void SettingOptions::requireNamed(const Settings& inEffect) const {
    if (imagingSensor_.empty())
        return;
    std::vector<irsg::Diagnostic> missing =
        readImagingSensor(imagingSensor_).missingIn(inEffect, "the project or an option");
    if (!missing.empty())
        throw irsg::InputError(std::move(missing));
}

void SettingOptions::placeSun(Settings& settings) const {
    const auto sun = sun_->sun();
    if (!sun)
        return;
    std::vector<irsg::Diagnostic> diagnostics;
    const auto put = [&](std::string_view key, double value) {
        if (settings.isSet(key)) {
            diagnostics.push_back({settingInfo(key).option, "", settings.text(key),
                                   "nothing beside --date and --utc, which give it"});
        } else {
            settings.set(key, value);
        }
    };
    put(key::environmentSunAzimuth, irsg::degrees(sun->position.azimuth_rad));
    put(key::environmentSunElevation, irsg::degrees(sun->position.elevation_rad));
    put(key::environmentDayOfYear, sun->dayOfYear);
    if (!diagnostics.empty())
        throw irsg::InputError(std::move(diagnostics));
}

} // namespace smat::batch
