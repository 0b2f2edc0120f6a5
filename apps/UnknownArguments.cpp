#include "apps/UnknownArguments.h"

#include <algorithm>

#include "smatcore/support/NearestNames.h"

namespace smat {

namespace {

std::vector<std::string> commandsOf(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    return names;
}

/// Those of a command and of what it is a command of.
std::vector<std::string> optionsOf(const CLI::App* command) {
    std::vector<std::string> names;
    for (; command != nullptr; command = command->get_parent()) {
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& name : option->get_lnames())
                names.push_back("--" + name);
            for (const std::string& name : option->get_snames())
                names.push_back("-" + name);
        }
    }
    return names;
}

/// "smat-batch db info".
std::string pathOf(const CLI::App* command) {
    const CLI::App* above = command->get_parent();
    return (above == nullptr ? "" : pathOf(above) + " ") + command->get_name();
}

bool isOption(const std::string& argument) {
    return argument.size() > 1 && argument.starts_with('-');
}

} // namespace

std::optional<std::string> unknownArgument(const CLI::App& app,
                                           const std::vector<std::string>& arguments) {
    const std::vector<std::string> left = app.remaining(true);
    if (left.empty())
        return std::nullopt;
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().back();
    const std::string path = pathOf(command);
    const auto message = [&](const std::string& found, const std::string& expected) {
        return path + ": found " + found + ", expected " + expected;
    };
    if (const auto option = std::ranges::find_if(left, isOption); option != left.end()) {
        const std::string name = option->substr(0, option->find('='));
        return message(name, "an option that it has" + didYouMean(name, optionsOf(command)) + " (" +
                                 path + " --help lists them)");
    }
    const std::vector<std::string> commands = commandsOf(*command);
    if (commands.empty())
        return message(left.front(), "no further argument (" + path + " --help lists them)");
    // A program that also takes a file may have taken the command for it.
    const auto word = std::ranges::find_if_not(arguments, isOption);
    const bool isFirst =
        command == &app && word != arguments.end() && !nearestNames(*word, commands).empty();
    const std::string& found = isFirst ? *word : left.front();
    return message(found,
                   "a command" + didYouMean(found, commands) + " (" + path + " --help lists them)");
}

} // namespace smat
