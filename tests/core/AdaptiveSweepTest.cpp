// Sweeps that put their cases where curves bend, against curves in closed form.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/data/AkimaInterpolant.h"
#include "smatcore/data/ResultDifference.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"

namespace smat {
namespace {

using irsg::Quantity;
using testing::Contains;
using testing::HasSubstr;

AnalysisData ran(AnalysisKind kind, test::AnalyticSource& source,
                 const std::vector<std::pair<std::string, std::string>>& settings) {
    Settings overrides;
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    AnalysisData data = AnalysisData::of(Project(), kind, overrides);
    AnalysisGenerator(source, test::sceneWithoutFiles).run(data);
    return data;
}

const std::vector<double>& column(const AnalysisData& data, Quantity quantity) {
    return data.table.find(quantity)->values;
}

/// By straight lines between the rows; a turn closes where `isTurn`.
double between(std::vector<double> x, std::vector<double> y, double at, bool isTurn) {
    if (isTurn) {
        x.push_back(x.front() + 360.0);
        y.push_back(y.front());
    }
    const auto above = std::max<std::ptrdiff_t>(std::ranges::upper_bound(x, at) - x.begin(), 1);
    const auto i =
        static_cast<std::size_t>(std::min(above, static_cast<std::ptrdiff_t>(x.size()) - 1));
    return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

TEST(AdaptiveSweep, MeetsItsErrorAlongARange) {
    test::GreySphere sphere;
    const AnalysisData data = ran(AnalysisKind::range, sphere,
                                  {{"range.from", "100"},
                                   {"range.to", "10000"},
                                   {"range.points", "10"},
                                   {"range.steps", "adaptive"}});
    const auto& range_m = column(data, Quantity::range);
    const auto& irradiance = column(data, Quantity::irradiance);
    EXPECT_TRUE(std::ranges::is_sorted(range_m));
    const double nearest = irradiance.front();
    for (double d = 100.0; d < 10000.0; d *= 1.003) {
        const double truth = nearest * 1e4 / (d * d);
        EXPECT_LE(std::abs(between(range_m, irradiance, d, false) - truth),
                  0.012 * std::max(truth, 0.1 * nearest))
            << d;
    }
    // h^2 / 8 y'' of 1 % of a curve as 1 / d^2 is h = 0.115 d, down to a tenth of the largest.
    EXPECT_LT(range_m.size(), 80u);
    EXPECT_GT(range_m.size(), 15u);
    EXPECT_THAT(data.providedBy, Contains(HasSubstr("adaptive steps: 10 + ")));
    EXPECT_EQ(data.state, AnalysisState::complete);
    EXPECT_EQ(static_cast<std::size_t>(sphere.drawings), range_m.size()) << "each once";
}

double boxAt(double angle_deg) {
    const double u = std::sin(irsg::radians(angle_deg)), v = std::cos(irsg::radians(angle_deg));
    using Box = test::SixSidedBox;
    return (u > 0.0 ? Box::starboard * u : -Box::port * u) +
           (v > 0.0 ? Box::front * v : -Box::tail * v);
}

TEST(AdaptiveSweep, MeetsItsErrorAroundATurnWhoseKinksLieBetweenItsSteps) {
    for (const char* target : {"none", "0.3"}) {
        test::SixSidedBox box;
        const AnalysisData data = ran(AnalysisKind::polar, box,
                                      {{"polar.step", "24"},
                                       {"polar.steps", "adaptive"},
                                       {"render.background", "none"},
                                       {"polar.offset", "0"}});
        const auto& angle_deg = column(data, Quantity::angle);
        EXPECT_TRUE(std::ranges::is_sorted(angle_deg));
        for (double a = 0.05; a < 360.0; a += 0.21) {
            EXPECT_NEAR(between(angle_deg, column(data, Quantity::intensity), a, true), boxAt(a),
                        0.012 * boxAt(a))
                << a << " " << target;
        }
        EXPECT_LT(angle_deg.size(), 120u);
        EXPECT_GT(angle_deg.size(), 30u);
    }
}

TEST(AdaptiveSweep, LeavesStraightCurvesAlone) {
    test::GreySphere sphere;
    const AnalysisData data =
        ran(AnalysisKind::polar, sphere, {{"polar.step", "30"}, {"polar.steps", "adaptive"}});
    EXPECT_EQ(data.table.rowCount(), 12u);
    EXPECT_THAT(data.providedBy, Contains("adaptive steps: 12 + 0 cases, straight lines between "
                                          "which are within 0 % of the curves"));
}

/// Twice as bright from behind an azimuth of 40.3 deg on, up to 200.7.
class Jumping : public test::AnalyticSource {
  public:
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    double intensity_W_sr(const irsg::Vec3& u) const override {
        const double angle_deg = irsg::degrees(std::atan2(u.x, u.y));
        const double turned_deg = angle_deg < 0.0 ? angle_deg + 360.0 : angle_deg;
        return turned_deg > 40.3 && turned_deg < 200.7 ? 2.0 : 1.0;
    }
};

TEST(AdaptiveSweep, ClosesInOnJumpsAndSaysSo) {
    Jumping source;
    const AnalysisData data =
        ran(AnalysisKind::polar, source,
            {{"polar.step", "16"}, {"polar.steps", "adaptive"}, {"render.background", "none"}});
    const auto& angle_deg = column(data, Quantity::angle);
    const auto& intensity = column(data, Quantity::intensity);
    double step_deg = 0.0;
    for (std::size_t i = 1; i < angle_deg.size(); ++i) {
        if (intensity[i] != intensity[i - 1]) {
            step_deg = std::max(step_deg, angle_deg[i] - angle_deg[i - 1]);
        }
    }
    EXPECT_EQ(step_deg, 0.5) << "1/32 of the step";
    EXPECT_THAT(data.providedBy, Contains(HasSubstr("of the least step, over which they jump")));
    EXPECT_LT(angle_deg.size(), 60u);
}

TEST(AdaptiveSweep, KeepsTheGridOfATable) {
    test::SixSidedBox box;
    const AnalysisData data = ran(AnalysisKind::table, box,
                                  {{"table.azimuthStep", "30"},
                                   {"table.elevationStep", "30"},
                                   {"table.elevationFrom", "0"},
                                   {"table.elevationTo", "60"},
                                   {"table.source", "false"},
                                   {"table.steps", "adaptive"},
                                   {"render.background", "none"},
                                   {"render.targetError", "none"}});
    std::vector<double> azimuths, elevations;
    const auto& azimuth = column(data, Quantity::azimuth);
    const auto& elevation = column(data, Quantity::elevation);
    for (std::size_t i = 0; i < azimuth.size(); ++i) {
        if (std::ranges::find(azimuths, azimuth[i]) == azimuths.end()) {
            azimuths.push_back(azimuth[i]);
        }
        if (std::ranges::find(elevations, elevation[i]) == elevations.end()) {
            elevations.push_back(elevation[i]);
        }
    }
    EXPECT_GT(azimuths.size(), 12u);
    EXPECT_GT(elevations.size(), 3u);
    ASSERT_EQ(data.table.rowCount(), azimuths.size() * elevations.size());
    for (std::size_t i = 0; i < azimuth.size(); ++i) {
        EXPECT_EQ(azimuth[i], azimuths[i % azimuths.size()]);
        EXPECT_EQ(elevation[i], elevations[i / azimuths.size()]);
    }
    EXPECT_TRUE(std::ranges::is_sorted(azimuths) && std::ranges::is_sorted(elevations));
}

TEST(AdaptiveSweep, DoesNotRefineAnIcosphere) {
    test::GreySphere sphere;
    EXPECT_THAT(test::refusalOf([&] {
                    ran(AnalysisKind::table, sphere,
                        {{"table.sampling", "icosphere"},
                         {"table.steps", "adaptive"},
                         {"target.altitude", "5000"}});
                }),
                HasSubstr("table.steps"));
}

/// Keeps the cases of a run, of which another is told the first ones.
class Keeping : public CaseStore {
  public:
    void begin(const AnalysisData&, std::size_t) override {}
    const CaseRecord* known(std::size_t i) const override {
        return i < told ? &records.at(i) : nullptr;
    }
    bool isMine(std::size_t) const override { return true; }
    void add(std::size_t i, const CaseRecord& record) override { records[i] = record; }
    std::map<std::size_t, CaseRecord> records;
    std::size_t told = 0;
};

TEST(AdaptiveSweep, GoesOnWithWhatIsKnown) {
    Keeping store;
    AnalysisData runs[2];
    int drawings[2];
    for (int run = 0; run < 2; ++run) {
        test::SixSidedBox box;
        Settings settings;
        settings.set("polar.step", "24");
        settings.set("polar.steps", "adaptive");
        runs[run] = AnalysisData::of(Project(), AnalysisKind::polar, settings);
        AnalysisGenerator(box, test::sceneWithoutFiles).run(runs[run], {}, {}, nullptr, &store);
        drawings[run] = box.drawings;
        store.told = 25; // of the first steps and some of the next
    }
    EXPECT_EQ(drawings[1], drawings[0] - 25);
    EXPECT_EQ(runs[1].table.columns(), runs[0].table.columns());
    EXPECT_EQ(runs[1].state, AnalysisState::complete);
}

/// A constant that is drawn with noise, which its error tells.
class Noisy : public test::GreySphere {
  public:
    irsg::RenderReport measure() override {
        irsg::RenderReport report = GreySphere::measure();
        const double noise = drawings % 2 == 0 ? 1.06 : 0.94;
        report.all.intensity_W_sr *= noise;
        report.all.contrastIntensity_W_sr *= noise;
        report.all.irradiance_W_m2 *= noise;
        irsg::RadiometryErrors errors;
        errors.intensity_W_sr.sampling = 0.12 * report.all.intensity_W_sr;
        errors.contrastIntensity_W_sr.sampling = 0.12 * report.all.contrastIntensity_W_sr;
        errors.irradiance_W_m2.sampling = 0.12 * report.all.irradiance_W_m2;
        report.all.errors = errors;
        return report;
    }
};

TEST(AdaptiveSweep, DoesNotTakeNoiseForBends) {
    Noisy source;
    const std::vector<std::pair<std::string, std::string>> settings = {
        {"polar.step", "30"}, {"polar.steps", "adaptive"}, {"render.errors", "sum"}};
    EXPECT_EQ(ran(AnalysisKind::polar, source, settings).table.rowCount(), 12u);
    auto blind = settings;
    blind.back().second = "off";
    EXPECT_GT(ran(AnalysisKind::polar, source, blind).table.rowCount(), 12u)
        << "as it does where it does not know its errors";
}

/// A smooth body with a lobe, as pipes give one.
class Lobed : public test::AnalyticSource {
  public:
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
    double intensity_W_sr(const irsg::Vec3& u) const override {
        return at(irsg::degrees(std::atan2(u.x, u.y)));
    }
    static double at(double angle_deg) {
        const double c = std::cos(irsg::radians(angle_deg - 160.0));
        return 20.0 + 4.0 * std::sin(irsg::radians(2.0 * angle_deg)) +
               80.0 * std::pow(std::max(c, 0.0), 30.0);
    }
};

TEST(AdaptiveSweep, IsWhatAPlotIsByDefaultAndIsDrawnWithinItsError) {
    Lobed source;
    const AnalysisData data = ran(AnalysisKind::polar, source, {{"render.background", "none"}});
    const auto& angle_deg = column(data, Quantity::angle);
    // Those of 5 degrees and at most as many more.
    EXPECT_GT(angle_deg.size(), 72u);
    EXPECT_LE(angle_deg.size(), 144u);
    const AkimaInterpolant drawn(angle_deg, column(data, Quantity::intensity), 360.0);
    double worst = 0.0;
    for (double a = 0.0; a < 360.0; a += 0.1) {
        worst = std::max(worst, std::abs(drawn.at(a) - Lobed::at(a)) / Lobed::at(a));
    }
    EXPECT_LT(worst, 0.02);
    const std::string& told = data.providedBy.back();
    EXPECT_THAT(told, HasSubstr("adaptive steps: 72 + "));
    EXPECT_LE(100.0 * worst, std::stod(told.substr(told.find("within ") + 7))) << told;
    EXPECT_EQ(data.table.provenance.value("polar.steps"), "adaptive");
    EXPECT_NE(data.table.find("error_intensity"), nullptr) << "with its errors";
    EXPECT_TRUE(isAdaptive(data.table));
}

TEST(AdaptiveSweep, IsNotWhereAStepIsSetOrFixedStepsAre) {
    using Rows = std::vector<std::pair<std::string, std::string>>;
    for (const auto& [kind, settings, rows] :
         {std::tuple{AnalysisKind::polar, Rows{{"polar.step", "5"}}, 72u},
          {AnalysisKind::polar, Rows{{"polar.steps", "fixed"}}, 72u},
          {AnalysisKind::range, Rows{{"range.points", "100"}}, 100u},
          {AnalysisKind::range, Rows{{"range.steps", "fixed"}}, 100u}}) {
        Lobed source;
        const AnalysisData data = ran(kind, source, settings);
        EXPECT_EQ(data.table.rowCount(), rows) << name(kind);
        EXPECT_FALSE(isAdaptive(data.table));
    }
    // A table is handed on with the grid that was asked for.
    EXPECT_EQ(Settings().text("table.steps"), "fixed");
}

TEST(AdaptiveSweep, IsFixedWhereAllCasesMustBeKnownBefore) {
    for (const AnalysisKind kind : {AnalysisKind::polar, AnalysisKind::range}) {
        const Settings fixed = withFixedSteps(kind, Settings());
        EXPECT_EQ(fixed.text(name(kind) + ".steps"), "fixed");
        EXPECT_TRUE(planAnalysis(kind, Project(), fixed).refined.empty());
        EXPECT_THAT(planAnalysis(kind, Project(), Settings()).description,
                    HasSubstr("and more where curves bend"));
    }
    Settings set;
    set.set("polar.step", "7");
    EXPECT_EQ(withFixedSteps(AnalysisKind::polar, set), set);
    EXPECT_EQ(withFixedSteps(AnalysisKind::time, set), set);
    set = Settings();
    set.set("polar.steps", "adaptive");
    EXPECT_EQ(withFixedSteps(AnalysisKind::polar, set), set) << "to be refused, not changed";
}

TEST(AdaptiveSweep, CountsPointsOfARangeInWholeNumbers) {
    test::GreySphere sphere;
    EXPECT_THAT(test::refusalOf([&] {
                    ran(AnalysisKind::range, sphere, {{"range.points", "7.5"}});
                }),
                HasSubstr("range.points"));
    const AnalysisData data = ran(AnalysisKind::range, sphere, {});
    EXPECT_LE(data.table.rowCount(), 100u);
    const auto& range_m = column(data, Quantity::range);
    const auto& irradiance = column(data, Quantity::irradiance);
    const AkimaInterpolant drawn(range_m, irradiance);
    const double nearest = irradiance.front();
    for (double d = 500.0; d < 10000.0; d *= 1.001) {
        const double truth = nearest * 250000.0 / (d * d);
        EXPECT_NEAR(drawn.at(d), truth, 0.01 * std::max(truth, 0.1 * nearest)) << d;
    }
}

} // namespace
} // namespace smat
