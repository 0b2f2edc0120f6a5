#include "apps/smat-batch/FormerNames.h"

#include <algorithm>
#include <map>

#include "irsg/core/AppendUnique.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/settings/SettingInfo.h"

namespace smat::batch {

namespace {

using Names = std::map<std::string, std::string, std::less<>>; ///< of today, by former ones

Names formerCommands(const CLI::App& app) {
    Names names;
    for (const auto& kinds : {allAnalysisKinds(), allTools()}) {
        for (const AnalysisKind kind : kinds) {
            const auto isIt = [&](const CLI::App* command) {
                return command->get_name() == kind->name;
            };
            if (kind->formerName != nullptr && !app.get_subcommands(isIt).empty())
                names[kind->formerName] = kind->name;
        }
    }
    return names;
}

Names formerOptions() {
    Names names{{"--former", "--previous"},
                {"--phases", "--subpixel-shifts"},
                {"--ways", "--configurations"}};
    for (const SettingInfo& setting : settingTable())
        for (const std::string& option : setting.former.options)
            names[option] = setting.option;
    return names;
}

} // namespace

std::vector<std::string> withNamesOfToday(const CLI::App& app, std::vector<std::string> arguments,
                                          std::vector<std::string>& remarks) {
    const Names commands = formerCommands(app), options = formerOptions();
    const auto replace = [&](std::string& argument, const Names& names) {
        const std::size_t end = std::min(argument.find('='), argument.size());
        const auto found = names.find(std::string_view(argument).substr(0, end));
        if (found == names.end())
            return;
        irsg::appendUnique(remarks, found->first + " is called " + found->second + " now");
        argument.replace(0, end, found->second);
    };
    // Only options of all commands stand before the command, of which one takes a value.
    auto command = arguments.begin();
    while (command != arguments.end() && command->starts_with("-"))
        command += *command == "--threads" && command + 1 != arguments.end() ? 2 : 1;
    if (command != arguments.end())
        replace(*command, commands);
    for (std::string& argument : arguments)
        if (argument.starts_with("--"))
            replace(argument, options);
    return arguments;
}

} // namespace smat::batch
