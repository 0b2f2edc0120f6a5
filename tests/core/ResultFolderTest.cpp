#include "smatcore/results/ResultFolder.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "irsg/core/Errors.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/signature/ScalingXml.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/analysis/ResultFile.h"
#include "smatcore/project/ProjectFile.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/support/TextFile.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Origin = ResultDocument::Origin;

/// A sphere that answers scales, too: its intensity is that of its temperature's scale.
class ScaledSphere : public test::GreySphere {
  public:
    class View : public irsg::ScaledView {
      public:
        std::size_t size() const override { return 1; }
        void evaluate(std::span<const double> scales, irsg::ScaledValues& values) const override {
            values.intensity = values.contrastIntensity = values.irradiance = {scales[0]};
        }
    };
    std::unique_ptr<const irsg::ScaledView> scaledView(const irsg::Outputs&) override {
        return std::make_unique<View>();
    }
};

class ResultFolderTest : public testing::Test {
  protected:
    ResultFolderTest() {
        project.file = folder / "ship.smat";
        project.title = "A ship";
        project.models = {{.file = "ship.flt", .database = "ship.sigdb"}};
        project.settings.set("sensor.width", "8");
        project.settings.set("sensor.height", "6");
        project.settings.set("polar.step", "90");
        project.settings.set("range.points",
                             "100"); // errors that its source knows not compare as none
    }
    ResultDocument ran(AnalysisKind kind, const std::string& name) {
        AnalysisData data = AnalysisData::of(project, kind);
        data.name = name;
        data.settings.set("camera.range", "750");
        test::GreySphere sphere;
        AnalysisGenerator(sphere, test::sceneWithoutFiles).run(data);
        return {.title = "1  " + name,
                .notes = "Two lines\nof notes, with ε.",
                .madeAt = "2026-11-23T07:02:11",
                .data = std::make_shared<const AnalysisData>(std::move(data))};
    }
    ResultDocument ranMonteCarlo() {
        writeTextFile(irsg::scalingFile(folder / "ship.flt", irsg::ScalingKind::temperature),
                      irsg::scalingXml({{1, {{irsg::DistributionKind::normal, 0.7, 1.3}, ""}}}));
        auto run = std::make_shared<MonteCarloData>();
        run->analysis = AnalysisData::of(project, AnalysisKind::polar);
        run->options.samples = 300;
        run->options.ranking = true;
        run->options.rankingPairs = 256;
        run->options.percentiles = {10.0, 90.0};
        run->options.statistic = *statisticFromName("p90");
        ScaledSphere sphere;
        MonteCarlo(sphere, [](const Project& asked, const Settings& settings) {
            SceneDescription scene = test::sceneWithoutFiles(asked, settings);
            auto database = std::make_shared<irsg::SignatureDatabase>();
            database->temperatures[1].name = "skin";
            scene.entities.front().database = database;
            return scene;
        }).run(*run);
        ResultDocument document;
        document.title = "draws";
        document.data = {run, &run->analysis};
        document.monteCarlo = run;
        return document;
    }
    static void expectSame(const ResultDocument& read, const ResultDocument& saved) {
        EXPECT_EQ(read.title, saved.title);
        EXPECT_EQ(read.notes, saved.notes);
        EXPECT_EQ(read.madeAt, saved.madeAt);
        EXPECT_EQ(read.origin, saved.origin);
        EXPECT_EQ(read.data->name, saved.data->name);
        EXPECT_EQ(read.data->kind, saved.data->kind);
        EXPECT_EQ(read.data->state, saved.data->state);
        EXPECT_EQ(read.data->table, saved.data->table);
        EXPECT_EQ(read.data->elapsed_s, saved.data->elapsed_s);
        ASSERT_EQ(read.data->summary.size(), saved.data->summary.size());
        for (std::size_t i = 0; i < read.data->summary.size(); ++i) {
            EXPECT_EQ(read.data->summary[i].label, saved.data->summary[i].label);
            EXPECT_EQ(read.data->summary[i].value, saved.data->summary[i].value);
        }
        // What was asked can be asked again.
        EXPECT_EQ(read.data->project, saved.data->project);
        for (const SettingInfo& setting : settingTable()) {
            EXPECT_EQ(read.data->settings.text(setting.key), saved.data->settings.text(setting.key))
                << setting.key;
        }
    }
    std::string refusal(const std::string& stem) {
        return test::refusalOf([&] { results().load(stem); });
    }
    ResultFolder results() const { return ResultFolder(project.file); }

