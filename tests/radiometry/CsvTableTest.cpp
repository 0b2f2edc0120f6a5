#include "irsg/core/CsvTable.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace irsg;
using testing::HasSubstr;

namespace {

std::vector<std::string> texts(const CsvRow& row) {
    std::vector<std::string> result;
    for (const CsvCell& cell : row.cells) {
        result.push_back(cell.text);
    }
    return result;
}

using Texts = std::vector<std::string>;

} // namespace

TEST(CsvTable, KeepsThePlaceOfEveryCell) {
    const CsvTable table = CsvTable::parse("# unit: W\n\na, b ,c\n1,2,3\n", "f.csv");
    ASSERT_EQ(table.rows().size(), 2u);
    EXPECT_EQ(table.file(), "f.csv");
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"a", "b", "c"}));
    EXPECT_EQ(table.rows()[0].line, 3);
    EXPECT_EQ(table.rows()[1].cells[2].line, 4);
    EXPECT_EQ(table.rows()[1].cells[2].column, 3);
}

TEST(CsvTable, KeepsCommentsWithKeyValueAndLine) {
    const CsvTable table =
        CsvTable::parse("#just text\nx,y\n#  sky temperature : 250 : K \n", "f.csv");
    ASSERT_EQ(table.comments().size(), 2u);
    EXPECT_EQ(table.comments()[0].key, "");
    EXPECT_EQ(table.comments()[0].value, "just text");
    const CsvComment* comment = table.comment("sky temperature");
    ASSERT_NE(comment, nullptr);
    EXPECT_EQ(comment->value, "250 : K");
    EXPECT_EQ(comment->line, 3);
    EXPECT_EQ(table.comment("air"), nullptr);
}

TEST(CsvTable, ReadsEveryLineEndingAndByteOrderMarkAlike) {
    const auto rows = [](const char* text) {
        std::vector<Texts> all;
        const CsvTable table = CsvTable::parse(text, "f.csv");
        for (const CsvRow& row : table.rows()) {
            all.push_back(texts(row));
            all.back().push_back(std::to_string(row.line));
        }
        return all;
    };
    const std::vector<Texts> expected = {{"a", "b", "1"}, {"1", "2", "3"}};
    EXPECT_EQ(rows("a,b\n\n1,2"), expected);
    EXPECT_EQ(rows("a,b\r\n\r\n1,2\r\n"), expected);
    EXPECT_EQ(rows("a,b\r\r1,2\r"), expected);
    EXPECT_EQ(rows("\xEF\xBB\xBF"
                   "a,b\n , \n1,2\n"),
              expected);
}

TEST(CsvTable, TakesQuotedCellsWithCommasAndQuotesInThem) {
    const CsvTable table = CsvTable::parse("\"a, b\",\"say \"\"hi\"\"\" ,c\n", "f.csv");
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"a, b", "say \"hi\"", "c"}));
}

TEST(CsvTable, KeepsEmptyCellsAndRowsOfDifferentLength) {
    const CsvTable table = CsvTable::parse(",x,,y\n1\n", "f.csv");
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"", "x", "", "y"}));
    EXPECT_EQ(texts(table.rows()[1]), (Texts{"1"}));
    EXPECT_TRUE(CsvTable::parse("", "f.csv").rows().empty());
}

TEST(CsvTable, LeavesOutWhatSpreadsheetsAddToTheWidth) {
    const CsvTable table =
        CsvTable::parse("# name: haze,,\n\"# note: a, b\",,\nx,y,\n1,2,\n3,,\n", "f.csv");
    EXPECT_EQ(table.comment("name")->value, "haze");
    EXPECT_EQ(table.comment("note")->value, "a, b");
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"x", "y"}));
    EXPECT_EQ(texts(table.rows()[2]), (Texts{"3", ""}));
    // A comment of our own keeps its comma.
    EXPECT_EQ(CsvTable::parse("# note: a,\nx,y,z\n1,2,3\n", "f.csv").comment("note")->value, "a,");
}

TEST(CsvTable, BeginsWithTheRowOfNamesUnderItsHeadLines) {
    const CsvTable table =
        CsvTable::parse("Instrument: invented\nSerial,1234\nx,y\n1,2\n3,4\n", "f.csv");
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"x", "y"}));
    EXPECT_EQ(table.headLines().size(), 2u);
    // A first row of numbers that is wrong is no head line.
    EXPECT_EQ(CsvTable::parse("x,y\nabc,2\n3,4\n", "f.csv").rows().size(), 3u);
    EXPECT_EQ(CsvTable::parse("title\nx,y\n1,2\n", "f.csv", CsvHead::all).rows().size(), 3u);
}

TEST(CsvTable, FindsNamesAboveRulesAndRowsThatLackTheirLastCells) {
    const CsvTable table =
        CsvTable::parse("-----\n a b c\n m K g/kg\n=====\n 1 2\n 1 2 3\n 4 5 6\n", "f.txt");
    ASSERT_EQ(table.rows().size(), 4U);
    EXPECT_EQ(texts(table.rows()[0]), (Texts{"a [m]", "b [K]", "c [g/kg]"}));
    EXPECT_EQ(texts(table.rows()[1]), (Texts{"1", "2"}));
    EXPECT_EQ(texts(table.rows()[2]), (Texts{"1", "2", "3"}));
}

