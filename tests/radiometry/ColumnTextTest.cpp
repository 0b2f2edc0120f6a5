#include "irsg/core/ColumnText.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "tests/support/Refusal.h"

namespace irsg {
namespace {

using testing::HasSubstr;

TEST(ColumnText, FindsSeparatorAndDecimalSignFromTheWholeText) {
    const struct {
        const char* name;
        std::string text;
        char separator, decimal;
    } rows[] = {
        {"nothing", "", ',', '.'},
        {"words alone", "a;b\nc;d\n", ',', '.'},
        {"commas", "1,2\n3,4\n", ',', '.'},
        {"points", "1.5,2.5\n", ',', '.'},
        {"semicolons", "1.5;2\n", ';', '.'},
        {"whole numbers between semicolons", "1;2\n3;4\n", ';', '.'},
        {"a comma in the last row alone", "a;b\n1;2\n3;4\n5;6,5\n", ';', ','},
        {"vertical bars", "1.5|2\n", '|', '.'},
        {"vertical bars and commas", "a|b\n1|2,5\n", '|', ','},
        {"semicolons and commas", "12,500;12,750\n", ';', ','},
        {"tabs", "1\t2\n", '\t', '.'},
        {"tabs and commas", "12,500\t12,750\n", '\t', ','},
        {"an empty cell between tabs", "1\t\t2\n3\t4\t5\n", '\t', '.'},
        {"blanks", "  1 2\n 3  4\n", ' ', '.'},
        {"blanks and commas", "3 0,5\n4,5 1\n", ' ', ','},
        {"commas with blanks behind them", "1, 2, 3\n4, 5, 6\n", ',', '.'},
        {"rows of one and two numbers", "1\n2,5\n3,25\n", ',', '.'},
        {"one column of decimal commas alone", "1,5\n2,5\n", ',', '.'},
        {"quoted decimal commas", "\"1,5\",\"2,25\"\n", ',', ','},
        {"quoted numbers", "\"1.5\",\"2.25\"\n", ',', '.'},
        {"exponents with D", "1.5D+01 2.5d-1\n", ' ', '.'},
        {"comments do not count", "# a;b;c\n# 1,5;2\n1,2\n", ',', '.'},
        {"words do not count", "one;two;three\n1,2\n", ',', '.'},
        {"the stated separator", "sep=;\n1,2;3\n", ';', ','},
        {"numbers that are none", "nan;1,5\ninf;2\n", ';', ','},
        {"blanks between thousands", "1 234,5;2\n12 345;6\n", ';', ','},
        {"blanks between thousands of some rows", "1 234,5\t2\n345,5\t6\n", '\t', ','},
        {"blanks that do not break", "1\u00a0234,5 2\n12\u00a0345 6,5\n", ' ', ','},
        {"blanks between thousands in quotes", "\"1 234,5\",\"2,5\"\n", ',', ','},
        {"columns of three digits between blanks", "1 234\n2 345\n", ' ', '.'},
        {"pairs between commas", "100 200, 300 400\n", ',', '.'},
    };
    for (const auto& row : rows) {
        EXPECT_EQ(columnDialectOf(row.text, "f"), (ColumnDialect{row.separator, row.decimal}))
            << row.name;
    }
}

TEST(ColumnText, RefusesWhatCanBeReadInTwoWaysByLineAndValue) {
    const struct {
        const char* name;
        std::string text;
        const char* says;
    } rows[] = {
        {"decimal commas before commas", "a,b\n1,5, 2,5\n3,5, 4,5\n",
         "f: line 2: found '1,5, 2,5'"},
        {"thousands in quotes", "\"1,234\",\"5,678\"\n", "f: line 1: found '1,234'"},
        {"thousands between tabs, or four columns", "a\tb\n1 234\t5 678\n2 345\t6 789\n",
         "f: line 2: found '1 234'"},
    };
    for (const auto& row : rows) {
        SCOPED_TRACE(row.name);
        const std::string message = smat::test::refusalOf([&] { columnDialectOf(row.text, "f"); });
        EXPECT_THAT(message, HasSubstr(row.says));
        EXPECT_THAT(message, HasSubstr("in two ways"));
    }
    EXPECT_THAT(smat::test::refusalOf([] { columnDialectOf("0,05,1,20\n0,95,1,40\n", "f"); }),
                HasSubstr("in two ways"));
    EXPECT_NO_THROW(columnDialectOf("2020,01,05\n2020,01,06\n", "f")); // dates
}

TEST(ColumnText, TakesNumbersOfOneDialectAlone) {
    const struct {
        const char* text;
        char decimal;
        const char* plain; ///< null: no number
    } rows[] = {{"1", '.', "1"},
                {"1,5", ',', "1.5"},
                {"1.5", ',', nullptr},
                {"1,5", '.', nullptr},
                {"-1.5e3", '.', "-1.5e3"},
                {"1,5D+01", ',', "1.5e01"},
                {"2.5d-1", '.', "2.5e-1"},
                {"1.2-103", '.', "1.2e-103"},
                {"12-103", '.', nullptr},
                {"3-5", '.', nullptr},
                {"+4", '.', "+4"},
                {"4.", '.', "4."},
                {"4,", ',', nullptr},
                {".5", '.', ".5"},
                {",5", ',', ".5"},
                {"nan", '.', "nan"},
                {"-Inf", ',', "-Inf"},
                {"1,234,5", ',', nullptr},
                {"1.234,5", ',', nullptr},
                {"0x10", '.', nullptr},
                {"", '.', nullptr},
                {"-", '.', nullptr},
                {"1e", '.', nullptr},
                {"2020-01-02", '.', nullptr},
                {"\u22121,5", ',', "-1.5"},
                {"\u2212", '.', nullptr}};
    for (const auto& row : rows) {
        const auto plain = plainNumber(row.text, row.decimal);
        EXPECT_EQ(plain.value_or("none"), row.plain == nullptr ? "none" : row.plain) << row.text;
    }
}

TEST(ColumnText, TakesDigitsInGroupsOfThree) {
    const ColumnDialect german{';', ','}, english{'\t', '.'}, plain{',', '.'}, blanks{' ', '.'};
    const struct {
        const char* text;
        const char* number; ///< null: none
        ColumnDialect dialect;
        bool isQuoted = false;
    } rows[] = {
        {"1 234,5", "1234.5", german},
        {"-12 345 678", "-12345678", german},
        {"\u22121\u202f234,5e2", "-1234.5e2", german},
        {"1\u00a0234", "1234", german},
        {"1'234.5", "1234.5", english},
        {"1\u2019234\u2019567", "1234567", plain},
        {"1.234.567,5", "1234567.5", german},
        {"1,234.5", "1234.5", english},
        {"1 234.5", nullptr, plain},
        {"1 234.5", "1234.5", plain, true},
        {"1 234.5", nullptr, blanks},
        {"1.234", nullptr, german}, // or one and a bit
        {"1,234", nullptr, english},
        {"12 34", nullptr, german},
        {"1234 567", nullptr, german},
        {"1 234'567", nullptr, german},
        {"1 2345", nullptr, german},
        {"1  234", nullptr, german},
        {"1,5 234", nullptr, german},
        {" 234", "234", german},
        {"' 234", nullptr, german},
    };
    for (const auto& row : rows) {
        const ColumnCell cell{row.text, {}, row.isQuoted};
        EXPECT_EQ(cellNumber(cell, row.dialect).value_or("none"),
                  row.number == nullptr ? "none" : row.number)
            << row.text;
    }
}

TEST(ColumnText, KeepsUnitsInBracketsWithTheirNameBetweenBlanks) {
    std::vector<ColumnCell> cells;
    ASSERT_TRUE(splitColumns(" wavelength [um]  sky radiance (W m-2) \"a b\" c", ' ', cells));
    std::vector<std::string> texts;
    for (const ColumnCell& cell : cells) {
        texts.push_back(textOf(cell));
    }
    EXPECT_EQ(texts,
              (std::vector<std::string>{"wavelength [um]", "sky", "radiance (W m-2)", "a b", "c"}));
    EXPECT_FALSE(splitColumns("1;\"2", ';', cells));
}

} // namespace
} // namespace irsg
