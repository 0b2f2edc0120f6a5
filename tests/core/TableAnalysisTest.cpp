#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/data/ColumnName.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"

namespace smat {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

AnalysisPlan planned(std::vector<std::pair<std::string, std::string>> settings) {
    Settings overrides;
    overrides.set("target.altitude", "5000");
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    const AnalysisData data = AnalysisData::of(Project(), AnalysisKind::table, overrides);
    return planAnalysis(data.kind, data.project, data.settings);
}

std::string refused(std::vector<std::pair<std::string, std::string>> settings) {
    return test::refusalOf([&] { planned(std::move(settings)); });
}

TEST(TableAnalysis, IsAGridOfAzimuthsAndElevationsByDefault) {
    const AnalysisPlan plan = planned({});
    ASSERT_EQ(plan.cases.size(), 72u * 37u);
    EXPECT_EQ(plan.cases[0].shownElevation_deg, -90.0);
    EXPECT_EQ(plan.cases[1].shownAzimuth_deg, 5.0);
    EXPECT_EQ(plan.cases[72].shownElevation_deg, -85.0);
    EXPECT_EQ(plan.cases.back().shownAzimuth_deg, 355.0);
    EXPECT_EQ(plan.cases.back().shownElevation_deg, 90.0);
    EXPECT_FALSE(plan.isAlongRange);
    EXPECT_TRUE(plan.withSource);
}

TEST(TableAnalysis, BeginsAtTheFirstStepAboveTheGround) {
    const auto first_deg = [](const char* altitude_m, const char* step_deg) {
        return planned({{"target.altitude", altitude_m},
                        {"table.ranges", "100,1000"},
                        {"table.elevationStep", step_deg}})
            .cases.front()
            .shownElevation_deg;
    };
    EXPECT_EQ(first_deg("1000", "5"), -90.0);
    EXPECT_EQ(first_deg("500", "5"), -30.0);
    EXPECT_EQ(first_deg("100", "5"), -5.0); // 5.74 deg are below the ground
    EXPECT_EQ(first_deg("0", "5"), 0.0);
}

TEST(TableAnalysis, TakesEveryListByEveryOtherWithStatesInside) {
    const AnalysisPlan plan = planned({{"table.azimuthStep", "180"},
                                       {"table.elevationFrom", "0"},
                                       {"table.elevationTo", "7"},
                                       {"table.elevationStep", "5"},
                                       {"table.ranges", "2000,1000"},
                                       {"table.machs", "0.2,0.5,0.8"},
                                       {"table.altitudes", "4000,8000"}});
    ASSERT_EQ(plan.cases.size(), 2u * 3u * 2u * 3u * 2u);
    std::set<double> elevations_deg;
    for (const AnalysisCase& one : plan.cases) {
        elevations_deg.insert(one.shownElevation_deg);
    }
    EXPECT_THAT(elevations_deg, ElementsAre(0.0, 5.0, 7.0)) << "with the last";
    EXPECT_EQ(plan.cases[1].value(irsg::Quantity::mach), 0.5);
    EXPECT_EQ(plan.cases[3].range_m, 1000.0);
    EXPECT_EQ(plan.cases[6].shownAzimuth_deg, 180.0);
    EXPECT_EQ(plan.cases.back().value(irsg::Quantity::altitude), 8000.0);
    EXPECT_TRUE(plan.isAlongRange);
    EXPECT_EQ(plan.place(plan.cases[4]),
              "azimuth 0 deg, elevation 0 deg, range 1000 m, mach 0.5, altitude 4000 m");
}

TEST(TableAnalysis, OfAnIcosphereHasNeighboursOfNearlyOneDistance) {
    for (const auto& [subdivisions, corners] : {std::pair{"0", 12u}, {"1", 42u}, {"3", 642u}}) {
        const AnalysisPlan plan =
            planned({{"table.sampling", "icosphere"}, {"table.subdivisions", subdivisions}});
        ASSERT_EQ(plan.cases.size(), corners);
        std::vector<irsg::Vec3> directions;
        irsg::Vec3 sum;
        for (const AnalysisCase& one : plan.cases) {
            directions.push_back(one.viewpoint({}).backward);
            sum = sum + directions.back();
        }
        EXPECT_LT(irsg::length(sum), 1e-7 * corners);
        double least = 10.0, most = 0.0; // of the distance to the nearest other
        for (const irsg::Vec3& one : directions) {
            double nearest = 10.0;
            for (const irsg::Vec3& other : directions) {
                if (&one != &other) {
                    nearest = std::min(nearest, irsg::length(one - other));
                }
            }
            least = std::min(least, nearest);
            most = std::max(most, nearest);
        }
        EXPECT_LT(most / least, 1.25);
        EXPECT_GT(least, 2.0 / std::sqrt(corners));
    }
}

TEST(TableAnalysis, RefusesByTheKeyOfTheSetting) {
    EXPECT_THAT(refused({{"table.elevationFrom", "10"}, {"table.elevationTo", "5"}}),
                HasSubstr("table.elevationTo"));
    EXPECT_THAT(refused({{"table.azimuthStep", "0.01"}, {"table.elevationStep", "0.01"}}),
                HasSubstr("1000000 cases"));
    const std::string below = refused(
        {{"target.altitude", "500"}, {"table.ranges", "100,1000"}, {"table.elevationFrom", "-31"}});
    EXPECT_THAT(below, HasSubstr("table.elevationFrom"));
    EXPECT_THAT(below, HasSubstr("at least -30 deg"));
    EXPECT_THAT(refused({{"table.sampling", "icosphere"},
                         {"table.subdivisions", "0"},
                         {"table.elevationFrom", "0.1"},
                         {"table.elevationTo", "0.2"}}),
                HasSubstr("icosphere"));
    EXPECT_THAT(refused({{"table.machs", "0.5,0.5"}}), HasSubstr("each once"));
}

/// Sends 1 W/sr through air and 3 without, in every band.
class Hazy : public test::AnalyticSource {
  public:
    double intensity_W_sr(const irsg::Vec3&) const override { return target().state.mach; }
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) override {
        std::vector<irsg::RenderReport> made = AnalyticSource::reports(outputs);
        if (outputs.hasSource()) {
            for (std::size_t k = 0; k < outputs.bands().size(); ++k) {
                made.push_back(made[k]);
                made.back().all.intensity_W_sr *= 3.0;
            }
        }
        return made;
    }
};

