#include "smatcore/simulate/ScenarioMonteCarlo.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "irsg/core/Errors.h"
#include "irsg/core/ParallelFor.h"
#include "irsg/signature/SignatureFile.h"
#include "smatcore/support/TextFile.h"
#include "tests/core/AnalyticSource.h"
#include "tests/support/Refusal.h"
#include "tests/support/TemporaryFolder.h"

namespace smat {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// So many times brighter in another band.
constexpr double perBand = 10.0;

/// The power of an entity times its scale of temperature 0; of all of them the sum.
class ScaledPower : public irsg::ScaledView {
  public:
    std::vector<std::pair<double, int>> parts; ///< power, and place of the scale; -1 for none

    std::size_t size() const override { return 1; }
    void evaluate(std::span<const double> scales, irsg::ScaledValues& values) const override {
        double sum = 0.0;
        for (const auto& [power, place] : parts) {
            sum += power * (place < 0 ? 1.0 : scales[static_cast<std::size_t>(place)]);
        }
        values.intensity = values.contrastIntensity = values.irradiance = {sum};
    }
};

class PoweredEntities : public test::GreySphere {
  public:
    std::vector<irsg::RenderReport> reports(const irsg::Outputs& outputs) override {
        ++measured;
        std::vector<irsg::RenderReport> made;
        for (std::size_t band = 0; band < outputs.bands().size(); ++band) {
            irsg::RenderReport& report = made.emplace_back();
            for (std::size_t i = 0; i < scene.entities.size(); ++i) {
                irsg::ObjectRadiometry object;
                object.intensity_W_sr = object.contrastIntensity_W_sr = object.irradiance_W_m2 =
                    power(i, band);
                report.all.contrastIntensity_W_sr += object.contrastIntensity_W_sr;
                report.objects.push_back(object);
            }
            report.providedBy = {"transmittance: closed form"};
        }
        return made;
    }
    std::vector<std::unique_ptr<const irsg::ScaledView>>
    scaledViews(const irsg::Outputs& outputs) override {
        const std::vector<irsg::ScalingInput>& inputs = outputs.scalings();
        EXPECT_TRUE(outputs.isByObject());
        std::vector<std::unique_ptr<const irsg::ScaledView>> views;
        for (std::size_t band = 0; band < outputs.bands().size(); ++band) {
            auto all = std::make_unique<ScaledPower>();
            std::vector<std::unique_ptr<const irsg::ScaledView>> each;
            for (std::size_t i = 0; i < scene.entities.size(); ++i) {
                int place = -1;
                for (std::size_t k = 0; k < inputs.size(); ++k) {
                    if (inputs[k].entity == static_cast<int>(i)) {
                        place = static_cast<int>(k);
                    }
                }
                auto one = std::make_unique<ScaledPower>();
                one->parts = {{power(i, band), place}};
                all->parts.push_back(one->parts.front());
                each.push_back(std::move(one));
            }
            views.push_back(std::move(all));
            std::ranges::move(each, std::back_inserter(views));
        }
        return views;
    }
    int measured = 0;

  private:
    double power(std::size_t entity, std::size_t band) const {
        return scene.entities[entity].state.power * (band == 0 ? 1.0 : perBand);
    }
};

/// A mover that is there from 1 to 3 s and a tower that always is, seen from the ground and from
/// the tower.
class ScenarioMonteCarloTest : public testing::Test {
  protected:
    void SetUp() override {
        irsg::SignatureDatabase database;
        database.temperatures[0].name = "skin";
        database.temperatures[0].terms = irsg::TemperatureTerms::ofAmbient();
        irsg::saveSignatureFile(database, folder / "model.sigdb");
        for (const char* model : {"mover.flt", "tower.flt"}) {
            writeTextFile(folder / model, "anything");
        }
        scale("mover.flt", {irsg::DistributionKind::normal, 0.8, 1.2});
        scale("tower.flt", {irsg::DistributionKind::uniform, 0.9, 1.1});
        writeTextFile(folder / "path.csv", "t,x,y,z,yaw,pitch,roll,power\n"
                                           "1,0,100,50,90,0,0,2\n3,20,100,50,90,0,0,6\n");
        scenario.file = folder / "s.json";
        scenario.dt_s = 1.0;
        scenario.end_s = 4.0;
        scenario.entities = {
            {.name = "mover",
             .model = "mover.flt",
             .database = "model.sigdb",
             .trajectory = "path.csv"},
            {.name = "tower", .model = "tower.flt", .database = "model.sigdb", .trajectory = {}}};
        scenario.entities[1].pose.position_m = {0, 0, 10};
        scenario.entities[1].power = 9.0;
        scenario.sensors = {{.name = "fixed", .offset = {{0, -100, 10}, {}}, .track = "mover"},
                            {.name = "deck", .mount = MountKind::entity, .carrier = "tower"}};
        scenario.sensors[1].offset.position_m = {0, 2, 1};
        options.samples = 300;
        options.subpixelShifts = 1;
    }
    void scale(const char* model, const irsg::Distribution& distribution) {
        writeTextFile(irsg::scalingFile(folder / model, irsg::ScalingKind::temperature),
                      irsg::scalingXml({{0, {distribution, ""}}}));
    }
    ScenarioMonteCarlo run(std::stop_token stop = {}) {
        SceneBuilder builder([](const std::filesystem::path&, const irsg::ModelOptions&) {
            return std::shared_ptr<const irsg::Model>();
        });
        Settings off;
        off.set("scaling.use", "false");
        ScenarioMonteCarlo asked;
        asked.scenario = loadScenarioFiles(scenario, builder, off);
        asked.plan = planSimulation(scenario, request);
        asked.options = options;
        asked.commandLine = "smat-batch montecarlo s.json";
        runScenarioMonteCarlo(asked, source, {}, std::move(stop));
        return asked;
    }
    static const MonteCarloData& part(const ScenarioMonteCarlo& of, const std::string& label) {
        for (const ScenarioDistribution& one : of.parts) {
            if (one.label() == label) {
                return one.data;
            }
        }
        throw irsg::LogicError("no part " + label);
    }
    std::string refusal() {
        return test::refusalOf([&] { run(); });
    }

