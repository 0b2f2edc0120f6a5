#include "irsg/core/JsonText.h"

#include <ctime>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "tests/support/Refusal.h"

namespace irsg {
namespace {

using smat::test::refusalOf;
using testing::AllOf;
using testing::HasSubstr;

const JsonForm form = {.expected = "a list (JSON)", .deepest = 4};
const JsonForm commented = {.expected = "a list (JSON)", .deepest = 4, .mayComment = true};

double processorSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

TEST(JsonText, IsReadWithAByteOrderMarkAndEscapes) {
    const auto value = parseJson("\xEF\xBB\xBF[1, \"\\u0000\", {\"a\\n\": true}]", "a.json", form);
    EXPECT_EQ(value[0], 1);
    EXPECT_EQ(value[1], std::string("\0", 1)); // an escape is a character like any other
    EXPECT_EQ(value[2]["a\n"], true);
}

TEST(JsonText, IsRefusedByLineAndColumn) {
    const std::pair<std::string, const char*> rows[] = {
        {"", "line 1, column 1: found the end of the text"},
        {"[1,\n 2", "line 2, column 3: found the end of the text"},
        {"[1,\n 2 x]", "line 2, column 4: found text that is not JSON"},
        {"{\"a\": NaN}", "line 1, column 7: found text that is not JSON"},
        {"[\"\xff\"]", "line 1, column 3: found text that is not JSON"},
        {std::string("{\n\n \0}", 6), "line 3, column 2: found a zero byte"},
        {std::string("[1]\0", 4), "line 1, column 4: found a zero byte"},
        {"[\n1e999]", "line 2, column 1: found the number 1e999, which is too large"},
        {"[[[\n[[", "line 2, column 2: found lists or objects nested more than 4 deep"},
        {"[1] // no\n", "line 1, column 5: found text that is not JSON"},
        {"{\"a\": {\n\"b\": 1,\n\"b\": 2}}", "a.b, line 3: found a key that occurs twice"},
        {"[{}, {\"a\\u0062\": 1,\n\"ab\": 2}]", "1.ab, line 2: found a key that occurs twice"},
    };
    for (const auto& [text, says] : rows) {
        EXPECT_THAT(refusalOf([&, &t = text] { parseJson(t, "a.json", form); }),
                    AllOf(HasSubstr("a.json: "), HasSubstr(says)))
            << text;
    }
    EXPECT_THAT(refusalOf([] { parseJson("[", "a.json", form); }), HasSubstr("a list (JSON)"));
}

TEST(JsonText, MayHoldCommentsWhereItsFormSaysSo) {
    const std::string text = "/* [[[[[[ \n \" */ [1, // }}\n{\"a\": \"//\", /* x */ \"b\": [\n2]}]";
    EXPECT_EQ(parseJson(text, "a.json", commented)[1]["b"][0], 2);
    EXPECT_THROW(parseJson(text, "a.json", form), InputError);
    const JsonPlaces places(text, true);
    EXPECT_EQ(places.line("0"), 2);
    EXPECT_EQ(places.line("1.a"), 3);
    EXPECT_EQ(places.line("1.b.0"), 4);
}

TEST(JsonPlaces, KnowTheLineOfEveryValue) {
    const JsonPlaces places(
        "\xEF\xBB\xBF{\n\"a\": [1,\n{\"x.y\":\n2, \"range [m]\": [0,\n1]}],\n\"\": 5}");
    EXPECT_EQ(places.line(""), 1);
    EXPECT_EQ(places.line("a"), 2);
    EXPECT_EQ(places.line("a.1"), 3);
    EXPECT_EQ(places.line("a[1].x.y"), 4);
    EXPECT_EQ(places.line("a[1].range [m]"), 4);
    EXPECT_EQ(places.line("a[1].range [m][1]"), 5);
    EXPECT_EQ(places.line("a.2"), 0);
    EXPECT_EQ(places.line("a.1.x"), 0);
    EXPECT_EQ(places.line("a.99999999999999999999"), 0);
    EXPECT_EQ(places.line("b"), 0);
}

TEST(JsonPlaces, NameAValueOrWhatItIsMissingIn) {
    const JsonPlaces places("{\n\"a\": {\n\"b\": [\n1]}}\n");
    EXPECT_EQ(places.position("a.b"), "a.b, line 3");
    EXPECT_EQ(places.position("a.b[0]"), "a.b[0], line 4");
    EXPECT_EQ(places.position("a.b[7]"), "a.b[7], line 3");
    EXPECT_EQ(places.position("a.c"), "a.c, line 2");
    EXPECT_EQ(places.position("a.b, node 2"), "a.b, node 2, line 3");
    EXPECT_EQ(places.position("a.b at 4 um"), "a.b at 4 um, line 3");
    EXPECT_EQ(places.position(""), "");
    // A text of one line has no lines to name.
    EXPECT_EQ(JsonPlaces("{\"a\": 1}\n").position("a"), "a");
}

TEST(JsonPlaces, OfATextThatIsNotJsonAreOurOwnFault) {
    for (const char* text : {"]", "{}}", "1, 2", "[1]]]]]]]"}) {
        EXPECT_THROW(JsonPlaces(text).line("a"), LogicError) << text;
    }
}

// Long keys above many values, of which every path would be long.
TEST(JsonPlaces, TakeNoMoreThanTheTextIsLong) {
    std::string deep, end;
    for (int i = 0; i < 90; ++i) {
        deep += "{\"" + std::string(10000, 'k') + "\":";
        end += '}';
    }
    std::string values = "[0", twice = "{\"a\":0";
    for (int i = 0; i < 100000; ++i) {
        values += ",{}";
        twice += ",\"a\":0";
    }
    const double before = processorSeconds();
    const JsonForm any = {.expected = "a list (JSON)"};
    const std::string text = deep + "\n" + values + "]" + end;
    EXPECT_NO_THROW(parseJson(text, "a.json", any));
    EXPECT_EQ(JsonPlaces(text).line("kk.1"), 0);
    try {
        parseJson(deep + twice + "}" + end, "a.json", any);
        FAIL() << "keys that occur twice";
    } catch (const InputError& error) {
        EXPECT_EQ(error.diagnostics().size(), 101u); // the last: and so many more
        EXPECT_LT(error.diagnostics().front().position.size(), 400u);
    }
    EXPECT_LT(processorSeconds() - before, 10.0);
}

} // namespace
} // namespace irsg
