#include "smatcore/data/ResultTable.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/support/TextFile.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

ResultTable someTable() {
    ResultTable table;
    table.provenance.add("program", "smat 1");
    table.provenance.add("warning", "one");
    table.provenance.add("warning", "two: with a colon");
    table.add(irsg::Quantity::range);
    table.add(irsg::Quantity::contrastIntensity);
    table.add(irsg::Quantity::pixels);
    table.addRow({100.0, 0.1 + 0.2, 1e-300});
    table.addRow({200.0, -1.0 / 3.0, 12345678.901234567});
    return table;
}

TEST(ResultTable, HasTheHeadersOfTheFormatsPage) {
    EXPECT_EQ(someTable().toCsv(), "# program: smat 1\n"
                                   "# warning: one\n"
                                   "# warning: two: with a colon\n"
                                   "range [m],contrast_intensity [W sr-1],pixels\n"
                                   "100,0.30000000000000004,1e-300\n"
                                   "200,-0.3333333333333333,12345678.901234567\n");
}

TEST(ResultTable, CsvAndJsonReadBackExactly) {
    const test::TemporaryFolder folder;
    for (const char* name : {"table.csv", "table.json"}) {
        const ResultTable table = someTable();
        table.save(folder / name);
        EXPECT_EQ(ResultTable::load(folder / name), table) << name;
    }
}

TEST(ResultTable, NamesOfColumnsAreWrittenAndReadAsTheyAre) {
    const test::TemporaryFolder folder;
    ResultTable table;
    table.add(irsg::Quantity::range);
    for (const char* name : {"ship: grey, new.intensity", "a;b.intensity", "the \"old\" one.pixels",
                             "#1.intensity@mwir", "2,5 m.intensity", "it's.pixels"}) {
        table.add(name, "W sr-1");
    }
    table.add("scale skin [hot]", "");
    table.addRow({100.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0});
    table.addRow({200.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5});
    EXPECT_THAT(table.toCsv(),
                testing::StartsWith("range [m],\"ship: grey, new.intensity [W sr-1]\","));
    for (const char* name : {"table.csv", "table.json"}) {
        table.save(folder / name);
        EXPECT_EQ(ResultTable::load(folder / name), table) << name;
    }
}

TEST(ResultTable, AValueThatIsNotThereIsNan) {
    const test::TemporaryFolder folder;
    for (const char* name : {"nan.csv", "nan.json"}) {
        ResultTable table;
        table.add(irsg::Quantity::apparentTemperature);
        table.addRow({std::numeric_limits<double>::quiet_NaN()});
        table.save(folder / name);
        EXPECT_TRUE(std::isnan(ResultTable::load(folder / name).columns()[0].values[0])) << name;
    }
}

TEST(ResultTable, RowsThatWarnOfSomethingHaveAColumnOfTexts) {
    ResultTable table = someTable();
    EXPECT_TRUE(table.warnings().empty());
    table.insertRow(1, {150.0, 0.0, 1.0}, "at 150 m: \"hull\", 1,5; out\nof the frame");
    EXPECT_EQ(table.toCsv(), "# program: smat 1\n"
                             "# warning: one\n"
                             "# warning: two: with a colon\n"
                             "range [m],contrast_intensity [W sr-1],pixels,warning\n"
                             "100,0.30000000000000004,1e-300,\n"
                             "150,0,1,\"at 150 m: \"\"hull\"\", 1,5; out of the frame\"\n"
                             "200,-0.3333333333333333,12345678.901234567,\n");
    EXPECT_EQ(table.warningOf(0), "");
    EXPECT_THROW(table.warningOf(3), irsg::LogicError);
}

TEST(ResultTable, WarningsOfRowsReadBack) {
    const test::TemporaryFolder folder;
    ResultTable table = someTable();
    table.insertRow(1, {150.0, 0.0, 1.0}, "\"hull\", 1,5; 2 m: out of the frame");
    table.addRow({300.0, 1.0, 2.0}, "µ");
    for (const char* name : {"table.csv", "table.json"}) {
        table.save(folder / name);
        EXPECT_EQ(ResultTable::load(folder / name), table) << name;
    }
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        table.setWarning(row, "all, 3,5");
    }
    table.save(folder / "all.csv");
    EXPECT_EQ(ResultTable::load(folder / "all.csv"), table);
}

