#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/smat-batch/Command.h"
#include "apps/smat-batch/Output.h"
#include "apps/smat-batch/ProjectInput.h"
#include "smatcore/settings/SettingInfo.h"
#include "smatcore/simulate/ImagingSensorXml.h"

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

int write(const std::string& project, const std::string& file, const Context& context) {
    writeImagingSensor(openProject(project).settings, file);
    if (context.json)
        fmt::print("{}\n", jsonText(nlohmann::ordered_json{{"file", file}}));
    else
        fmt::print("-> {}\n", file);
    return done;
}

} // namespace

void addSettingsCommand(CLI::App& app, Context& context) {
    CLI::App* command =
        app.add_subcommand("settings", "Lists every setting with its option, values and meaning");
    auto markdown = std::make_shared<bool>(false);
    command->add_flag("--markdown", *markdown, "As the page of the manual");
    auto project = std::make_shared<std::string>();
    auto sensor = std::make_shared<std::string>();
    command->add_option("--project", *project, "Project file (.smat) whose settings are written")
        ->type_name("FILE");
    command
        ->add_option("--imaging-sensor", *sensor,
                     "Writes the project's settings as an ImagingSensor file of KARMA (XML)")
        ->type_name("FILE");
    command->get_option("--imaging-sensor")->needs("--project");
    command->get_option("--project")->needs("--imaging-sensor");
    command->callback([&context, markdown, project, sensor] {
        context.work = [&context, markdown, project, sensor] {
            return sensor->empty() ? list(*markdown, context) : write(*project, *sensor, context);
        };
    });
}

} // namespace smat::batch
