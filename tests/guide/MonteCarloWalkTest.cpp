#include <QSlider>
#include <QSpinBox>
#include <QTreeWidget>

#include "gui/analysis/MonteCarloPlots.h"
#include "gui/analysis/RankingBars.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/tools/MonteCarloPage.h"
#include "irsg/signature/ScalingXml.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

class MonteCarloWalkTest : public test::GuideFixture {
  protected:
    void run() {
        get<QPushButton>("run", shown)->click();
        ASSERT_TRUE(test::waitUntil([&] { return !shown->isRunning(); }, 60.0));
        QTest::qWait(30);
    }
    MonteCarloPage* shown = nullptr;
};

TEST_F(MonteCarloWalkTest, WriteScalingFilesRunAndExport) {
    test::GuideWalk walk("monte-carlo");
    openCopy("turboprop4", {{"render.bounces", "0"},
                            {"sensor.fov", "4"},
                            {"state.power", "0.7"},
                            {"polar.step", "90"},
                            {"render.antialiasing", "3"}});
    Project project = workbench.project();
    project.analyses = {{.name = "turn", .kind = AnalysisKind::polar},
                        {.name = "picture", .kind = AnalysisKind::image}};
    workbench.edit(project, "Name the analyses");
    trigger("saveProject");

    walk.step("Tools → Monte Carlo repeats an analysis with random scales; two files beside the "
              "model define their distributions for every index");
    act("monteCarlo");
    shown = page<MonteCarloPage>();
    ASSERT_NE(shown, nullptr);

    walk.step("Choose the analysis: one that the project names, or one with the settings of the "
              "project. An image has no single number to repeat");
    auto* analyses = get<QComboBox>("analysis", shown);
    EXPECT_EQ(analyses->itemText(0), "turn (polar)");
    EXPECT_EQ(analyses->findText("picture (image)"), -1);
    EXPECT_GT(analyses->count(), 2);
    choose(analyses, 0);

    walk.step("Look at the scales. If there are no scaling files yet, Write scaling files makes "
              "them with all scales 1");
    EXPECT_FALSE(get<QPushButton>("run", shown)->isEnabled());
    get<QPushButton>("writeScalingFiles", shown)->click();
    const auto model = folder / "turboprop4.flt";
    for (const auto kind : {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity}) {
        const auto file = irsg::scalingFile(model, kind);
        irsg::ScalingTable table = irsg::readScalingFile(file, kind);
        ASSERT_FALSE(table.empty());
        for (auto& [index, entry] : table) {
            EXPECT_EQ(entry.distribution.minimum(), 1.0);
            EXPECT_EQ(entry.distribution.maximum(), 1.0);
            entry.distribution =
                kind == irsg::ScalingKind::temperature
                    ? irsg::Distribution(irsg::DistributionKind::uniform, 0.98, 1.02)
                    : irsg::Distribution(irsg::DistributionKind::uniform, 0.9, 1.0);
        }
        smat::test::write(file, irsg::scalingXml(table)); // as in a text editor
    }
    act("monteCarlo");
    shown = page<MonteCarloPage>();

    walk.step("Run. The plots come at the end; Cancel keeps the samples so far. The run is a "
              "result like any other");
    auto* realisations = get<QSpinBox>("samples", shown);
    realisations->setValue(2'000'000);
    get<QPushButton>("run", shown)->click();
    QTest::qWait(400);
    get<QPushButton>("cancel", shown)->click();
    ASSERT_TRUE(test::waitUntil([&] { return shown->plots().data().realisations() > 0; }, 60.0));
    EXPECT_LT(shown->plots().data().realisations(), 2'000'000U);
    realisations->setValue(256);
    get<QSpinBox>("pairs", shown)->setValue(64);
    get<QSpinBox>("subpixelShifts", shown)->setValue(1);
    run();
    const MonteCarloData first = shown->plots().data();
    EXPECT_EQ(first.realisations(), 256U);
    EXPECT_EQ(first.abscissae.size(), 4U);
    ASSERT_GE(workbench.results().size(), 2U);
    EXPECT_NE(workbench.results().back().monteCarlo, nullptr);
    selectResults({static_cast<int>(workbench.results().size()) - 1});
    act("rerunResultAction");
    ASSERT_TRUE(settled());
    EXPECT_EQ(workbench.results().back().monteCarlo->values, first.values);
    tabs()->setCurrentWidget(shown);

    walk.step("quantity | the plotted quantity: contrast intensity, intensity, or irradiance at "
              "the sensor");
    EXPECT_EQ(get<QComboBox>("quantity", shown)->count(), 3);
    walk.step("percentiles | the bands of the plot");
    write(get<QLineEdit>("percentiles", shown), "10, 90");
    walk.step("renderings of each case | each case is also rendered with the target at other "
              "sub-pixel shifts");
    get<QSpinBox>("subpixelShifts", shown)->setValue(2);
    walk.step("draws at most | the run stops sooner if it reaches the requested standard error");
    realisations->setValue(100'000);
    get<QCheckBox>("stops", shown)->setChecked(true);
    get<QDoubleSpinBox>("standardError", shown)->setValue(20.0);
    run();
    EXPECT_LT(shown->plots().data().realisations(), 100'000U);
    get<QCheckBox>("stops", shown)->setChecked(false);
    realisations->setValue(256);
    walk.step("sequence | Sobol' points, which need far fewer samples, or plain ones");
    EXPECT_EQ(get<QComboBox>("sequence", shown)->count(), 2);
    walk.step("seed | the same seed gives the same samples on every machine");
    get<QSpinBox>("seed", shown)->setValue(7);
    run();
    EXPECT_NE(shown->plots().data().values, first.values);
    const auto seventh = shown->plots().data().values;
    run();
    EXPECT_EQ(shown->plots().data().values, seventh);
    walk.step("rank by pairs of draws | also ranks the indices: more pairs give a more accurate "
              "ranking");
    EXPECT_TRUE(get<QCheckBox>("ranks", shown)->isChecked());

    walk.step("The upper plot has the nominal value, the mean and the percentiles over the sweep. "
              "Move the slider to see the histogram elsewhere.");
    EXPECT_EQ(shown->plots().bands()->data().curves.size(), 2U + 2U);
    get<QSlider>("histogramPlace", shown)->setValue(1);
    EXPECT_EQ(get<QLabel>("histogramPlaceText", shown)->text(), "90°");
    EXPECT_FALSE(get<RankingBars>("rankingBars", shown)->bars().empty());

    walk.step("error_numerical is the error of the rendering itself.");
    chosen = path("bands.csv");
    act("exportShown");
    EXPECT_NE(ResultTable::load(folder / "bands.csv").find("error_numerical"), nullptr);
    for (const char* name : {"bands.json", "bands.svg", "bands.draws.csv"}) {
        chosen = path(name);
        act("exportShown");
        EXPECT_GT(std::filesystem::file_size(folder / name), 300U) << name;
    }
    EXPECT_EQ(ResultTable::load(folder / "bands.draws.csv").rowCount(), 256U);
    const QString command = get<QLineEdit>("command", shown)->text();
    EXPECT_TRUE(command.contains("--analysis turn") && command.contains("--seed 7"));
    terminal(command.toStdString() + " --out terminal.csv");
    EXPECT_EQ(ResultTable::load(folder / "terminal.csv").columns(),
              ResultTable::load(folder / "bands.csv").columns());
    const std::string sphere = SMAT_SOURCE_DIR "/samples/sphere/sphere";
    smat::test::write(folder / "SCENARIO", R"({"version": 1, "dt_s": 1, "end_s": 1,
 "sensor": {"width": 16, "height": 16, "fov": 12}, "render": {"bounces": 0},
 "entities": [{"name": "buoy", "model": "turboprop4.flt", "database": "turboprop4.sigdb",
               "position_m": [0, 500, 50]}],
 "sensors": [{"name": "mwir", "position_m": [0, 0, 50], "sensor": {"band": "3-5"}}]})");
    terminal("smat-batch montecarlo SCENARIO --samples 32 --out scenario.csv");
    const bool isWritten =
        std::ranges::any_of(std::filesystem::directory_iterator(folder), [](const auto& entry) {
            return entry.path().filename().string().starts_with("scenario");
        });
    EXPECT_TRUE(isWritten);
    EXPECT_TRUE(told.isEmpty()) << said();
}

} // namespace
} // namespace smat::gui
