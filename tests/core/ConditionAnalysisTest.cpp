#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "smatcore/analysis/AnalysisGenerator.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"

namespace smat {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pointwise;

/// What a target sends says what it does: power + 10 Mach + altitude of its origin in m.
class Telltale : public test::AnalyticSource {
  public:
    double intensity_W_sr(const irsg::Vec3&) const override {
        return target().state.power + 10.0 * target().state.mach + target().pose.position_m.z;
    }
    double projectedArea_m2(const irsg::Vec3&) const override { return 1.0; }
};

AnalysisData asked(std::vector<std::pair<std::string, std::string>> settings) {
    Settings overrides;
    for (const auto& [key, text] : settings) {
        overrides.set(key, text);
    }
    return AnalysisData::of(Project(), *analysisKindFromName("condition"), overrides);
}

AnalysisData ran(AnalysisData data, test::AnalyticSource& source) {
    AnalysisGenerator(source, test::sceneWithoutFiles).run(data);
    return data;
}

const std::vector<double>& column(const AnalysisData& data, const std::string& key) {
    const ResultColumn* found = data.table.find(key);
    if (found == nullptr) {
        throw irsg::LogicError("no column " + key);
    }
    return found->values;
}

TEST(ConditionAnalysis, ChangesPowerMachOrAltitudeAndNothingElse) {
    const std::vector<std::pair<std::string, std::string>> base = {
        {"target.altitude", "200"}, {"state.power", "0.5"}, {"state.mach", "0.8"}};
    const auto over = [&](const std::string& what, const std::string& to) {
        auto settings = base;
        settings.insert(settings.end(), {{"condition.over", what},
                                         {"condition.from", "0.1"},
                                         {"condition.to", to},
                                         {"condition.points", "3"}});
        Telltale target;
        return ran(asked(settings), target);
    };
    const AnalysisData power = over("power", "1");
    EXPECT_THAT(column(power, "power"), ElementsAre(0.1, 0.55, 1.0));
    const AnalysisData mach = over("mach", "0.3");
    EXPECT_THAT(column(mach, "mach"), ElementsAre(0.1, 0.2, 0.3));
    const AnalysisData altitude = over("altitude", "1000");
    EXPECT_THAT(column(altitude, "altitude"), ElementsAre(0.1, 500.05, 1000.0));

    const auto differences = [](const AnalysisData& data) {
        const auto& values = column(data, "intensity");
        return std::vector<double>{values[1] - values[0], values[2] - values[1]};
    };
    EXPECT_THAT(differences(power), Pointwise(DoubleNear(1e-9), {0.45, 0.45}));
    EXPECT_THAT(differences(mach), Pointwise(DoubleNear(1e-9), {1.0, 1.0}));
    EXPECT_THAT(differences(altitude), Pointwise(DoubleNear(1e-9), {499.95, 499.95}));
}

TEST(ConditionAnalysis, SpacesItsValuesByEqualRatiosWhereThatIsAsked) {
    Telltale target;
    const AnalysisData data = ran(asked({{"condition.over", "altitude"},
                                         {"condition.from", "10"},
                                         {"condition.to", "10000"},
                                         {"condition.points", "4"},
                                         {"condition.log", "true"}}),
                                  target);
    EXPECT_THAT(column(data, "altitude"),
                Pointwise(DoubleNear(1e-9), {10.0, 100.0, 1000.0, 10000.0}));
    EXPECT_EQ(data.table.provenance.value("condition.log"), "true");
}

TEST(ConditionAnalysis, TakesTheCameraAlongWithTheAltitude) {
    Telltale target;
    ran(asked({{"condition.over", "altitude"},
               {"condition.from", "1000"},
               {"condition.to", "9000"},
               {"condition.points", "2"},
               {"camera.range", "700"},
               {"camera.elevation", "10"}}),
        target);
    ASSERT_EQ(target.positions.size(), 2U);
    EXPECT_NEAR(target.positions[1].z - target.positions[0].z, 8000.0, 1e-6);
    EXPECT_NEAR(target.positions[0].z, 1000.0 + 700.0 * std::sin(irsg::radians(10.0)), 1e-6);
}

TEST(ConditionAnalysis, ReadsItsTableBackAsItsOwnKind) {
    Telltale target;
    const AnalysisData data = ran(asked({}), target);
    EXPECT_EQ(data.table.provenance.value("analysis"), "condition");
    EXPECT_EQ(resultKindFromName(data.table.provenance.value("analysis")), data.kind);
    EXPECT_THAT(data.summary.front().label, HasSubstr("ontrast"));
}

TEST(ConditionAnalysis, RefusesWhatCannotBeByTheKeyOfTheSetting) {
    const auto refusal = [](std::vector<std::pair<std::string, std::string>> settings) {
        const AnalysisData data = asked(std::move(settings));
        return test::refusalOf([&] { planAnalysis(data.kind, data.project, data.settings); });
    };
    EXPECT_THAT(refusal({{"condition.from", "2"}}), HasSubstr("condition.to"));
    EXPECT_THAT(refusal({{"condition.log", "true"}}), HasSubstr("condition.log is true"));
    const std::string tooFast = refusal({{"condition.to", "100"}});
    EXPECT_THAT(tooFast, HasSubstr("condition.to"));
    EXPECT_THAT(tooFast, HasSubstr("state.mach"));
}

} // namespace
} // namespace smat
