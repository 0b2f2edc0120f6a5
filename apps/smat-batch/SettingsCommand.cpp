#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "smatcore/settings/SettingInfo.h"

namespace smat::batch {

namespace {

int list(bool markdown, const Context& context) {
    if (markdown) {
        fmt::print("{}", settingsManual());
        return done;
    }
    if (context.json) {
        nlohmann::ordered_json rows = nlohmann::ordered_json::array();
        for (const SettingInfo& setting : settingTable()) {
            rows.push_back({{"key", setting.key},
                            {"option", setting.option},
                            {"label", setting.label},
                            {"unit", setting.unit},
                            {"default", setting.defaultText},
                            {"expected", setting.expected()},
                            {"help", setting.help}});
        }
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"settings", rows}}));
        return done;
    }
    for (const SettingInfo& setting : settingTable()) {
        fmt::print("{} ({})\n  {}\n  {}; {}\n", setting.key, setting.option, setting.help,
                   setting.expected(),
                   setting.defaultText.empty() ? "nothing by default"
                                               : setting.defaultText + " by default");
    }
    return done;
}

} // namespace

void addSettingsCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("settings", "Lists every setting with its option, values and meaning");
    auto markdown = std::make_shared<bool>(false);
    command->add_flag("--markdown", *markdown, "As the page of the manual");
    command->callback([&context, markdown] {
        context.work = [&context, markdown] { return list(*markdown, context); };
    });
}

} // namespace smat::batch