    test::TemporaryFolder folder;
    Scenario scenario;
    SimulationRequest request;
    MonteCarloOptions options;
    PoweredEntities source;
};

TEST_F(ScenarioMonteCarloTest, GivesEachEntityAtEachTimeWhatItsScaleMakesOfIt) {
    const ScenarioMonteCarlo result = run();
    EXPECT_EQ(result.state, AnalysisState::complete);
    std::vector<std::string> labels;
    for (const ScenarioDistribution& one : result.parts) {
        labels.push_back(one.label());
    }
    EXPECT_THAT(labels, ElementsAre("fixed-mover", "fixed-tower", "fixed", "deck-mover",
                                    "deck-tower", "deck"));
    const MonteCarloData& mover = part(result, "deck-mover");
    const MonteCarloData& tower = part(result, "deck-tower");
    const MonteCarloData& all = part(result, "deck");
    EXPECT_THAT(mover.abscissae, ElementsAre(1.0, 2.0, 3.0)) << "it is there then alone";
    EXPECT_THAT(tower.abscissae, ElementsAre(0.0, 1.0, 2.0, 3.0, 4.0));
    EXPECT_THAT(part(result, "fixed-tower").abscissae, ElementsAre(1.0, 2.0, 3.0))
        << "the sensor looks at the mover";
    EXPECT_THAT(mover.nominal, ElementsAre(2.0, 4.0, 6.0));
    const ScalingRealisations realisations(mover.scalings, options.sequence, 1);
    ASSERT_EQ(mover.scalings.size(), 2u);
    EXPECT_EQ(mover.scalings[1].name, "tower temperature 0 (skin)");
    for (std::size_t draw = 0; draw < 300; ++draw) {
        const std::vector<double> scales = realisations.at(draw);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(mover.values[k][draw], mover.nominal[k] * scales[0]);
            EXPECT_EQ(part(result, "fixed-mover").values[k][draw], mover.values[k][draw]);
        }
        EXPECT_EQ(tower.values[4][draw], 9.0 * scales[1]);
        EXPECT_EQ(all.values[4][draw], tower.values[4][draw]) << "the mover has gone";
        EXPECT_EQ(all.values[2][draw], 4.0 * scales[0] + 9.0 * scales[1]);
    }
    EXPECT_EQ(source.measured, 8) << "once for each sensor and step at which it sees";
    // Spread and mean of a uniform scale from 0.9 to 1.1.
    const ResultTable& table = tower.analysis.table;
    EXPECT_NEAR(table.find("mean")->values[0], 9.0, 0.01);
    EXPECT_NEAR(table.find("standard_deviation")->values[0], 9.0 * 0.2 / std::sqrt(12.0), 0.01);
    EXPECT_EQ(table.columns()[0].header(), "time [s]");
}

TEST_F(ScenarioMonteCarloTest, SeveralBandsShareTheirDraws) {
    scenario.sensors[1].settings.set("sensor.band", "3-5,8-12");
    const ScenarioMonteCarlo result = run();
    const MonteCarloData& mover = part(result, "deck-mover");
    ASSERT_EQ(mover.values.size(), 6u);
    EXPECT_THAT(mover.bands, ElementsAre("3-5um", "8-12um"));
    for (std::size_t draw = 0; draw < 300; ++draw) {
        EXPECT_DOUBLE_EQ(mover.values[4][draw], perBand * mover.values[1][draw]);
    }
    EXPECT_NE(mover.analysis.table.find("mean@8-12um"), nullptr);
}

TEST_F(ScenarioMonteCarloTest, EqualSeedsGiveEqualDrawsOnAnyNumberOfThreads) {
    const auto values = part(run(), "deck").values;
    irsg::setMostThreads(3);
    EXPECT_EQ(part(run(), "deck").values, values);
    irsg::setMostThreads(1);
    EXPECT_EQ(part(run(), "deck").values, values);
    irsg::setMostThreads(0);
    scenario.settings.set("scaling.seed", "2");
    EXPECT_NE(part(run(), "deck").values, values);
}