    const test::TemporaryFolder folder;
    Project project;
};

TEST_F(ResultFolderTest, GivesSweepsBackWithWhatWasAsked) {
    for (const AnalysisKind kind :
         {AnalysisKind::polar, AnalysisKind::range, AnalysisKind::time, AnalysisKind::spectrum}) {
        // A name that is no name of a file, too.
        const ResultDocument saved = ran(kind, "nose / tail: ε 0.9");
        const std::string stem = results().save(saved);
        expectSame(results().load(stem), saved);
    }
    EXPECT_THAT(results().documents(),
                ElementsAre("001-polar", "002-range", "003-time", "004-spectrum"));
    EXPECT_EQ(results().path(), folder / "ship.results");
}

TEST_F(ResultFolderTest, GivesTheSignaturesBackAsTheyWere) {
    ResultDocument saved = ran(AnalysisKind::polar, "front");
    AnalysisData data = *saved.data;
    auto database = std::make_shared<irsg::SignatureDatabase>();
    database->materials[3].name = "grey paint";
    database->materials[3].emissivity = irsg::Spectrum::constant(0.3);
    data.databases = {database, nullptr};
    saved.data = std::make_shared<const AnalysisData>(std::move(data));
    const ResultDocument loaded = results().load(results().save(saved));
    ASSERT_EQ(loaded.data->databases.size(), 2U);
    EXPECT_EQ(*loaded.data->databases[0], *database);
    EXPECT_EQ(loaded.data->databases[1], nullptr);
}

TEST_F(ResultFolderTest, GivesImagesBackBitForBit) {
    const ResultDocument saved = ran(AnalysisKind::image, "picture");
    const ResultDocument read = results().load(results().save(saved));
    expectSame(read, saved);
    EXPECT_EQ(read.data->image.channels, saved.data->image.channels);
}

TEST_F(ResultFolderTest, GivesMonteCarloRunsBackWithTheirDraws) {
    const ResultDocument saved = ranMonteCarlo();
    const ResultDocument read = results().load(results().save(saved));
    expectSame(read, saved);
    ASSERT_NE(read.monteCarlo, nullptr);
    EXPECT_EQ(read.data.get(), &read.monteCarlo->analysis);
    const MonteCarloData &was = *saved.monteCarlo, &is = *read.monteCarlo;
    EXPECT_EQ(is.realisations(), 300u);
    ASSERT_EQ(is.values.size(), was.values.size());
    for (std::size_t place = 0; place < is.values.size(); ++place) {
        for (std::size_t draw = 0; draw < is.realisations(); ++draw) {
            EXPECT_EQ(is.values[place][draw], static_cast<float>(was.values[place][draw]));
        }
    }
    EXPECT_EQ(is.abscissae, was.abscissae);
    EXPECT_EQ(is.nominal, was.nominal);
    EXPECT_EQ(is.numericalError, was.numericalError);
    EXPECT_EQ(is.bands, was.bands);
    ASSERT_EQ(is.scalings.size(), 1u);
    EXPECT_EQ(is.scalings[0].name, was.scalings[0].name);
    EXPECT_EQ(is.scalings[0].distribution, was.scalings[0].distribution);
    ASSERT_EQ(is.ranking.size(), was.ranking.size());
    EXPECT_EQ(is.ranking[0].firstOrder.low95, was.ranking[0].firstOrder.low95);
    EXPECT_EQ(is.statistic[0].high95, was.statistic[0].high95);
    // The same command again.
    EXPECT_EQ(is.equivalentCommand("o.csv"), was.equivalentCommand("o.csv"));
}

