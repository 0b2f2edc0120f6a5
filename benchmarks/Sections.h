#pragma once

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "irsg/core/Errors.h"

namespace irsg::bench {

/// The parts of a study by name, in their order.
template <typename Options>
using Sections = std::vector<std::pair<std::string, void (*)(const Options&)>>;

template <typename Options>
std::vector<std::string> namesOf(const Sections<Options>& sections) {
    std::vector<std::string> names;
    for (const auto& [name, run] : sections)
        names.push_back(name);
    return names;
}

/// Runs those that are wanted, all where none is named. Returns the exit code of the program;
/// errors go to the standard error.
template <typename Options>
int run(const Sections<Options>& sections, const std::vector<std::string>& wanted,
        const Options& options) {
    try {
        for (const auto& [name, section] : sections)
            if (wanted.empty() || std::ranges::find(wanted, name) != wanted.end())
                section(options);
    } catch (const InputError& error) {
        std::cerr << error.what() << "\n";
        return 2;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 3;
    }
    return 0;
}

} // namespace irsg::bench
