#include "smatcore/settings/SettingInfo.h"

namespace smat {

namespace {

/// A cell of a Markdown table.
std::string cell(std::string text) {
    for (std::size_t i = text.find('|'); i != std::string::npos; i = text.find('|', i + 2))
        text.insert(i, "\\");
    return text;
}

std::string defaultShown(const SettingInfo& setting) {
    return setting.defaultText.empty() ? "nothing" : "`" + setting.defaultText + "`";
}

} // namespace

std::string settingsManual() {
    std::string text =
        "# Settings\n\n"
        "Each setting is one key of the project file (`sensor.width` is `width` in the object\n"
        "`sensor`), one option of `smat-batch`, and one field of the window's forms. Any of them "
        "can\n"
        "also be given as `--set key=value`. A named analysis may override every setting of its\n"
        "project. This page is written by `smat-batch settings --markdown`.\n";
    std::string section;
    for (const SettingInfo& setting : settingTable()) {
        if (setting.section() != section) {
            section = setting.section();
            text += "\n## " + sectionTitle(section) + "\n\n";
            if (isAnalysisSection(section))
                text += "Of this kind of analysis alone.\n\n";
            text += "| key | option | value | default | meaning |\n|---|---|---|---|---|\n";
        }
        text += "| `" + setting.key + "` | `" + setting.option + "` | " + cell(setting.expected()) +
                " | " + defaultShown(setting) + " | " + cell(setting.help) + " |\n";
    }
    return text;
}

} // namespace smat