TEST_F(ResultFolderTest, KeepsWhereAnOpenedFileIsNotItsNumbers) {
    ResultDocument saved = ran(AnalysisKind::polar, "round");
    saved.origin = Origin::file;
    saved.file = folder / "round.csv";
    saved.data->table.save(saved.file);
    const std::string stem = results().save(saved);
    EXPECT_EQ(results().load(stem).data->table, saved.data->table);
    EXPECT_FALSE(std::filesystem::exists(results().path() / (stem + ".json")));
    std::filesystem::remove(saved.file);
    EXPECT_THAT(refusal(stem), HasSubstr("round.csv"));
}

TEST_F(ResultFolderTest, KeepsAnOpenedFileOfMonteCarloAsThat) {
    ResultDocument saved = ranMonteCarlo();
    const std::filesystem::path file = folder / "draws.csv";
    saveMonteCarlo(*saved.monteCarlo, file);
    saved.monteCarlo = nullptr;
    saved.data = std::make_shared<const AnalysisData>(loadResult(file));
    saved.origin = Origin::file;
    saved.file = file;
    EXPECT_EQ(saved.data->kind, AnalysisKind::monteCarlo);
    EXPECT_EQ(results().save(saved), "001-montecarlo");
    EXPECT_EQ(results().load("001-montecarlo").data->kind, AnalysisKind::monteCarlo);
}

TEST_F(ResultFolderTest, MovesWithTheProject) {
    const ResultDocument saved = ran(AnalysisKind::polar, "round");
    const std::string stem = results().save(saved);
    const auto elsewhere = folder / "elsewhere";
    std::filesystem::create_directory(elsewhere);
    std::filesystem::rename(results().path(), elsewhere / "ship.results");
    const ResultDocument read = ResultFolder(elsewhere / "ship.smat").load(stem);
    EXPECT_EQ(read.data->project.file, elsewhere / "ship.smat");
    EXPECT_EQ(read.data->project.models.front().file, "ship.flt"); // beside it, as it was
    EXPECT_TRUE(results().documents().empty());
}

TEST_F(ResultFolderTest, IsBesideAProjectThatIsNamedWithoutItsFolder) {
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    std::string refused, name;
    try {
        const ResultFolder beside("ship.smat");
        name = beside.load(beside.save(ran(AnalysisKind::polar, "round"))).data->name;
    } catch (const std::exception& error) {
        refused = error.what();
    }
    std::filesystem::current_path(before);
    EXPECT_EQ(refused, "");
    EXPECT_EQ(name, "round");
    EXPECT_TRUE(std::filesystem::exists(folder / "ship.results/001-polar.result"));
}

TEST_F(ResultFolderTest, WordsNameTheVersionThatWroteThem) {
    const std::string stem = results().save(ran(AnalysisKind::polar, "round"));
    const auto words = nlohmann::json::parse(readTextFile(results().path() / (stem + ".result")));
    EXPECT_EQ(words.at("program"), irsg::programWithVersion());
}

TEST_F(ResultFolderTest, ChangesWordsAloneAndNeverWritesOverAnother) {
    ResultDocument document = ran(AnalysisKind::polar, "round");
    const std::string stem = results().save(document);
    const std::string numbers = readTextFile(results().path() / (stem + ".json"));
    document.title = "cold morning";
    document.notes = "";
    results().saveWords(document, stem);
    EXPECT_EQ(results().load(stem).title, "cold morning");
    EXPECT_EQ(results().load(stem).notes, "");
    EXPECT_EQ(readTextFile(results().path() / (stem + ".json")), numbers);
    EXPECT_EQ(results().save(document), "002-polar");
    results().remove(stem);
    EXPECT_FALSE(results().holds(stem));
    // A number that was taken once may be free again, but none that is in use is taken.
    EXPECT_EQ(results().save(document), "003-polar");
    EXPECT_THAT(results().documents(), ElementsAre("002-polar", "003-polar"));
}

