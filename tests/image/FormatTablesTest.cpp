#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"

namespace irsg {
namespace {

const std::filesystem::path source = SMAT_SOURCE_DIR;

/// "SUITE.NAME" of every test of the folder of this one.
std::set<std::string> testsOfImages() {
    std::set<std::string> names;
    const std::regex macro("TEST(?:_P)?\\(\\s*(\\w+),\\s*(\\w+)\\)");
    for (const auto& entry : std::filesystem::directory_iterator(source / "tests/image")) {
        if (entry.path().extension() != ".cpp") {
            continue;
        }
        const std::string text = readFile(entry.path());
        for (std::sregex_iterator it(text.begin(), text.end(), macro), end; it != end; ++it) {
            names.insert((*it)[1].str() + "." + (*it)[2].str());
        }
    }
    return names;
}

TEST(FormatTables, HaveATestForEveryRow) {
    const std::set<std::string> tests = testsOfImages();
    std::istringstream page(readFile(source / "docs/formats-images.md"));
    std::string chapter;
    std::size_t rows = 0;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) {
            chapter = line.substr(3);
        }
        const bool isRow = (chapter == "OpenEXR" || chapter == "TIFF") && line.starts_with("| ") &&
                           !line.starts_with("| feature");
        if (!isRow) {
            continue;
        }
        ++rows;
        const std::size_t last = line.rfind(" | ");
        const std::string named = line.substr(last + 3, line.size() - last - 5);
        EXPECT_TRUE(tests.contains(named)) << chapter << ": " << line;
    }
    EXPECT_GE(rows, 30U);
}

} // namespace
} // namespace irsg
