#include "gui/scenario/ScenarioSettings.h"

#include "gui/settings/SettingsDialog.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/core/Errors.h"
#include "smatcore/simulate/ImagingSensorXml.h"

namespace smat::gui {
namespace {

/// What holds where the part sets nothing itself.
Settings inheritedBy(const Scenario& scenario, const std::optional<std::size_t>& sensor) {
    if (!sensor)
        return scenarioDefaults();
    Settings settings = scenarioDefaults().with(scenario.settings);
    const std::filesystem::path& file = scenario.sensors.at(*sensor).imagingSensor;
    if (file.empty())
        return settings;
    try {
        return settings.with(readImagingSensor(scenario.resolve(file)).set.settings);
    } catch (const irsg::InputError&) {
        return settings; // told with the pictures
    }
}

Settings& own(Scenario& scenario, const std::optional<std::size_t>& sensor) {
    return sensor ? scenario.sensors.at(*sensor).settings : scenario.settings;
}

std::vector<SettingsPage> scenarioPages() {
    std::vector<SettingsPage> pages = SettingsDialog::pages();
    for (SettingsPage& page : pages)
        std::erase_if(page.keys,
                      [](const std::string& key) { return !isScenarioSetting(settingInfo(key)); });
    std::erase_if(pages, [](const SettingsPage& page) { return page.keys.empty(); });
    // Frames are images, of which a project has settings in their form.
    SettingsPage frames{SettingsDialog::tr("Frames"), "film", {}};
    for (const SettingInfo& setting : settingTable())
        if (setting.section() == "image" && isScenarioSetting(setting))
            frames.keys.push_back(setting.key);
    frames.always = frames.keys;
    pages.push_back(std::move(frames));
    return pages;
}

} // namespace

void editScenarioSettings(ScenarioDocument& document, std::optional<std::size_t> sensor,
                          Dialogs& dialogs, QWidget* parent) {
    const auto inherited = [&document, sensor] { return inheritedBy(document.scenario(), sensor); };
    const auto inEffect = [&document, sensor, inherited] {
        Scenario scenario = document.scenario();
        return inherited().with(own(scenario, sensor));
    };
    const QString whose = sensor ? textOf(document.scenario().sensors.at(*sensor).name)
                                 : SettingsDialog::tr("all sensors");
    SettingsSubject subject;
    subject.title = SettingsDialog::tr("Settings of %1").arg(whose);
    subject.settings = inEffect;
    subject.resolve = [&document](const std::filesystem::path& path) {
        return document.scenario().resolve(path);
    };
    subject.set = [&document, sensor, inherited, inEffect, whose](const Settings& edited) {
        const Settings before = inEffect(), below = inherited();
        return document.change(SettingsDialog::tr("Change settings of %1").arg(whose),
                               [&](EditedScenario& state) {
                                   Settings& of = own(state.scenario, sensor);
                                   for (const SettingInfo& setting : settingTable()) {
                                       const std::string& text = edited.text(setting.key);
                                       if (text == before.text(setting.key))
                                           continue;
                                       if (text == below.text(setting.key))
                                           of.reset(setting.key);
                                       else
                                           of.set(setting.key, text);
                                   }
                               });
    };
    SettingsDialog dialog(
        subject, scenarioPages(),
        [&dialogs, parent](const QString& title, const QString& filter) {
            return dialogs.openFile(parent, title, {filter});
        },
        parent);
    dialogs.run(dialog);
}

} // namespace smat::gui