TEST(CsvTable, TakesARowForUnitsOfWhichMostAreKnown) {
    const auto names = [](const std::string& text) {
        const CsvTable table = CsvTable::parse(text, "f.csv");
        std::vector<std::string> all;
        for (const CsvCell& cell : table.rows().front().cells) {
            all.push_back(cell.text);
        }
        return all;
    };
    EXPECT_EQ(names("a,b,c\nm,K,g/kg\n1,2,3\n4,5,6\n"),
              (std::vector<std::string>{"a [m]", "b [K]", "c [g/kg]"}));
    EXPECT_EQ(names("a,b,c\nm,cold,warm\n1,2,3\n4,5,6\n"),
              (std::vector<std::string>{"m", "cold", "warm"}));
    EXPECT_EQ(names("s,K,c\nm,K,g/kg\n1,2,3\n4,5,6\n"),
              (std::vector<std::string>{"m", "K", "g/kg"}));
}

TEST(CsvTable, PutsARowOfUnitsBehindTheNames) {
    for (const char* units : {"um,%", "(um),(%)", "[um],[%]"}) {
        const CsvTable table =
            CsvTable::parse("wavelength,response\n" + std::string(units) + "\n3,4\n", "f.csv");
        EXPECT_EQ(texts(table.rows()[0]), (Texts{"wavelength [um]", "response [%]"})) << units;
        EXPECT_EQ(table.rows().size(), 2u);
    }
}

TEST(CsvTable, ShowsADecimalCommaAsTheFileHasIt) {
    const CsvTable table = CsvTable::parse("x;y\n1,5;-2,5D+01\n", "f.csv");
    std::vector<Diagnostic> diagnostics;
    EXPECT_EQ(table.number(table.rows()[1].cells[1], diagnostics), -25.0);
    EXPECT_EQ(table.diagnostic(table.rows()[1].cells[0], "less").message(),
              "f.csv: line 2, column 1: found '1,5', expected less");
}

TEST(CsvTable, TurnsABadCellIntoAnDiagnostic) {
    const CsvTable table = CsvTable::parse("x\n1,abc\n2,\n", "f.csv");
    std::vector<Diagnostic> diagnostics;
    EXPECT_EQ(table.number(table.rows()[1].cells[0], diagnostics), 1.0);
    EXPECT_FALSE(table.number(table.rows()[1].cells[1], diagnostics));
    EXPECT_FALSE(table.number(table.rows()[2].cells[1], diagnostics, "a temperature in K"));
    ASSERT_EQ(diagnostics.size(), 2u);
    EXPECT_EQ(diagnostics[0].message(),
              "f.csv: line 2, column 2: found 'abc', expected a finite number");
    EXPECT_EQ(diagnostics[1].message(),
              "f.csv: line 3, column 2: found nothing, expected a temperature in K");
}

TEST(CsvTable, ShowsLongAndUnprintableTextInOneShortLine) {
    std::string text(200, 'a');
    text += ",b\x01\x7f"
            "c\n";
    const CsvTable table = CsvTable::parse(text, "f.csv");
    EXPECT_THAT(table.diagnostic(table.rows()[0].cells[0], "").value,
                testing::MatchesRegex("'a+\\.\\.\\.'"));
    EXPECT_EQ(table.diagnostic(table.rows()[0].cells[0], "").value.size(), 65u);
    EXPECT_EQ(table.diagnostic(table.rows()[0].cells[1], "").value, "'b??c'");
}

TEST(CsvTable, RefusesWhatIsNotAReadableTextTable) {
    const std::filesystem::path folder = smat::test::ownFolder();
    EXPECT_THAT(smat::test::refusalOf([&] { CsvTable::read(folder / "absent.csv"); }),
                HasSubstr("absent.csv: found no such file"));
    EXPECT_THAT(smat::test::refusalOf([&] { CsvTable::read(folder); }),
                HasSubstr("found a folder"));
    EXPECT_THAT(smat::test::refusalOf([] { CsvTable::parse(std::string("ab\0c", 4), "f.csv"); }),
                HasSubstr("f.csv: byte 2: found a NUL byte"));
    EXPECT_THAT(smat::test::refusalOf(
                    [] { CsvTable::parse("MATLAB 5.0 MAT-file" + std::string(3, '\0'), "f.csv"); }),
                HasSubstr("f.csv: byte 19: found a MATLAB file, expected plain text"));
    EXPECT_THAT(smat::test::refusalOf([] { CsvTable::parse("a,\"b\n\"c,d\nx,\"y\"\n", "f.csv"); }),
                testing::AllOf(HasSubstr("f.csv: line 1: found 'a,\"b', expected a closing quote"),
                               HasSubstr("f.csv: line 2"), testing::Not(HasSubstr("line 3"))));
}

TEST(CsvTable, ReadsAFileAsItReadsText) {
    const std::filesystem::path file =
        smat::test::writtenFile(smat::test::ownFolder() / "table.csv", "a,b\r\n1,2\r\n");
    const CsvTable table = CsvTable::read(file);
    EXPECT_EQ(table.file(), file.string());
    EXPECT_EQ(texts(table.rows()[1]), (Texts{"1", "2"}));
}

TEST(ParseNumber, TakesFiniteNumbersWhole) {
    EXPECT_EQ(parseNumber("1"), 1.0);
    EXPECT_EQ(parseNumber(" -2.5e3\t"), -2500.0);
    EXPECT_EQ(parseNumber("+4"), 4.0);
    EXPECT_EQ(parseNumber(".5"), 0.5);
    EXPECT_EQ(parseNumber("7.76E-05"), 7.76e-5);
    EXPECT_EQ(parseNumber("1e-400"), 0.0);
    EXPECT_EQ(parseNumber("4.9e-324"), 4.9406564584124654e-324);
}

TEST(ParseNumber, RefusesEverythingElse) {
    for (const char* text :
         {"",     " ",   "-",   "+",    "+-1",      "--1",   "abc",    "1x", "1 2",    "1,5",
          "0x10", "nan", "inf", "-inf", "infinity", "1e400", "-1e400", "1e", "1e5000", "1;2"}) {
        EXPECT_FALSE(parseNumber(text)) << "'" << text << "'";
    }
}
