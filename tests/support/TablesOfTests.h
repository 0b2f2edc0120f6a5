#pragma once

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"

namespace irsg::test {

/// "SUITE.NAME" of every test of some folders of tests.
inline std::set<std::string> testsIn(std::initializer_list<const char*> folders) {
    std::set<std::string> names;
    const std::regex macro("TEST(?:_P)?\\(\\s*(\\w+),\\s*(\\w+)\\)");
    for (const char* folder : folders) {
        for (const auto& entry : std::filesystem::directory_iterator(
                 std::filesystem::path(SMAT_SOURCE_DIR) / "tests" / folder)) {
            if (entry.path().extension() != ".cpp") {
                continue;
            }
            const std::string text = readFile(entry.path());
            for (std::sregex_iterator it(text.begin(), text.end(), macro), end; it != end; ++it) {
                names.insert((*it)[1].str() + "." + (*it)[2].str());
            }
        }
    }
    return names;
}

/// Each row of the tables of features in some chapters of a page must end with one of the tests.
/// Returns how many rows there are.
inline std::size_t expectTests(const char* page, const std::set<std::string>& chapters,
                               const std::set<std::string>& tests) {
    std::istringstream text(readFile(std::filesystem::path(SMAT_SOURCE_DIR) / "docs" / page));
    std::string chapter;
    std::size_t rows = 0;
    for (std::string line; std::getline(text, line);) {
        if (line.starts_with("## ")) {
            chapter = line.substr(3);
        }
        if (!chapters.contains(chapter) || !line.starts_with("| ") ||
            line.starts_with("| feature")) {
            continue;
        }
        ++rows;
        const std::size_t last = line.rfind(" | ");
        const std::string named = line.substr(last + 3, line.size() - last - 5);
        EXPECT_TRUE(tests.contains(named)) << chapter << ": " << line;
    }
    return rows;
}

} // namespace irsg::test
