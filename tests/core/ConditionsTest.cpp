#include "smatcore/analysis/Conditions.h"

#include <map>

#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/analysis/DetectionRequest.h"
#include "smatcore/analysis/SettingWords.h"

namespace smat {
namespace {

ResultTable polar(const std::vector<std::pair<std::string, std::string>>& provenance) {
    ResultTable table;
    table.provenance.add("analysis", "polar");
    for (const auto& [key, value] : provenance) {
        table.provenance.add(key, value);
    }
    using irsg::Quantity;
    for (const Quantity quantity : {Quantity::angle, Quantity::azimuth, Quantity::elevation,
                                    Quantity::yaw, Quantity::contrastIntensity}) {
        table.add(quantity);
    }
    for (int angle = 0; angle < 360; angle += 90) {
        table.addRow({1.0 * angle, 1.0 * angle, 12.0, 0.0, 5.0});
    }
    return table;
}

TEST(ConditionsTest, OfAViewSayBandRangeAspectAltitudeAirAndTime) {
    Settings settings;
    settings.set("sensor.band", "8-12");
    settings.set("camera.range", 900.0);
    settings.set("camera.azimuth", 60.0);
    settings.set("camera.elevation", 12.0);
    settings.set("target.altitude", 1500.0);
    EXPECT_EQ(lineOf(conditionsOf(settings)),
              "8-12 µm · range 900 m · azimuth 60° · elevation 12° · altitude 1500 m · vacuum · "
              "time 0 s");
    settings.set("sensor.band", "3-5,8-12");
    settings.set("environment.atmospheres", "../air/midlatitude-summer.xml");
    const std::string line = lineOf(conditionsOf(settings));
    EXPECT_EQ(line.find("3-5 µm, 8-12 µm · "), 0U) << line;
    EXPECT_NE(line.find(" · midlatitude-summer · "), std::string::npos) << line;
}

TEST(ConditionsTest, OfAResultLeaveOutWhatItVaries) {
    const ResultTable table = polar(
        {{"sensor.band", "8-12 um"}, {"camera.range", "2000 m"}, {"camera.azimuth", "33 deg"}});
    EXPECT_EQ(lineOf(conditionsOf(table)),
              "8-12 µm · range 2000 m · elevation 12° · altitude 1000 m · vacuum · time 0 s");
    EXPECT_TRUE(conditionsOf(ResultTable()).empty()) << "nothing is known of it";
}

TEST(ConditionsTest, OfASearchForRangesHaveItsSensorInPlaceOfBandAndRange) {
    ResultTable table = polar({{"sensor.band", "8-12 um"},
                               {"camera.range", "2000 m"},
                               {"detection.sensor", "a seeker"},
                               {"detection.criterion", "point"},
                               {"detection.snr", "5"}});
    for (auto& [key, value] : table.provenance.entries) {
        if (key == "analysis") {
            value = name(detectionKind());
        }
    }
    EXPECT_EQ(lineOf(conditionsOf(table)),
              "a seeker · signal to noise ratio 5 · elevation 12° · altitude 1000 m · vacuum · "
              "time 0 s");
    table.provenance.add("detection.cycles", "3");
    EXPECT_EQ(lineOf(conditionsOf(table)).find("a seeker · point, 3 cycles · "), 0U);
}

TEST(ConditionsTest, OfAToolThatAsksTheAirAloneAreThatAir) {
    ResultTable profile;
    profile.provenance.add("analysis", name(AnalysisKind::temperatureProfile));
    EXPECT_TRUE(conditionsOf(profile).empty()) << "no range, no band and no vacuum";
    profile.provenance.add("answered by", "ambient temperature: AtmosphereSmart (sea.xml)");
    EXPECT_EQ(lineOf(conditionsOf(profile)), "AtmosphereSmart (sea.xml)");
    ResultTable radiative;
    radiative.provenance.add("analysis", name(AnalysisKind::radiative));
    radiative.provenance.add("atmosphere", "AtmosphereSmart (sea.xml)");
    EXPECT_EQ(lineOf(conditionsOf(radiative)), "AtmosphereSmart (sea.xml)");
    ResultTable gas;
    gas.provenance.add("analysis", name(AnalysisKind::gas));
    gas.provenance.add("band", "4.2-4.5 um");
    EXPECT_EQ(lineOf(conditionsOf(gas)), "4.2-4.5 µm");
    gas.provenance.add("atmosphere", "haze");
    gas.provenance.add("gas_altitude [m]", "20");
    gas.provenance.add("range [m]", "1500");
    EXPECT_EQ(lineOf(conditionsOf(gas)), "4.2-4.5 µm · range 1500 m · altitude 20 m · haze");
}

TEST(ConditionsTest, OfSeveralResultsAreThoseTheyShare) {
    const ResultTable a = polar({{"sensor.band", "8-12 um"}}),
                      b = polar({{"sensor.band", "3-5 um"}});
    const std::string line = lineOf(sharedConditions({&a, &b}));
    EXPECT_EQ(line.find("µm"), std::string::npos) << line;
    EXPECT_EQ(line.find("range "), 0U) << line;
}

AnalysisData result(const ResultTable& table, const irsg::SignatureDatabase& database) {
    AnalysisData data;
    data.table = table;
    data.databases = {std::make_shared<const irsg::SignatureDatabase>(database)};
    return data;
}

irsg::SignatureDatabase painted(double emissivity) {
    irsg::SignatureDatabase database;
    database.materials[3].name = "grey paint";
    // As an editor leaves it: a value at each node.
    database.materials[3].emissivity = irsg::Spectrum({3.0, 12.0}, {emissivity, emissivity});
    database.temperatures[5].name = "exhaust pipes";
    database.temperatures[5].terms.base_K = 700.0;
    return database;
}

TEST(DistinguishingNames, SayWhatDiffers) {
    const ResultTable plain = polar({});
    using Names = std::vector<std::string>;
    const auto namesOf = [](const AnalysisData& a, const AnalysisData& b) {
        return distinguishingNames({&a, &b});
    };
    const AnalysisData grey = result(plain, painted(0.9)), bright = result(plain, painted(0.3));
    EXPECT_EQ(namesOf(grey, bright), (Names{"ε 0.9", "ε 0.3"}));

    const AnalysisData mwir = result(polar({{"sensor.band", "3-5 um"}}), painted(0.9));
    const AnalysisData lwir = result(polar({{"sensor.band", "8-12 um"}}), painted(0.9));
    EXPECT_EQ(namesOf(lwir, mwir), (Names{"8-12 µm", "3-5 µm"}));

    // Of two entries each has its name.
    irsg::SignatureDatabase both = painted(0.3);
    both.temperatures[5].terms.base_K = 800.0;
    const auto names = namesOf(grey, result(plain, both));
    EXPECT_EQ(names[0], "exhaust pipes T0 700 K, grey paint ε 0.9");
    EXPECT_EQ(names[1], "exhaust pipes T0 800 K, grey paint ε 0.3");

    irsg::SignatureDatabase without = painted(0.9);
    without.materials.erase(3);
    EXPECT_EQ(namesOf(grey, result(plain, without)),
              (Names{"with grey paint", "without grey paint"}));
}

TEST(DistinguishingNames, SayNothingWhereNothingIsKnownToDiffer) {
    const AnalysisData one = result(polar({}), painted(0.9));
    EXPECT_EQ(distinguishingNames({&one, &one}), (std::vector<std::string>{"", ""}));
    EXPECT_EQ(distinguishingNames({&one}), (std::vector<std::string>{""}));
    AnalysisData unknown;
    unknown.table = polar({});
    EXPECT_EQ(distinguishingNames({&one, &unknown}), (std::vector<std::string>{"", ""}));

    // Monte Carlo is told apart by what it repeats, where that differs.
    AnalysisData mwir = result(polar({{"sensor.band", "3-5 um"}}), painted(0.9));
    AnalysisData lwir = result(polar({{"sensor.band", "8-12 um"}}), painted(0.9));
    mwir.kind = lwir.kind = AnalysisKind::monteCarlo;
    EXPECT_EQ(distinguishingNames({&mwir, &lwir}), (std::vector<std::string>{"3-5 µm", "8-12 µm"}));
    for (auto& [key, value] : lwir.table.provenance.entries) {
        if (key == "analysis") {
            value = "range";
        }
    }
    EXPECT_EQ(distinguishingNames({&mwir, &lwir}), (std::vector<std::string>{"", ""}));
}

/// Angles and elevations of the cases of a polar plot.
std::vector<std::pair<double, double>> cases(const std::map<std::string, std::string>& values) {
    Settings settings;
    for (const auto& [key, value] : values) {
        settings.set(key, value);
    }
    const AnalysisPlan plan = planAnalysis(AnalysisKind::polar, Project(), settings);
    std::vector<std::pair<double, double>> list;
    for (const AnalysisCase& one : plan.cases) {
        list.emplace_back(one.coordinate, one.shownElevation_deg);
    }
    return list;
}

TEST(PolarPlan, CoversSectorsWithBothEndsAndTurnsWithOne) {
    using Cases = std::vector<std::pair<double, double>>;
    EXPECT_EQ(cases({{"polar.step", "90"}}), (Cases{{0, 0}, {90, 0}, {180, 0}, {270, 0}}));
    EXPECT_EQ(cases({{"polar.step", "20"}, {"polar.from", "30"}, {"polar.to", "75"}}),
              (Cases{{30, 0}, {50, 0}, {70, 0}, {75, 0}}));
    EXPECT_EQ(cases({{"polar.step", "20"}, {"polar.from", "30"}, {"polar.to", "70"}}),
              (Cases{{30, 0}, {50, 0}, {70, 0}}));
}

TEST(PolarPlan, GoesRoundAtSeveralElevations) {
    using Cases = std::vector<std::pair<double, double>>;
    EXPECT_EQ(cases({{"polar.step", "180"},
                     {"polar.offset", "-10"},
                     {"polar.offsetTo", "10"},
                     {"polar.offsetStep", "10"}}),
              (Cases{{0, -10}, {180, -10}, {0, 0}, {180, 0}, {0, 10}, {180, 10}}));
    EXPECT_THROW(cases({{"polar.type", "model-yaw"}, {"polar.offsetTo", "10"}}), irsg::InputError);
    EXPECT_THROW(cases({{"polar.offset", "20"}, {"polar.offsetTo", "10"}}), irsg::InputError);
    EXPECT_THROW(cases({{"polar.from", "90"}, {"polar.to", "90"}}), irsg::InputError);
}

TEST(IgnoredSettings, AreThoseThatDoNotChangeThePlan) {
    Settings settings;
    for (const AnalysisKind kind : allAnalysisKinds()) {
        if (kind->ignored == nullptr) {
            continue;
        }
        for (const std::string& key : kind->ignored(settings)) {
            EXPECT_NE(findSetting(key), nullptr) << key;
            EXPECT_FALSE(settingWords(settings, key).empty());
        }
    }
    Settings other;
    other.set("camera.elevation", 33.0);
    const AnalysisKind polarKind = AnalysisKind::polar;
    const AnalysisCase a = planAnalysis(polarKind, Project(), settings).cases.front();
    const AnalysisCase b = planAnalysis(polarKind, Project(), other).cases.front();
    EXPECT_EQ(a.elevation_rad, b.elevation_rad);
}

} // namespace
} // namespace smat