TEST_F(ResultFolderTest, OneDamagedResultTakesNoOtherWithIt) {
    for (int i = 0; i < 4; ++i) {
        results().save(ran(AnalysisKind::polar, "round"));
    }
    const auto file = [&](const char* name) { return results().path() / name; };
    std::filesystem::remove(file("001-polar.json"));
    writeTextFile(file("002-polar.result"), "{\"version\": 1, \"origin\": \"moon\"}");
    std::string newer = readTextFile(file("003-polar.result"));
    newer.replace(newer.find("\"version\": 1"), 12, "\"version\": 9");
    writeTextFile(file("003-polar.result"), newer);
    EXPECT_THAT(refusal("001-polar"), HasSubstr("001-polar.json"));
    EXPECT_THAT(refusal("002-polar"), HasSubstr("moon"));
    EXPECT_THAT(refusal("003-polar"), HasSubstr("version"));
    EXPECT_EQ(results().load("004-polar").data->name, "round");
}

TEST_F(ResultFolderTest, RefusesMonteCarloRunsWhosePartsDoNotFit) {
    const std::string stem = results().save(ranMonteCarlo());
    const auto file = results().path() / (stem + ".json");
    const std::string whole = readTextFile(file);
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = whole;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        writeTextFile(file, text);
        return refusal(stem);
    };
    EXPECT_THAT(with("\"draws\": 300", "\"draws\": 90000000"), HasSubstr("draws"));
    EXPECT_THAT(with("\"draws\": 300", "\"draws\": -1"), HasSubstr("draws"));
    EXPECT_THAT(with("\"scale\": 0", "\"scale\": 7"),
                testing::ContainsRegex("ranking.0.scale, line [0-9]+: found 7"));
    EXPECT_THAT(with("\"sequence\": \"sobol\"", "\"sequence\": \"soboll\""),
                testing::ContainsRegex("options.sequence, line .*soboll.*plain or sobol"));
    EXPECT_THAT(with("\"kind\": \"temperature\"", "\"kind\": \"heat\""),
                testing::ContainsRegex("scales.0.kind, line .*heat.*temperature or emissivity"));
    EXPECT_THAT(with("\"min\": 0.7", "\"min\": 1.7"), HasSubstr("scales.0"));
    EXPECT_THAT(with("\"subpixel_shifts\": 4", "\"subpixel_shifts\": 4.5"),
                HasSubstr("options.subpixel_shifts"));
    EXPECT_THAT(with("\"bands\": [\n  \"\"\n ]", "\"bands\": []"), HasSubstr("statistic"));
    EXPECT_THAT(with("\"normal\"", "\"odd\""), HasSubstr("odd"));
    EXPECT_THAT(with("\"samples\": 300", "\"samples\": 0"), HasSubstr("samples"));
    EXPECT_THAT(with("\"options\"", "\"opinions\""),
                HasSubstr("options, line 1: found nothing, expected an object"));
}

TEST_F(ResultFolderTest, RefusesASummaryOfAnotherForm) {
    const std::string stem = results().save(ran(AnalysisKind::polar, "round"));
    const auto file = results().path() / (stem + ".result");
    const std::string whole = readTextFile(file);
    const std::size_t at = whole.find("\"summary\": ["), end = whole.find(']', at);
    ASSERT_NE(at, std::string::npos);
    const auto with = [&](const std::string& summary) {
        std::string text = whole;
        writeTextFile(file, text.replace(at, end + 1 - at, "\"summary\": " + summary));
    };
    with("[7]");
    EXPECT_THAT(refusal(stem), HasSubstr("summary.0"));
    with("true");
    EXPECT_THAT(refusal(stem), HasSubstr("summary"));
    with(R"([{"label": "a", "value": "2", "unit": ""}])");
    EXPECT_THAT(refusal(stem), HasSubstr("summary.0.value"));
    with(R"([{"label": "a", "value": null, "unit": ""}])");
    EXPECT_TRUE(std::isnan(results().load(stem).data->summary.front().value));
}

TEST_F(ResultFolderTest, AFolderThatIsNotThereHoldsNothing) {
    EXPECT_TRUE(results().documents().empty());
    results().remove("001-polar");
    project.file = "/proc/no-such-place/ship.smat";
    EXPECT_THAT(test::refusalOf([&] { results().save(ran(AnalysisKind::polar, "round")); }),
                HasSubstr("/proc/no-such-place"));
}

} // namespace
} // namespace smat
