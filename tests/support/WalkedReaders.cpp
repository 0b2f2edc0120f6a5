#include "tests/support/WalkedReaders.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "irsg/core/FileReading.h"

namespace smat::test {

namespace {

const std::filesystem::path page =
    std::filesystem::path(SMAT_SOURCE_DIR) / "docs/formats-walked.md";

} // namespace

std::vector<std::string> walkedKinds() {
    std::vector<std::string> kinds;
    std::istringstream lines(irsg::readFile(page));
    bool isBehindHead = false;
    for (std::string line; std::getline(lines, line);) {
        if (isBehindHead && line.starts_with("| ")) {
            kinds.push_back(line.substr(2, line.find(" | ", 2) - 2));
        }
        isBehindHead = isBehindHead || line.starts_with("|---");
    }
    return kinds;
}

void expectWalked(const std::string& kind, std::size_t number) {
    std::string text = irsg::readFile(page);
    const std::string row = "\n| " + kind + " | ";
    const std::size_t found = text.find(row);
    ASSERT_NE(found, text.npos) << "docs/formats-walked.md has no row '" << kind << "'";
    const std::size_t begin = found + row.size();
    const std::size_t length = text.find(" |", begin) - begin;
    if (std::getenv("SMAT_WRITE_TABLES") != nullptr) {
        text.replace(begin, length, std::to_string(number));
        std::ofstream(page, std::ios::binary) << text;
        return;
    }
    EXPECT_EQ(text.substr(begin, length), std::to_string(number))
        << kind << "; SMAT_WRITE_TABLES=1 writes the number";
}

} // namespace smat::test
