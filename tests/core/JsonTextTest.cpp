#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

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

TEST(JsonText, OfAProjectIsPlacedBehindAByteOrderMark) {
    EXPECT_THAT(refusalOf([] {
                    projectFromJson("\xEF\xBB\xBF{\"version\": 1,\n\"sensor\": {\"width\": 0}}",
                                    "p.smat");
                }),
                HasSubstr("sensor.width, line 2"));
}

TEST(JsonText, OfAResultNamesWhatIsNotOfItsForm) {
    const std::pair<const char*, const char*> rows[] = {
        {"[]", "found [], expected an object"},
        {"{\n\"columns\": []}", "provenance, line 1: found nothing, expected a list"},
        {"{\"provenance\": [\n{\"key\": 1}], \"columns\": []}",
         "provenance.0.key, line 2: found 1, expected a text"},
        {"{\"provenance\": [], \"columns\": [\n7]}", "columns.0, line 2: found 7"},
        {"{\"provenance\": [],\n\"columns\": [{\"name\": \"a\", \"unit\": \"\", \"values\": "
         "[1,\n\"x\"]}]}",
         "columns.0.values.1, line 3: found \"x\", expected a number or null"},
        {"{\"provenance\": [],\n\"columns\": [{\"name\": \"a\", \"unit\": \"\", \"values\": [1]},\n"
         "{\"name\": \"b\", \"unit\": \"\", \"values\": [1, 2]}]}",
         "columns.1.values, line 3: found 2 values, expected 1 values"},
    };
    const std::filesystem::path file = test::ownFolder() / "r.json";
    for (const auto& [text, says] : rows) {
        std::ofstream(file) << text;
        EXPECT_THAT(refusalOf([&] { ResultTable::load(file); }), HasSubstr(says)) << text;
    }
}

} // namespace
} // namespace smat
