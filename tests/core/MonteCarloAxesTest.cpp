#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/analysis/MonteCarloFile.h"
#include "tests/core/MonteCarloFixture.h"

namespace smat {
namespace {

using namespace smat::test;

class MonteCarloAxes : public MonteCarloTest {};

/// A sweep over several axes, by the settings that make it one.
struct SeveralAxes {
    const char* name;
    AnalysisKind kind;
    std::vector<std::pair<const char*, const char*>> settings;
    std::vector<std::string> axes;
    std::size_t rows;
};

std::vector<SeveralAxes> severalAxes() {
    return {{"polar of elevations",
             AnalysisKind::polar,
             {{"polar.step", "90"},
              {"polar.offset", "0"},
              {"polar.offsetTo", "30"},
              {"polar.offsetStep", "15"}},
             {"angle", "elevation"},
             12},
            {"table",
             AnalysisKind::table,
             {{"table.azimuthStep", "90"},
              {"table.elevationStep", "30"},
              {"table.elevationFrom", "-30"},
              {"table.elevationTo", "30"}},
             {"azimuth", "elevation"},
             12},
            {"table of ranges and powers",
             AnalysisKind::table,
             {{"table.azimuthStep", "180"},
              {"table.elevationStep", "30"},
              {"table.elevationFrom", "0"},
              {"table.elevationTo", "30"},
              {"table.ranges", "500,1000"},
              {"table.powers", "0.5,1"}},
             {"azimuth", "elevation", "range", "power"},
             16},
            {"icosphere",
             AnalysisKind::table,
             {{"table.sampling", "icosphere"},
              {"table.subdivisions", "0"},
              {"table.elevationFrom", "-90"}},
             {"azimuth", "elevation"},
             12}};
}

TEST_F(MonteCarloAxes, EachRowOfSeveralAxesHasThemAllAndItsOwnColumnOfDraws) {
    const Project project = data.analysis.project;
    for (const SeveralAxes& sweep : severalAxes()) {
        SCOPED_TRACE(sweep.name);
        data.analysis = AnalysisData::of(project, sweep.kind);
        for (const auto& [key, value] : sweep.settings) {
            data.analysis.settings.set(key, value);
        }
        run();
        const ResultTable& table = data.analysis.table;
        ASSERT_EQ(table.rowCount(), sweep.rows);
        for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
            EXPECT_EQ(table.columns()[i].key, sweep.axes[i]);
        }
        EXPECT_EQ(table.columns()[sweep.axes.size()].key, "nominal");
        const auto azimuth_deg = table.columns().front().values,
                   elevation_deg = table.find("elevation")->values;
        const ResultTable draws = realisationsTable(data);
        std::set<std::string> keys, places;
        for (const ResultColumn& column : draws.columns()) {
            keys.insert(column.key);
            EXPECT_EQ(column.key.find(','), std::string::npos) << column.key;
        }
        EXPECT_EQ(keys.size(), draws.columns().size()) << "no two columns have one name";
        EXPECT_EQ(draws.columns().size(), 1 + data.scalings.size() + sweep.rows);
        const auto scales = [&](std::size_t i) { return draws.columns()[1 + i].values[17]; };
        for (std::size_t row = 0; row < sweep.rows; ++row) {
            places.insert(data.rowPlace(row));
            const double cosine = std::cos(irsg::radians(azimuth_deg[row])) *
                                  std::cos(irsg::radians(elevation_deg[row]));
            EXPECT_NEAR(table.find("nominal")->values[row], LinearView::at(cosine, 1, 1, 1), 1e-3);
            EXPECT_NEAR(draws.columns()[1 + data.scalings.size() + row].values[17],
                        LinearView::at(cosine, scales(0), scales(1), scales(2)), 1e-9);
        }
        EXPECT_EQ(places.size(), sweep.rows);
        bool isNamed = false;
        for (const SummaryItem& item : data.analysis.summary) {
            isNamed = isNamed || (item.label.find("Largest standard deviation at " +
                                                  sweep.axes.front() + " ") == 0 &&
                                  item.label.find(", elevation ") != std::string::npos);
        }
        EXPECT_TRUE(isNamed);

        const auto file = ownFolder() / "axes.json";
        saveMonteCarlo(data, file);
        const MonteCarloData kept = loadMonteCarlo(file, realisationsImage(data));
        EXPECT_EQ(kept.otherAxes, data.otherAxes);
        EXPECT_EQ(kept.abscissae, data.abscissae);
    }
}

TEST_F(MonteCarloAxes, ARankingAtAnAbscissaIsOfAllRowsThere) {
    data.analysis = AnalysisData::of(data.analysis.project, AnalysisKind::polar);
    for (const auto& [key, value] : {std::pair{"polar.step", "90"},
                                     {"polar.offset", "0"},
                                     {"polar.offsetTo", "60"},
                                     {"polar.offsetStep", "60"}}) {
        data.analysis.settings.set(key, value);
    }
    data.options.ranking = true;
    data.options.rankingPairs = 4096;
    data.options.rankingAt = 180.0;
    run();
    const double s1 = sigmaOf(data.scalings[0].distribution);
    const double s2 = sigmaOf(data.scalings[1].distribution);
    const double se = sigmaOf(data.scalings[2].distribution);
    // 3 T1 + (2 - cos e) T2 + E1 (T1 - 1) at e of 0 and 60 deg, each by its variance.
    double ofT2 = 0.0, all = 0.0;
    for (const double cosine : {1.0, 0.5}) {
        const double part = (2.0 - cosine) * (2.0 - cosine) * s2 * s2;
        ofT2 += part;
        all += 16.0 * s1 * s1 + part + s1 * s1 * se * se;
    }
    const auto found = std::ranges::find(data.ranking, std::size_t{1}, &RankedScaling::scaling);
    ASSERT_NE(found, data.ranking.end());
    EXPECT_NEAR(found->firstOrder.value, ofT2 / all, 0.01);
    EXPECT_EQ(data.rankedPlace(), "angle 180 deg, 2 rows");
    EXPECT_EQ(rankingTable(data).provenance.value("ranked at"), "angle 180 deg, 2 rows");
    EXPECT_EQ(data.rowsAlong(5), (std::vector<std::size_t>{4, 5, 6, 7}));
}

} // namespace
} // namespace smat
