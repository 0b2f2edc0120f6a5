#include "irsg/core/JsonReader.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "tests/support/Refusal.h"

namespace irsg {
namespace {

using smat::test::refusalOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;

const JsonForm form = {.expected = "a thing (JSON)", .deepest = 5};
const JsonForm bracketed = {.expected = "a thing (JSON)", .deepest = 5, .indexInBrackets = true};

JsonReader readerOf(const std::string& text, JsonErrors errors = JsonErrors::throwFirst,
                    const JsonForm& as = form) {
    return {text, "a.json", as, errors};
}

using Read = std::function<void(const JsonReader&)>;

/// What a text is refused for by one that reads it.
std::vector<std::string> refusalsOf(const std::string& text, JsonErrors errors, const Read& read,
                                    const JsonForm& as = form) {
    std::vector<std::string> said;
    try {
        const JsonReader root = readerOf(text, errors, as);
        read(root);
        root.throwRefused();
    } catch (const InputError& error) {
        for (const Diagnostic& one : error.diagnostics()) {
            said.push_back(one.message());
        }
    }
    return said;
}

TEST(JsonReader, GivesWhatIsThere) {
    const JsonReader root = readerOf(R"({"text": "a", "flag": true, "number": -2.5, "whole": 7,
        "word": "no", "texts": ["x", "y"], "numbers": [1, 2], "gaps": [1, null], "none": null,
        "rows": [[1, 2], [3, 4], [5, 6]], "object": {"b": {"c": 1}, "a": 2}})");
    EXPECT_EQ(root.file(), "a.json");
    EXPECT_TRUE(root.isObject());
    EXPECT_EQ(root.at("text").text(), "a");
    EXPECT_EQ(root.at("text").filledText("a name"), "a");
    EXPECT_EQ(root.at("text").shown(), "\"a\"");
    EXPECT_TRUE(root.at("flag").boolean());
    EXPECT_EQ(root.at("number").number(), -2.5);
    EXPECT_EQ(root.at("number").number({-2.5, -2.5}), -2.5);
    EXPECT_EQ(root.at("whole").number({7, 8}), 7.0);
    EXPECT_EQ(root.at("whole").count(7), 7u);
    EXPECT_EQ(root.at("whole").index(), 7);
    EXPECT_EQ(root.at("word").word({"yes", "no"}), 1u);
    EXPECT_THAT(root.at("texts").texts(), ElementsAre("x", "y"));
    EXPECT_THAT(root.at("numbers").numbers(), ElementsAre(1, 2));
    EXPECT_THAT(root.at("numbers").numbers(2, 2.0, "two"), testing::Optional(ElementsAre(1, 2)));
    EXPECT_TRUE(std::isnan(root.at("gaps").numbersOrNull()[1]));
    EXPECT_TRUE(std::isnan(root.at("none").numberOrNull()));
    EXPECT_EQ(root.at("number").numberOrNull(), -2.5);
    EXPECT_THAT(root.at("rows").columns(2),
                testing::Optional(ElementsAre(ElementsAre(1, 3, 5), ElementsAre(2, 4, 6))));
    EXPECT_EQ(root.at("rows").list().size(), 3u);
    EXPECT_EQ(root.at("object").at("b").at("c").index(), 1);
    ASSERT_EQ(root.at("object").members().size(), 2u);
    EXPECT_EQ(root.at("object").members()[0].first, "a"); // in the order of their keys
    EXPECT_EQ(root.at("object").members()[0].second.index(), 2);
    EXPECT_NO_THROW(root.refuseUnknown());
}

TEST(JsonReader, GivesWhatItsCallerSaysInPlaceOfWhatIsMissing) {
    const JsonReader root = readerOf(R"({"power": 2, "index": 3, "name": "a", "on": true})");
    EXPECT_EQ(root.at("title").textOr("none"), "none");
    EXPECT_EQ(root.at("name").textOr("none"), "a");
    EXPECT_EQ(root.at("off").booleanOr(true), true);
    EXPECT_EQ(root.at("on").booleanOr(false), true);
    EXPECT_EQ(root.at("mach").numberOr(0.5, {0, 30}), 0.5);
    EXPECT_EQ(root.at("power").numberOr(0.5, {0, 30}), 2.0);
    EXPECT_EQ(root.at("power").numberIfAny(), 2.0);
    EXPECT_EQ(root.at("mach").numberIfAny(), std::nullopt);
    EXPECT_EQ(root.at("index").indexIfAny("an index"), 3);
    EXPECT_EQ(root.at("other").indexIfAny("an index"), std::nullopt);
    EXPECT_TRUE(root.at("list").listOrNone().empty());
    EXPECT_FALSE(root.at("list").exists());
    EXPECT_TRUE(root.at("list").json().is_null());
    EXPECT_FALSE(root.isAnyRefused());
}

// A text that is refused as a whole is refused alike, whoever reads it.
TEST(JsonReader, RefusesATextThatIsNoJsonWhateverItsErrors) {
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"nothing", "", "a.json: line 1, column 1: found the end of the text, expected a thing"},
        {"cut off", "{\n\"a\": [1", "a.json: line 2, column 8: found the end of the text"},
        {"too deep", "{\n\"a\": [[[[[", "line 2, column 10: found lists or objects nested more"},
        {"endless", std::string(100000, '['), "line 1, column 6: found lists or objects nested"},
        {"a key twice", "{\"a\": {\n\"b\": 1,\n\"b\": 2}}", "a.b, line 3: found a key that occurs"},
        {"beyond doubles", "{\n\"a\": 1e999}", "line 2, column 6: found the number 1e999"},
        {"NaN", "{\n\"a\": NaN}", "line 2, column 6: found text that is not JSON"},
        {"Infinity", "{\n\"a\": -Infinity}", "line 2, column 7: found text that is not JSON"},
        {"a zero byte", std::string("{}\n\0", 4), "line 2, column 1: found a zero byte"},
    };
    for (const auto& row : rows) {
        for (const JsonErrors errors : {JsonErrors::collect, JsonErrors::throwFirst}) {
            EXPECT_THAT(refusalOf([&] { readerOf(row.text, errors); }), HasSubstr(row.says))
                << row.name;
        }
    }
}

