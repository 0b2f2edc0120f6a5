#include "smatcore/data/TableAxes.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/analysis/AnalysisData.h"
#include "smatcore/analysis/AnalysisProvenance.h"

namespace smat {
namespace {

using testing::ElementsAre;

/// A table of these columns, the values of each row behind each other.
ResultTable tableOf(const std::vector<std::pair<std::string, std::string>>& columns,
                    const std::vector<std::vector<double>>& rows) {
    ResultTable table;
    for (const auto& [key, unit] : columns) {
        table.add(key, unit);
    }
    for (const std::vector<double>& row : rows) {
        table.addRow(row);
    }
    return table;
}

std::vector<std::string> keysOf(const ResultTable& table) {
    std::vector<std::string> keys;
    for (const ResultColumn* axis : axesOf(table)) {
        keys.push_back(axis->key);
    }
    return keys;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST(TableAxes, AreTheColumnsThatTellRowsApart) {
    using Columns = std::vector<std::pair<std::string, std::string>>;
    const Columns polar = {{"angle", "deg"},
                           {"azimuth", "deg"},
                           {"elevation", "deg"},
                           {"contrast_intensity", "W sr-1"}};
    EXPECT_THAT(keysOf(tableOf(polar, {{0, 0, 5, 1}, {90, 90, 5, 2}})), ElementsAre("angle"))
        << "the azimuth goes with the angle";
    EXPECT_THAT(keysOf(tableOf(polar, {{0, 0, 5, 1}, {90, 90, 5, 2}, {0, 0, 15, 3}})),
                ElementsAre("angle", "elevation"));
    EXPECT_THAT(keysOf(tableOf(polar, {{0, 0, 5, 1}, {0, 0, 5, 2}})), ElementsAre("angle"))
        << "what is measured is no place";
    const Columns table = {{"azimuth", "deg"}, {"elevation", "deg"}, {"range", "m"},
                           {"time", "s"},      {"power", ""},        {"irradiance", "W m-2"}};
    EXPECT_THAT(keysOf(tableOf(table, {{0, 0, 500, 1, 0.5, 1}, {0, 0, 500, 1, 1, 1}})),
                ElementsAre("azimuth", "power"));
    EXPECT_THAT(keysOf(tableOf(table, {{0, 0, 500, 1, nan, 1},
                                       {0, 30, 500, 1, nan, 1},
                                       {0, 0, 900, 1, nan, 1},
                                       {-0.0, 30, 900, 1, nan, 1}})),
                ElementsAre("azimuth", "elevation", "range"));
    EXPECT_THAT(keysOf(tableOf({{"wavenumber", "cm-1"}, {"wavelength", "um"}}, {{2000, 5}})),
                ElementsAre("wavelength"));
    EXPECT_THAT(keysOf(tableOf(polar, {})), ElementsAre("angle"));
    EXPECT_TRUE(axesOf(ResultTable()).empty());
}

TEST(TableAxes, APlaceNamesItsAxesWhereThereAreSeveral) {
    const ResultTable one = tableOf({{"range", "m"}}, {{500}, {1234.5678}});
    EXPECT_EQ(rowPlace(axesOf(one), 1), "1234.57 m");
    const ResultTable two =
        tableOf({{"azimuth", "deg"}, {"power", ""}}, {{0, 0.5}, {0, 1}, {90, 1}});
    EXPECT_EQ(rowPlace(axesOf(two), 2), "azimuth 90 deg, power 1");
}

TEST(TableAxes, SummariesNameAllAxesOfTheirExtremes) {
    AnalysisData data;
    data.kind = AnalysisKind::table;
    data.table = tableOf({{"azimuth", "deg"},
                          {"elevation", "deg"},
                          {"range", "m"},
                          {"contrast_intensity", "W sr-1"},
                          {"irradiance", "W m-2"}},
                         {{0, 0, 500, 1, 9},
                          {90, 0, 500, 2, 3},
                          {0, 30, 500, 7, 4},
                          {90, 30, 500, -5, 5},
                          {0, 30, 900, 3, 1}});
    summarise(data);
    std::vector<std::string> labels;
    labels.reserve(data.summary.size());
    for (const SummaryItem& item : data.summary) {
        labels.push_back(item.label);
    }
    EXPECT_THAT(
        labels,
        ElementsAre("Highest contrast intensity at azimuth 0 deg, elevation 30 deg, range 500 m",
                    "Lowest contrast intensity at azimuth 90 deg, elevation 30 deg, range 500 m",
                    "Highest irradiance at azimuth 0 deg, elevation 0 deg, range 500 m",
                    "Lowest irradiance at azimuth 0 deg, elevation 30 deg, range 900 m"));
}

} // namespace smat