TEST(TableAnalysis, SaysApparentAndSourceIntensityOfEachBandAndState) {
    Settings overrides;
    for (const auto& [key, text] : {std::pair{"table.azimuthStep", "90"},
                                    {"table.elevationFrom", "0"},
                                    {"table.elevationTo", "0"},
                                    {"table.machs", "0.5,2"},
                                    {"sensor.band", "3-5,8-12"}}) {
        overrides.set(key, text);
    }
    AnalysisData data = AnalysisData::of(Project(), AnalysisKind::table, overrides);
    Hazy target;
    AnalysisGenerator(target, test::sceneWithoutFiles).run(data);
    ASSERT_EQ(data.table.rowCount(), 8u);
    std::vector<std::string> keys;
    for (const ResultColumn& column : data.table.columns()) {
        if (ColumnName::of(column.key).prefix.empty()) {
            keys.push_back(column.key);
        }
    }
    EXPECT_EQ(data.table.columns().size(), keys.size() + 8u) << "with their errors";
    EXPECT_THAT(keys, ElementsAre("azimuth", "elevation", "range", "time", "power", "mach",
                                  "altitude", "intensity@3-5um", "contrast_intensity@3-5um",
                                  "irradiance@3-5um", "source_intensity@3-5um", "pixels@3-5um",
                                  "intensity@8-12um", "contrast_intensity@8-12um",
                                  "irradiance@8-12um", "source_intensity@8-12um", "pixels@8-12um"));
    for (std::size_t i = 0; i < 8; ++i) {
        const double mach = i % 2 == 0 ? 0.5 : 2.0;
        EXPECT_EQ(data.table.find("mach")->values[i], mach);
        EXPECT_EQ(data.table.find("intensity@8-12um")->values[i], mach);
        EXPECT_EQ(data.table.find("source_intensity@8-12um")->values[i], 3.0 * mach);
    }
}

} // namespace
} // namespace smat