TEST_F(ScenarioMonteCarloTest, DrawZeroOfThePlainSequenceIsThatOfASimulation) {
    options.sequence = RealisationSequence::plain;
    const MonteCarloData tower = part(run(), "deck-tower");
    SceneBuilder builder([](const std::filesystem::path&, const irsg::ModelOptions&) {
        return std::shared_ptr<const irsg::Model>();
    });
    const auto loaded = loadScenarioFiles(scenario, builder);
    EXPECT_EQ(tower.values[0][0], 9.0 * loaded.sensors[0].scene.entities[1].temperatureScale.at(0));
}

TEST_F(ScenarioMonteCarloTest, WritesBandsOfEachPartAndDrawsOfEachSensor) {
    request.sensors = {"deck"};
    scenario.settings.set("scaling.seed", "5");
    const ScenarioMonteCarlo result = run();
    EXPECT_THAT(saveDistributions(result, folder / "b.csv"),
                ElementsAre(folder / "b-deck-mover.csv", folder / "b-deck-tower.csv",
                            folder / "b-deck.csv"));
    const ResultTable bands = ResultTable::load(folder / "b-deck-tower.csv");
    EXPECT_EQ(bands.provenance.value("seen"), "tower");
    EXPECT_EQ(bands.provenance.value("sensor"), "deck");
    EXPECT_EQ(bands.provenance.value("state"), "complete");
    EXPECT_EQ(bands.provenance.value("command"), "smat-batch montecarlo s.json");
    EXPECT_EQ(bands.provenance.value("scaling.seed"), "5");
    EXPECT_EQ(bands.provenance.value("scale"), "mover temperature 0 (skin): normal, 0.8 to 1.2");
    EXPECT_THAT(saveScenarioRealisations(result, folder / "d.json"),
                ElementsAre(folder / "d-deck.json"));
    const ResultTable realisations = ResultTable::load(folder / "d-deck.json");
    ASSERT_EQ(realisations.rowCount(), 300u);
    const auto at = [&](const std::string& key, std::size_t row) {
        const ResultColumn* column = realisations.find(key);
        return column == nullptr ? -1.0 : column->values[row];
    };
    for (const std::size_t row : {0u, 7u, 299u}) {
        const double mover = at("scale mover temperature 0 (skin)", row);
        const double tower = at("scale tower temperature 0 (skin)", row);
        EXPECT_EQ(at("mover.contrast_intensity at 2 s", row), 4.0 * mover);
        EXPECT_EQ(at("tower.contrast_intensity at 4 s", row), 9.0 * tower);
        EXPECT_EQ(at("contrast_intensity at 2 s", row), 4.0 * mover + 9.0 * tower);
    }
}

TEST_F(ScenarioMonteCarloTest, StopsAtAStandardErrorOfTheWorstPart) {
    options.samples = 100000;
    options.standardError = 1e-4;
    const ScenarioMonteCarlo result = run();
    EXPECT_EQ(result.state, AnalysisState::complete);
    for (const ScenarioDistribution& one : result.parts) {
        EXPECT_TRUE(one.data.reachedStandardError) << one.label();
        EXPECT_LT(one.data.realisations(), 100000u);
    }
}

TEST_F(ScenarioMonteCarloTest, KeepsStepsAndDrawsOfAStop) {
    options.samples = 1000;
    std::stop_source stop;
    stop.request_stop();
    const ScenarioMonteCarlo result = run(stop.get_token());
    EXPECT_EQ(result.state, AnalysisState::partial);
    const MonteCarloData& tower = part(result, "deck-tower");
    EXPECT_EQ(tower.realisations(), 256u);
    EXPECT_EQ(tower.analysis.table.provenance.value("state"), "partial");
    EXPECT_THAT(tower.analysis.warnings,
                testing::IsSupersetOf({HasSubstr("stopped after 1 of 5 steps"),
                                       HasSubstr("stopped after 256 of 1000 draws")}));
}

TEST_F(ScenarioMonteCarloTest, RefusesWhatItCannotDo) {
    options.ranking = true;
    EXPECT_THAT(refusal(), HasSubstr("a scenario has no ranking"));
    options.ranking = false;
    options.subpixelShifts = 4;
    EXPECT_THAT(refusal(), HasSubstr("subpixel shifts: found 4, expected 1"));
    options.subpixelShifts = 1;
    request.to_s = 0.5;
    request.sensors = {"fixed"};
    EXPECT_THAT(refusal(), HasSubstr("none at which a sensor sees an entity"));
    request = {};
    for (const char* model : {"mover.flt", "tower.flt"}) {
        scale(model, {irsg::DistributionKind::uniform, 1.1, 1.1});
    }
    EXPECT_THAT(refusal(), HasSubstr("no scale that varies"));
    for (const char* model : {"mover.flt", "tower.flt"}) {
        std::filesystem::remove(irsg::scalingFile(folder / model, irsg::ScalingKind::temperature));
    }
    EXPECT_THAT(refusal(), HasSubstr("a scaling file beside the model"));
}

} // namespace
} // namespace smat
