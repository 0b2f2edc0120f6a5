#include "smatcore/selftest/SelfTest.h"

#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/cli/Program.h"

namespace smat {
namespace {

/// One test a check, so that each has its time and none hides behind another.
class SelfTestTest : public testing::TestWithParam<std::string> {};

TEST_P(SelfTestTest, Passes) {
    for (const SelfTestResult& result : runSelfTest({.hard = true, .only = GetParam()})) {
        if (result.outcome == SelfTestResult::Outcome::notPossible) {
            GTEST_SKIP() << result.remark;
        }
        EXPECT_EQ(result.outcome, SelfTestResult::Outcome::passed) << selfTestLine(result);
    }
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const SelfTestCheck& check : selfTestChecks()) {
        all.push_back(check.name);
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Checks, SelfTestTest, testing::ValuesIn(names()), [](const auto& check) {
    std::string name;
    for (const char c : check.param) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            name += c;
        } else {
            name += 'X';
        }
    }
    return name;
});

TEST(SelfTestCatalogue, HasEachNameOnceAndSaysWhatItHoldsAgainstWhat) {
    std::set<std::string> seen;
    for (const SelfTestCheck& check : selfTestChecks()) {
        EXPECT_TRUE(seen.insert(check.name).second) << check.name;
        EXPECT_GT(check.says.size(), 20U) << check.name;
        EXPECT_GE(check.bound, 0.0) << check.name;
    }
    EXPECT_GE(seen.size(), 70U);
}

TEST(SelfTestCatalogue, IsWhatThePageOfTheManualIsMadeOf) {
    // Of each check what does not depend on the machine: all but what was found and its error.
    const auto known = [](const std::string& page) {
        std::vector<std::string> rows;
        std::istringstream lines(page);
        for (std::string line; std::getline(lines, line);) {
            std::vector<std::string> cells;
            std::istringstream words(line);
            for (std::string cell; std::getline(words, cell, '|');) {
                cells.push_back(cell);
            }
            rows.push_back(cells.size() < 8 ? line : cells[1] + cells[2] + cells[5] + cells[7]);
        }
        return rows;
    };
    std::vector<SelfTestResult> results;
    for (const SelfTestCheck& check : selfTestChecks()) {
        results.push_back({.check = &check, .found = {}, .remark = {}});
    }
    EXPECT_EQ(known(test::contentOf(std::filesystem::path(SMAT_SOURCE_DIR) / "docs/accuracy.md")),
              known(selfTestPage(results)))
        << "smat-batch selftest --hard --page > docs/accuracy.md";
}

TEST(SelfTestCatalogue, TakesWhatIsNoNumberForAnError) {
    const SelfTestCheck check{.name = "x", .says = "", .unit = "", .bound = 1e30, .measure = {}};
    EXPECT_TRUE(std::isinf(check.errorOf({std::nan(""), 1.0})));
    EXPECT_TRUE(std::isinf(check.errorOf({0.0, 0.0})));
    EXPECT_DOUBLE_EQ(check.errorOf({1.1, 1.0}), 0.10000000000000009);
}

} // namespace
} // namespace smat
