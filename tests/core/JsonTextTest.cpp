#include "smatcore/support/JsonText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/project/ProjectFile.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "tests/support/Refusal.h"

namespace smat {
namespace {

using nlohmann::json;
using test::refusalOf;
using testing::AllOf;
using testing::HasSubstr;

/// JSON that is whole before a zero byte, and what would unbalance a list of open brackets behind.
const std::string cutByZero[] = {
    std::string("{}\0]", 4),
    std::string("9\0}}}}", 6),
    std::string("{\"version\": 1}\n\0,,,,", 20),
    std::string("7\0\"\\u12\"", 8),
    std::string("[1]\0", 4),
};

TEST(JsonText, IsNotTakenForWholeBeforeAZeroByte) {
    for (const std::string& text : cutByZero) {
        EXPECT_THAT(refusalOf([&] { parseJsonText<json>(text, "a.json", "a list"); }),
                    AllOf(HasSubstr("a.json: line"), HasSubstr("a zero byte"),
                          HasSubstr("expected a list")))
            << text;
    }
    EXPECT_THAT(
        refusalOf([] { parseJsonText<json>(std::string("{\n\n\0}", 5), "a.json", "a list"); }),
        HasSubstr("a.json: line 3: found a zero byte"));
    // Written as an escape it is a character of a text like any other.
    EXPECT_EQ(parseJsonText<json>("[\"\\u0000\"]", "a.json", "a list")[0], std::string("\0", 1));
}

TEST(JsonText, WithAZeroByteIsNeitherAProjectNorAScenario) {
    for (const std::string& text : cutByZero) {
        EXPECT_THAT(refusalOf([&] { projectFromJson(text, "p.smat"); }),
                    AllOf(HasSubstr("p.smat: line"), HasSubstr("a zero byte")))
            << text;
        EXPECT_THAT(refusalOf([&] { scenarioFromJson(text, "s.json"); }),
                    AllOf(HasSubstr("s.json: line"), HasSubstr("a zero byte")))
            << text;
    }
}

TEST(JsonLines, KnowTheLinesBehindAByteOrderMark) {
    const JsonLines lines("\xEF\xBB\xBF{\n\"a\": [1,\n2], \"a\": 3}");
    EXPECT_EQ(lines.line("a.1"), 3);
    ASSERT_EQ(lines.duplicates().size(), 1u);
    EXPECT_EQ(lines.duplicates()[0], std::pair(std::string("a"), 3));
    EXPECT_THAT(refusalOf([] {
                    projectFromJson("\xEF\xBB\xBF{\"version\": 1,\n\"sensor\": {\"width\": 0}}",
                                    "p.smat");
                }),
                HasSubstr("sensor.width, line 2"));
}

TEST(JsonLines, OfATextThatIsNotJsonAreOurOwnFault) {
    for (const char* text : {"]", "{}}", "1, 2", "[1]]]]]]]"}) {
        EXPECT_THROW(JsonLines{text}, irsg::LogicError) << text;
    }
}

} // namespace
} // namespace smat
