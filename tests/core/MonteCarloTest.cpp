#include "smatcore/analysis/MonteCarlo.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "tests/core/MonteCarloFixture.h"

namespace smat {

using namespace smat::test;
using testing::HasSubstr;

TEST_F(MonteCarloTest, GivesMeanAndSpreadOfAClosedForm) {
    for (const RealisationSequence sequence :
         {RealisationSequence::plain, RealisationSequence::sobol}) {
        data.options.sequence = sequence;
        data.options.samples = 4096;
        run();
        ASSERT_EQ(data.abscissae.size(), 4u);
        EXPECT_EQ(data.realisations(), 4096u);
        EXPECT_EQ(data.analysis.state, AnalysisState::complete);
        const double s1 = sigmaOf(data.scalings[0].distribution);
        const double s2 = sigmaOf(data.scalings[1].distribution);
        const double se = sigmaOf(data.scalings[2].distribution);
        for (std::size_t k = 0; k < 4; ++k) {
            const double cosine = std::cos(irsg::radians(data.abscissae[k]));
            // T1 has 3 + E1 with the mean 4; E1 (T1 - 1) adds the product of the deviations.
            const double variance =
                16.0 * s1 * s1 + std::pow((2.0 + cosine) * s2, 2) + s1 * s1 * se * se;
            const double limit = sequence == RealisationSequence::sobol ? 0.005 : 0.05;
            EXPECT_NEAR(standardDeviationOf(data.values[k]) / std::sqrt(variance), 1.0, limit);
            EXPECT_NEAR(meanOf(data.values[k]), 105.0 + cosine,
                        (sequence == RealisationSequence::sobol ? 0.02 : 4.0) *
                            std::sqrt(variance / 4096.0));
            EXPECT_NEAR(data.nominal[k], 105.0 + cosine, 2e-4);
            EXPECT_GT(data.numericalError[k], 1e-6);
            EXPECT_LT(data.numericalError[k], 4e-4);
        }
    }
}

TEST_F(MonteCarloTest, NumericalErrorIsWhatIsStatedOfTheDrawingOrWhatItsPhasesShow) {
    data.options.samples = 64;
    const std::vector<double> ofPhases = run().numericalError;
    const irsg::ErrorParts large{.sampling = 0.3, .air = 0.4}, small{.sampling = 1e-9};
    source.stated = irsg::RadiometryErrors();
    source.stated->contrastIntensity_W_sr = large;
    run();
    ASSERT_EQ(data.numericalError.size(), ofPhases.size());
    for (std::size_t k = 0; k < ofPhases.size(); ++k) {
        EXPECT_DOUBLE_EQ(data.numericalError[k], 0.5);
        EXPECT_DOUBLE_EQ(data.nominalErrors[k].sum(), 0.5);
    }
    source.stated->contrastIntensity_W_sr = small;
    EXPECT_EQ(run().numericalError, ofPhases);
    source.stated = irsg::RadiometryErrors();
    source.stated->intensity_W_sr = large;
    EXPECT_EQ(run().numericalError, ofPhases) << "of another quantity";
}

TEST_F(MonteCarloTest, AsksForTheScalesThatHaveAnEffectAndSaysWhichHaveNone) {
    run();
    ASSERT_EQ(source.asked.size(), 3u);
    EXPECT_EQ(source.asked[0].index, 1);
    EXPECT_EQ(source.asked[0].least, 0.9);
    EXPECT_EQ(source.asked[1].most, 1.3);
    EXPECT_EQ(source.asked[2].kind, irsg::ScalingKind::emissivity);
    EXPECT_EQ(data.scalings[1].name, "temperature 2 (pipe)");
    EXPECT_THAT(
        data.analysis.warnings,
        testing::IsSupersetOf({HasSubstr("temperature 3 has no effect, it is a user-defined"),
                               HasSubstr("temperature 9 has no effect, it has no entry")}));
}

TEST_F(MonteCarloTest, DrawsInSeveralBandsWhatItDrawsInEachAlone) {
    data.analysis.settings.set("sensor.band", "3-5");
    const MonteCarloData alone = run();
    data.analysis.settings.set("sensor.band", "8-12,3-5");
    source.perBandEdge = 10.0;
    run();
    ASSERT_EQ(data.abscissae.size(), 4u);
    ASSERT_EQ(data.values.size(), 8u);
    EXPECT_THAT(data.bands, testing::ElementsAre("8-12um", "3-5um"));
    const auto column = [](const MonteCarloData& of, const std::string& key) {
        return of.analysis.table.find(key)->values;
    };
    for (std::size_t i = 0; i < 4; ++i) {
        // The closed form gives a band 10 more for every micrometre of its lower end.
        EXPECT_NEAR(column(data, "mean@3-5um")[i], column(alone, "mean")[i] + 30.0, 1e-9);
        EXPECT_NEAR(column(data, "mean@8-12um")[i], column(alone, "mean")[i] + 80.0, 1e-9);
        EXPECT_NEAR(column(data, "p95@8-12um")[i], column(alone, "p95")[i] + 80.0, 1e-9);
        EXPECT_NEAR(column(data, "nominal@8-12um")[i], column(alone, "nominal")[i] + 80.0, 1e-9);
        EXPECT_NEAR(data.ofBand(data.nominal, 1)[i], column(data, "nominal@3-5um")[i], 1e-12);
    }
    EXPECT_EQ(data.analysis.table.find("mean"), nullptr);
}

TEST_F(MonteCarloTest, WritesBandsThatAscendWithTheirProvenance) {
    data.options.percentiles = {2.5, 50.0, 97.5};
    run();
    const ResultTable& table = data.analysis.table;
    std::vector<std::string> keys;
    for (const ResultColumn& column : table.columns()) {
        keys.push_back(column.header());
    }
    EXPECT_THAT(keys, testing::ElementsAre("angle [deg]", "nominal [W sr-1]", "mean [W sr-1]",
                                           "standard_deviation [W sr-1]", "standard_error [W sr-1]",
                                           "minimum [W sr-1]", "p2.5 [W sr-1]", "p50 [W sr-1]",
                                           "p97.5 [W sr-1]", "maximum [W sr-1]",
                                           "error_numerical [W sr-1]", "error_nominal [W sr-1]"));
    for (std::size_t k = 0; k < table.rowCount(); ++k) {
        for (std::size_t c = 6; c < 10; ++c) {
            EXPECT_GT(table.columns()[c].values[k], table.columns()[c - 1].values[k]);
        }
    }
    EXPECT_EQ(table.provenance.value("monte carlo"), "512 draws of the sobol sequence, seed 1");
    EXPECT_EQ(table.provenance.value("quantity"), "contrast_intensity");
    EXPECT_EQ(table.provenance.value("scale"), "temperature 1 (skin): uniform, 0.9 to 1.1");
}

TEST_F(MonteCarloTest, RepeatsWithItsSeedAndDiffersWithAnother) {
    const auto first = run().values;
    EXPECT_EQ(run().values, first);
    data.analysis.settings.set("scaling.seed", "2");
    EXPECT_NE(run().values, first);
}

TEST_F(MonteCarloTest, DrawsWhatLoadingTheDatabaseDraws) {
    data.options.sequence = RealisationSequence::plain;
    run();
    SceneDescription loaded = scene(data.analysis.project, data.analysis.settings);
    applyScalings(data.analysis.project, 1, loaded);
    const irsg::Entity& target = loaded.entities.front();
    EXPECT_EQ(data.values[0][0],
              LinearView::at(1.0, target.temperatureScale.at(1), target.temperatureScale.at(2),
                             target.emissivityScale.at(1)));
    EXPECT_EQ(target.temperatureScale.count(3), 0u);
}

TEST_F(MonteCarloTest, ExportsEachDrawWithItsScalesAndWhatCameOfThem) {
    data.analysis.settings.set("scaling.seed", "7");
    for (const RealisationSequence sequence :
         {RealisationSequence::plain, RealisationSequence::sobol}) {
        data.options.sequence = sequence;
        run();
        const ResultTable table = realisationsTable(data);
        ASSERT_EQ(table.rowCount(), 512u);
        EXPECT_EQ(table.provenance, data.analysis.table.provenance);
        const auto column = [&](const std::string& key) {
            const ResultColumn* found = table.find(key);
            EXPECT_NE(found, nullptr) << key;
            return found == nullptr ? std::vector<double>(512) : found->values;
        };
        const auto t1 = column("scale temperature 1 (skin)");
        const auto t2 = column("scale temperature 2 (pipe)");
        const auto e1 = column("scale emissivity 1 (paint)");
        const auto ahead = column("contrast_intensity at 0 deg");
        const auto aside = column("contrast_intensity at 90 deg");
        EXPECT_EQ(table.find("contrast_intensity at 90 deg")->unit, "W sr-1");
        for (std::size_t k = 0; k < 512; ++k) {
            EXPECT_EQ(column("draw")[k], static_cast<double>(k));
            EXPECT_NEAR(ahead[k], LinearView::at(1.0, t1[k], t2[k], e1[k]), 1e-9);
            EXPECT_NEAR(aside[k], LinearView::at(0.0, t1[k], t2[k], e1[k]), 1e-9);
        }
        EXPECT_NEAR(meanOf(aside), data.analysis.table.find("mean")->values[1], 1e-9);

        // Of a run that was read back: the same scales, the quantities as it keeps them.
        const auto file = ownFolder() / "kept.json";
        saveMonteCarlo(data, file);
        const MonteCarloData kept = loadMonteCarlo(file, realisationsImage(data));
        EXPECT_EQ(kept.analysis.kind, data.analysis.kind);
        const ResultTable again = realisationsTable(kept);
        EXPECT_EQ(again.find("scale temperature 2 (pipe)")->values, t2);
        EXPECT_NEAR(again.find("contrast_intensity at 90 deg")->values[3], aside[3], 1e-4);
    }
    EXPECT_THROW(realisationsTable(MonteCarloData()), irsg::LogicError);
}

TEST_F(MonteCarloTest, StopsAtAStandardErrorAndSaysWhereItDidNotReachIt) {
    data.options.samples = 100000;
    data.options.standardError = 1e-5;
    run();
    EXPECT_TRUE(data.reachedStandardError);
    EXPECT_LT(data.realisations(), 50000u);
    EXPECT_EQ(data.analysis.state, AnalysisState::complete);
    double worst = 0.0;
    for (const Estimate& one : data.statistic) {
        worst = std::max(worst, one.standardError);
    }
    EXPECT_LT(worst, 1e-5 * 106.1);

    data.options.sequence = RealisationSequence::plain;
    data.options.samples = 512;
    run();
    EXPECT_FALSE(data.reachedStandardError);
    EXPECT_THAT(data.analysis.warnings, testing::Contains(HasSubstr("1e-05 was asked for")));
}

TEST_F(MonteCarloTest, KeepsWhatItHasWhenItIsStopped) {
    std::stop_source stop;
    data.options.samples = 100000;
    run(
        [&](const Progress& progress) {
            if (progress.what.find("draw 512") == 0) {
                stop.request_stop();
            }
        },
        stop.get_token());
    EXPECT_EQ(data.analysis.state, AnalysisState::partial);
    EXPECT_EQ(data.realisations(), 768u);
    EXPECT_EQ(data.analysis.table.rowCount(), 4u);
    EXPECT_THAT(data.analysis.warnings, testing::Contains("stopped after 768 of 100000 draws"));

    // While the cases are drawn: those there are, with enough draws to be of use.
    std::stop_source early;
    run(
        [&](const Progress& progress) {
            if (progress.what.find("case 2 of 4") == 0) {
                early.request_stop();
            }
        },
        early.get_token());
    EXPECT_EQ(data.analysis.table.rowCount(), 2u);
    EXPECT_EQ(data.realisations(), 256u);
    EXPECT_THAT(data.analysis.warnings, testing::Contains("stopped after 2 of 4 cases"));
}

TEST_F(MonteCarloTest, RanksTheScalesByTheirShareOfTheVariance) {
    data.options.ranking = true;
    data.options.rankingAt = 180.0; // 3 T1 + (2 - 1) T2 + E1 (T1 - 1)
    for (const RealisationSequence sequence :
         {RealisationSequence::plain, RealisationSequence::sobol}) {
        data.options.sequence = sequence;
        data.options.rankingPairs = 4096;
        run();
        const double s1 = sigmaOf(data.scalings[0].distribution);
        const double s2 = sigmaOf(data.scalings[1].distribution);
        const double se = sigmaOf(data.scalings[2].distribution);
        const double variance = 16.0 * s1 * s1 + s2 * s2 + s1 * s1 * se * se;
        ASSERT_EQ(data.ranking.size(), 3u);
        const double expected[] = {16.0 * s1 * s1 / variance, s2 * s2 / variance, 0.0};
        for (const RankedScaling& one : data.ranking) {
            const double slack = sequence == RealisationSequence::sobol ? 0.01 : 0.06;
            EXPECT_NEAR(one.firstOrder.value, expected[one.scaling], slack) << one.scaling;
            EXPECT_LE(one.firstOrder.low95, one.firstOrder.high95);
            // T1 and E1 act together, T2 alone.
            const double together = one.scaling == 1 ? 0.0 : s1 * s1 * se * se / variance;
            EXPECT_NEAR(one.total.value, expected[one.scaling] + together, slack) << one.scaling;
        }
        EXPECT_EQ(data.ranking[0].scaling, 0u);
        EXPECT_EQ(data.ranking[2].scaling, 2u);
    }
    const ResultTable table = rankingTable(data);
    EXPECT_EQ(table.rowCount(), 3u);
    EXPECT_EQ(table.provenance.value("place 1"), "temperature 1 (skin)");
}

TEST_F(MonteCarloTest, RepeatsSpectraWavelengthByWavelength) {
    const MonteCarloOptions options = data.options;
    data.analysis = AnalysisData::of(data.analysis.project, AnalysisKind::spectrum);
    data.analysis.settings.set("spectrum.resolution", "100");
    data.options = options;
    run();
    EXPECT_EQ(data.abscissaKey, "wavelength");
    EXPECT_EQ(data.unit, "W sr-1 um-1");
    EXPECT_EQ(data.analysis.table.columns().front().key, "wavenumber");
    EXPECT_EQ(data.analysis.table.rowCount(), data.abscissae.size());
    EXPECT_GT(data.abscissae.size(), 5u);
    EXPECT_NEAR(data.abscissae[data.nearest(4.0)], 4.0, 0.1);
}

TEST_F(MonteCarloTest, SavesWhatReadsBack) {
    data.options.ranking = true;
    data.options.rankingPairs = 256;
    run();
    const std::filesystem::path folder = ownFolder();
    EXPECT_THAT(saveMonteCarlo(data, folder / "mc.csv"),
                testing::ElementsAre(folder / "mc.csv", folder / "mc-ranking.csv"));
    EXPECT_EQ(ResultTable::load(folder / "mc.csv"), data.analysis.table);
    EXPECT_EQ(ResultTable::load(folder / "mc-ranking.csv").rowCount(), 3u);
    saveMonteCarlo(data, folder / "mc.json");
    EXPECT_EQ(ResultTable::load(folder / "mc.json"), data.analysis.table);
    EXPECT_THAT(refusalOf([&] { saveMonteCarlo(data, folder / "mc.txt"); }),
                HasSubstr(".csv or .json"));
}

TEST_F(MonteCarloTest, SaysTheCommandThatDoesTheSame) {
    data.options.standardError = 0.001;
    data.options.percentiles = {2.5, 97.5};
    data.options.ranking = true;
    data.options.rankingAt = 90.0;
    data.analysis.settings.set("state.power", "0.25");
    const std::string command = data.equivalentCommand("mc.csv");
    EXPECT_THAT(command, HasSubstr("smat-batch montecarlo PROJECT.smat --kind polar --samples "));
    for (const char* part : {"--sequence sobol", "--standard-error 0.001", "--percentiles 2.5,97.5",
                             "--ranking-at 90", "--set state.power=0.25", "--out mc.csv"}) {
        EXPECT_THAT(command, HasSubstr(part));
    }
    EXPECT_THAT(command, testing::Not(HasSubstr("scaling.")));

    // A named analysis has its own settings, which the file says.
    NamedAnalysis named;
    named.name = "turn";
    named.kind = AnalysisKind::polar;
    named.settings.set("state.power", "0.25");
    data.analysis.project.analyses = {named};
    data.analysis.name = "turn";
    EXPECT_THAT(data.equivalentCommand("mc.csv"), HasSubstr("--analysis turn"));
    EXPECT_THAT(data.equivalentCommand("mc.csv"), testing::Not(HasSubstr("state.power")));
}

TEST_F(MonteCarloTest, RefusesWhatCannotBe) {
    const auto expect = [&](const char* says, auto&& spoil) {
        MonteCarloData kept = data;
        spoil();
        EXPECT_THAT(refusal(), HasSubstr(says));
        data = kept;
    };
    expect("a whole number from 2", [&] { data.options.samples = 1; });
    expect("to 10000000", [&] { data.options.samples = 10'000'001; });
    expect("numbers from 0 to 100", [&] { data.options.percentiles = {50.0, 101.0}; });
    expect("ascending numbers", [&] { data.options.percentiles = {50.0, 5.0}; });
    expect("ascending numbers", [&] { data.options.percentiles = {50.0, 50.0}; });
    expect("standard error", [&] { data.options.standardError = 0.0; });
    expect("from 1 to 64", [&] { data.options.subpixelShifts = 0; });
    expect("from 1 to 64", [&] { data.options.subpixelShifts = 65; });
    expect("from 256 to 1000000", [&] { data.options.rankingPairs = 1'000'001; });
    expect("from 256 to 1000000", [&] { data.options.rankingPairs = 3; });
    expect("an image",
           [&] { data.analysis = AnalysisData::of(data.analysis.project, AnalysisKind::image); });
    expect("fixed, or auto", [&] { data.analysis.settings.set("polar.steps", "adaptive"); });
    expect("at most 50000000 values in all", [&] {
        data.analysis.settings.set("polar.step", "0.01");
        data.options.samples = 10000;
    });
    std::filesystem::remove(irsg::scalingFile(model, irsg::ScalingKind::temperature));
    scale("", "", irsg::ScalingKind::emissivity, {{1, {}}});
    EXPECT_THAT(refusal(), HasSubstr("no scale that varies"));
    std::filesystem::remove(irsg::scalingFile(model, irsg::ScalingKind::emissivity));
    EXPECT_THAT(refusal(), HasSubstr("a scaling file beside the model"));
    scale("", "", irsg::ScalingKind::emissivity, {});
    writtenFile(irsg::scalingFile(model, irsg::ScalingKind::emissivity), "<data>");
    EXPECT_THAT(refusal(), HasSubstr("well-formed"));
}

TEST(SceneScalings, RefuseSobolSequencesOfTooManyScales) {
    std::vector<SceneScaling> many(70);
    for (std::size_t i = 0; i < many.size(); ++i) {
        many[i] = {{0, irsg::ScalingKind::emissivity, static_cast<int>(i), 0.9, 1.1},
                   irsg::Distribution(irsg::DistributionKind::uniform, 0.9, 1.1),
                   ""};
    }
    EXPECT_NO_THROW(ScalingRealisations(many, RealisationSequence::sobol, 1));
    EXPECT_NO_THROW(ScalingRealisations(many, RealisationSequence::plain, 1, true));
    EXPECT_THAT(refusalOf([&] { ScalingRealisations(many, RealisationSequence::sobol, 1, true); }),
                HasSubstr("at most 64 with a ranking"));
}

} // namespace smat