TEST(ResultTable, ColumnsKnowTheirAxisTitle) {
    EXPECT_EQ(someTable().columns()[1].axisTitle(), "Contrast intensity (W·sr⁻¹)");
    EXPECT_EQ((ResultColumn{"total_power", "W", {}}.axisTitle()), "Total power (W)");
    EXPECT_EQ((ResultColumn{"error_total", "W", {}}.axisTitle()), "Error of total (W)");
}

TEST(ResultTable, ARowOfAnotherLengthIsOurOwnFault) {
    ResultTable table = someTable();
    EXPECT_THROW(table.addRow({1.0}), irsg::LogicError);
}

struct BadTableRow {
    const char* name;
    const char* file;
    const char* text;
    const char* position;
};

void PrintTo(const BadTableRow& row, std::ostream* out) {
    *out << row.name;
}

class BadTable : public testing::TestWithParam<BadTableRow> {};

TEST_P(BadTable, IsRefusedWithItsPlace) {
    const test::TemporaryFolder folder;
    const auto file = folder / (std::string(GetParam().name) + GetParam().file);
    writeTextFile(file, GetParam().text);
    try {
        ResultTable::load(file);
        FAIL() << "accepted";
    } catch (const irsg::InputError& error) {
        EXPECT_EQ(error.diagnostics().front().file, file.string());
        EXPECT_THAT(error.diagnostics().front().position, testing::HasSubstr(GetParam().position));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tables, BadTable,
    testing::Values(BadTableRow{"Empty", ".csv", "", ""},
                    BadTableRow{"NoHeader", ".csv", "1,2\n3,4\n", "line 1"},
                    BadTableRow{"EmptyName", ".csv", "a,,b\n1,2,3\n", "line 1, column 2"},
                    BadTableRow{"NameTwice", ".csv", "a,a\n1,2\n", "line 1, column 2"},
                    BadTableRow{"Ragged", ".csv", "a,b\n1,2\n3\n", "line 3"},
                    BadTableRow{"Word", ".csv", "a,b\n1,x\n", "line 2, column 2"},
                    BadTableRow{"Infinite", ".csv", "a,b\n1,inf\n", "line 2, column 2"},
                    BadTableRow{"NoJson", ".json", "{", "line 1"},
                    BadTableRow{"OtherJson", ".json", "{}", ""},
                    BadTableRow{"RaggedJson", ".json",
                                R"({"provenance": [], "columns": [
                                   {"name": "a", "unit": "", "values": [1]},
                                   {"name": "b", "unit": "", "values": []}]})",
                                "columns.1.values"},
                    BadTableRow{"RaggedWarnings", ".csv", "a,warning\n1,x\n3\n", "line 3"},
                    BadTableRow{"WarningsOfOtherRows", ".json",
                                R"({"provenance": [], "columns": [
                                   {"name": "a", "unit": "", "values": [1]}],
                                   "warnings": ["x", ""]})",
                                "warnings, line 3"},
                    BadTableRow{"NameTwiceInJson", ".json",
                                R"({"provenance": [], "columns": [
                                   {"name": "a", "unit": "", "values": [1]},
                                   {"name": "a", "unit": "", "values": [1]}]})",
                                "columns.1.name, line 3"},
                    BadTableRow{"NoNumberInJson", ".json",
                                R"({"provenance": [], "columns": [
                                   {"name": "a", "unit": "", "values": [1, "2"]}]})",
                                "columns.0.values.1, line 2"}),
    [](const auto& row) { return row.param.name; });

TEST(Provenance, KeepsLineBreaksOutOfCommentLines) {
    Provenance provenance;
    provenance.add("notes", "a\nb\r\nc");
    EXPECT_EQ(provenance.toCsvLines(), "# notes: a b  c\n");
}

} // namespace
} // namespace smat