struct Hard {
    const char* name;
    std::string text;
    Read read;
    /// Said of it with its diagnostics collected; the first one where the first is thrown.
    std::vector<std::string> said;
};
void PrintTo(const Hard& row, std::ostream* out) {
    *out << row.name;
}

class HardJson : public testing::TestWithParam<Hard> {};

TEST_P(HardJson, IsRefusedWithFileLineAndExpectation) {
    const Hard& row = GetParam();
    EXPECT_THAT(refusalsOf(row.text, JsonErrors::collect, row.read), ElementsAreArray(row.said));
    EXPECT_THAT(refusalsOf(row.text, JsonErrors::throwFirst, row.read),
                ElementsAre(row.said.front()));
}

INSTANTIATE_TEST_SUITE_P(
    JsonReader, HardJson,
    testing::Values(
        Hard{"AListForAnObject",
             "[\n1]",
             [](const JsonReader& root) {
                 EXPECT_EQ(root.at("a").text(), "");
                 EXPECT_EQ(root.at("b").at("c").numbers().size(), 0u);
                 EXPECT_FALSE(root.isObject());
                 root.refuseUnknown();
             },
             {"a.json: found [1], expected an object"}},
        Hard{"AnEmptyObject",
             "{\n}",
             [](const JsonReader& root) {
                 EXPECT_EQ(root.at("a").text(), "");
                 EXPECT_EQ(root.at("b").number({0, 1}), 0.0);
                 EXPECT_FALSE(root.at("c").boolean());
                 EXPECT_TRUE(root.at("d").list().empty());
                 EXPECT_TRUE(root.at("e").members().empty());
                 EXPECT_EQ(root.at("f").at("g").index(), 0);
                 EXPECT_EQ(root.at("h").word({"x", "y"}), 0u);
                 EXPECT_EQ(root.at("i").filledText("the name of a file"), "");
                 EXPECT_TRUE(root.at("j").numbers().empty());
                 EXPECT_FALSE(root.at("k").columns(2));
                 EXPECT_TRUE(std::isnan(root.at("l").numberOrNull()));
                 root.refuseUnknown();
             },
             {"a.json: a, line 1: found nothing, expected a text",
              "a.json: b, line 1: found nothing, expected a number from 0 to 1",
              "a.json: c, line 1: found nothing, expected true or false",
              "a.json: d, line 1: found nothing, expected a list",
              "a.json: e, line 1: found nothing, expected an object",
              "a.json: f, line 1: found nothing, expected an object",
              "a.json: h, line 1: found nothing, expected x or y",
              "a.json: i, line 1: found nothing, expected the name of a file",
              "a.json: j, line 1: found nothing, expected a list of numbers",
              "a.json: k, line 1: found nothing, expected rows of 2 numbers",
              "a.json: l, line 1: found nothing, expected a number or null"}},
        Hard{"WrongKinds",
             "{\"a\": 1,\n\"b\": \"1\",\n\"c\": 0,\n\"d\": {},\n\"e\": [],\n\"f\": null,\n\"g\": "
             "\"NaN\"}",
             [](const JsonReader& root) {
                 EXPECT_EQ(root.at("a").text(), "");
                 EXPECT_EQ(root.at("b").number(), 0.0);
                 EXPECT_FALSE(root.at("c").booleanOr(true));
                 EXPECT_TRUE(root.at("d").listOrNone("a list of things").empty());
                 EXPECT_TRUE(root.at("e").members("an object of things").empty());
                 EXPECT_EQ(root.at("f").textOr("none"), "");
                 EXPECT_TRUE(std::isnan(root.at("g").numberOrNull()));
             },
             {"a.json: a, line 1: found 1, expected a text",
              "a.json: b, line 2: found \"1\", expected a number",
              "a.json: c, line 3: found 0, expected true or false",
              "a.json: d, line 4: found {}, expected a list of things",
              "a.json: e, line 5: found [], expected an object of things",
              "a.json: f, line 6: found null, expected a text",
              "a.json: g, line 7: found \"NaN\", expected a number or null"}},
        Hard{"NumbersOutOfRange",
             "{\"a\": -1,\n\"b\": 1e300,\n\"c\": 2147483648,\n\"d\": 1.5,\n\"e\": -1,\n"
             "\"f\": 18446744073709551616,\n\"g\": 5}",
             [](const JsonReader& root) {
                 constexpr double unbounded = std::numeric_limits<double>::infinity();
                 root.at("a").number({.least = 0});
                 root.at("b").numberIfAny({-1e9, 1e9});
                 root.at("c").index();
                 root.at("d").indexIfAny("the index of an entry");
                 root.at("e").count(9);
                 root.at("f").count(9);
                 root.at("g").numberOr(0, {-unbounded, 4});
             },
             {"a.json: a, line 1: found -1, expected a number of at least 0",
              "a.json: b, line 2: found 1e+300, expected a number from -1e+09 to 1e+09",
              "a.json: c, line 3: found 2147483648, expected a whole number",
              "a.json: d, line 4: found 1.5, expected the index of an entry",
              "a.json: e, line 5: found -1, expected a whole number from 0 to 9",
              "a.json: f, line 6: found 1.8446744073709552e+19, expected a whole number from 0 to "
              "9",
              "a.json: g, line 7: found 5, expected a number of at most 4"}},
        Hard{"MembersOfLists",
             "{\"a\": [\"x\",\n1,\n\"y\"],\n\"b\": [1,\n2,\nnull,\n-1],\n\"c\": [1,\n\"2\"],\n"
             "\"d\": [[1, 2],\n[3],\n[4, \"5\"]],\n\"e\": [{\"f\": 1},\n7,\n{}]}",
             [](const JsonReader& root) {
                 root.at("a").texts();
                 EXPECT_EQ(root.at("b").numbers("numbers", {0, 1.5}).size(), 4u);
                 root.at("c").numbersOrNull();
                 EXPECT_FALSE(root.at("d").columns(2));
                 for (const JsonReader& one : root.at("e").list()) {
                     if (one.isObject("an object with f")) {
                         one.at("f").number();
                     }
                 }
             },
             {"a.json: a.1, line 2: found 1, expected a text",
              "a.json: b.1, line 5: found 2, expected a number from 0 to 1.5",
              "a.json: b.2, line 6: found null, expected a number from 0 to 1.5",
              "a.json: b.3, line 7: found -1, expected a number from 0 to 1.5",
              "a.json: c.1, line 9: found \"2\", expected a number or null",
              "a.json: d.1, line 11: found [3], expected rows of 2 numbers",
              "a.json: d.2, line 12: found [4,\"5\"], expected rows of 2 numbers",
              "a.json: e.1, line 14: found 7, expected an object with f",
              "a.json: e.2.f, line 15: found nothing, expected a number"}},
        Hard{"NumbersAsAWhole",
             "{\"a\": [1, 2],\n\"b\": [1, 2, \"3\"],\n\"c\": [1, 2, 1e10]}",
             [](const JsonReader& root) {
                 for (const char* key : {"a", "b", "c"}) {
                     EXPECT_FALSE(root.at(key).numbers(3, 1e9, "three numbers"));
                 }
             },
             {"a.json: a, line 1: found [1,2], expected three numbers",
              "a.json: b, line 2: found [1,2,\"3\"], expected three numbers",
              "a.json: c, line 3: found [1,2,10000000000.0], expected three numbers"}},
        Hard{"Words",
             "{\"a\": \"maybe\",\n\"b\": 1,\n\"c\": \"\"}",
             [](const JsonReader& root) {
                 EXPECT_EQ(root.at("a").word({"yes", "no"}), 0u);
                 root.at("b").word({"yes", "no"});
                 root.at("c").filledText("a name");
             },
             {"a.json: a, line 1: found \"maybe\", expected yes or no",
              "a.json: b, line 2: found 1, expected yes or no",
              "a.json: c, line 3: found nothing, expected a name"}},
        Hard{"UnknownKeys",
             "{\"a\": 1,\n\"b\": {\"c\": 1,\n\"d\": 2},\n\"e\": {},\n\"f\": {\n\"g\": 1}}",
             [](const JsonReader& root) {
                 root.at("a").number();
                 root.at("missing").numberOr(1);
                 const JsonReader section = root.section("b");
                 section.at("c").number();
                 root.refuseUnknown();
                 root.section("f").refuseUnknown();
             },
             {"a.json: b.d, line 3: found an unknown key with 2, expected one of c",
              "a.json: e, line 4: found an unknown key with {}, expected one of a, b, missing",
              "a.json: f, line 5: found an unknown key with {\"g\":1}, expected one of a, b, "
              "missing",
              "a.json: f.g, line 6: found an unknown key with 1, expected none here"}},
        Hard{"MembersThatMustNotBe",
             "{\"a\": 1,\n\"b\": 2}",
             [](const JsonReader& root) {
                 root.refuseMember("a", "no a beside b");
                 root.refuseMember("a", "no a beside b");
                 root.refuseMember("c", "no c");
                 EXPECT_FALSE(root.has("a"));
                 EXPECT_EQ(root.at("a").numberOr(5), 5.0);
                 EXPECT_TRUE(root.unknown().contains("b"));
                 EXPECT_FALSE(root.unknown().contains("a"));
                 root.refuseUnknown();
             },
             {"a.json: a, line 1: found 1, expected no a beside b",
              "a.json: b, line 2: found an unknown key with 2, expected none here"}},
        Hard{"WhatItsReaderRefuses",
             "{\"a\": \"x\",\n\"b\": 7,\n\"c\": [1,\n2]}",
             [](const JsonReader& root) {
                 root.at("a").refuse("a name that is free");
                 const JsonReader b = root.at("b");
                 b.text();
                 b.refuse("a colour"); // of what was refused nothing else is said
                 root.at("c").refuse("2 values", "3 values");
                 root.at("c").refuse("2", "at most 1", " at 4 um");
             },
             {"a.json: a, line 1: found \"x\", expected a name that is free",
              "a.json: b, line 2: found 7, expected a text",
              "a.json: c, line 3: found 2 values, expected 3 values",
              "a.json: c at 4 um, line 3: found 2, expected at most 1"}},
        Hard{"WhatOthersCheck",
             "{\"a\": {\n\"b\": 2}}",
             [](const JsonReader& root) {
                 const auto said = [](const char* position) {
                     return [=] { throw InputError({"elsewhere", position, "2", "1"}); };
                 };
                 EXPECT_TRUE(root.at("a").check([] {}));
                 EXPECT_FALSE(root.at("a").check(said("b")));
                 EXPECT_FALSE(root.at("a").check(said("node 2")));
                 EXPECT_FALSE(root.at("a").check(said("")));
                 EXPECT_FALSE(root.check(said("node 3")));
             },
             {"a.json: a.b, line 2: found 2, expected 1",
              "a.json: a, node 2, line 1: found 2, expected 1",
              "a.json: a, line 1: found 2, expected 1",
              "a.json: node 3, line 1: found 2, expected 1"}}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(JsonReader, NamesMembersOfListsInBracketsWhereItsFormSaysSo) {
    const Read read = [](const JsonReader& root) { root.at("a").list()[1].at("b").texts(); };
    const std::string text = "{\"a\": [1,\n{\"b\": [\n2]}]}";
    EXPECT_THAT(refusalsOf(text, JsonErrors::collect, read, bracketed),
                ElementsAre("a.json: a[1].b[0], line 3: found 2, expected a text"));
    EXPECT_THAT(refusalsOf(text, JsonErrors::collect, read),
                ElementsAre("a.json: a.1.b.0, line 3: found 2, expected a text"));
}

TEST(JsonReader, KeepsWhatNobodyAskedForInItsPlace) {
    const JsonReader root = readerOf(
        R"({"a": 1, "new": [1], "b": {"c": 1, "later": 2}, "d": {"c": 1}, "e": {}, "f": 7})");
    for (const char* key : {"b", "d", "e"}) {
        root.section(key).at("c").numberOr(0);
    }
    root.at("a");
    root.section("f"); // no object: nothing in it may be unknown
    EXPECT_EQ(root.unknown(), nlohmann::json::parse(R"({"new": [1], "b": {"later": 2}})"));
}

TEST(JsonReader, KeepsAFileOfNothingButDiagnosticsSmall) {
    std::string text = "{\"a\": [\n0";
    for (int i = 0; i < 20000; ++i) {
        text += ",\n0";
    }
    const auto said = refusalsOf(text + "]}", JsonErrors::collect,
                                 [](const JsonReader& root) { root.at("a").texts(); });
    ASSERT_EQ(said.size(), 101u);
    EXPECT_THAT(said.back(), HasSubstr("more"));
}

} // namespace
} // namespace irsg
