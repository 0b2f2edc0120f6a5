// Tools, Detection range: a sensor is chosen, the rose is drawn, kept, exported, and is that of the
// command line.
#include "gui/tools/DetectionPage.h"

#include <fstream>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include "gui/analysis/ResultPage.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/Theme.h"
#include "smatcore/jobs/AnalysisJobs.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class DetectionPageTest : public test::WindowFixture {
  protected:
    void openPage() {
        openSample();
        workbench.set("render.bounces", "0");
        trigger("detectionRange");
        page = window->findChild<DetectionPage*>();
        ASSERT_NE(page, nullptr);
        find<RealBox>("aspectStep")->setValue(60.0);
    }
    template <typename Widget>
    Widget* find(const char* name) {
        return page->findChild<Widget*>(name);
    }
    void run() {
        QSignalSpy ended(page, &DetectionPage::ended);
        find<QPushButton>("run")->click();
        ASSERT_TRUE(test::waitUntil([&] { return !ended.isEmpty(); }, 120.0));
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }

    DetectionPage* page = nullptr;
};

TEST_F(DetectionPageTest, DrawsTheRoseOfTheCommandLineAndKeepsIt) {
    openPage();
    EXPECT_GE(find<QComboBox>("sensorFile")->count(), 7) << "six that ship, and a file";
    EXPECT_TRUE(find<QLabel>("sensorText")->text().contains("NETD"));
    find<RealBox>("snr")->setValue(7.5);
    const QString command = find<QLineEdit>("command")->text();
    EXPECT_TRUE(command.startsWith("smat-batch detection ")) << command.toStdString();
    EXPECT_TRUE(command.contains("--snr 7.5") && command.contains("--step=60"))
        << command.toStdString();
    run();
    const PolarData& rose = page->plot().polar()->data();
    ASSERT_EQ(rose.curves.size(), 1u);
    ASSERT_EQ(rose.curves[0].y.size(), 6u);

    AnalysisData same = page->asked();
    JobRunner().run(same, page->request());
    EXPECT_EQ(rose.curves[0].y, same.table.find("detection_range")->values);
    EXPECT_GT(rose.curves[0].y[0], 100.0);

    ASSERT_EQ(workbench.results().size(), 1u);
    const ResultEntry& kept = workbench.results().front();
    EXPECT_EQ(kept.data->kind, detectionKind());
    ResultPage again({kept});
    ASSERT_NE(again.polarPlot(), nullptr);
    window->resize(1280, 800);
    test::keepScreenshot(*window, "detection-light");
    for (const char* suffix : {".csv", ".json", ".png", ".svg"}) {
        const auto file = folder / (std::string("rose") + suffix);
        page->exportTo(file);
        EXPECT_GT(std::filesystem::file_size(file), 500u) << suffix;
    }
    EXPECT_EQ(ResultTable::load(folder / "rose.csv").rowCount(), 6u);
}

TEST_F(DetectionPageTest, ATaskShowsItsOwnFieldsAndResolvesCloser) {
    openPage();
    EXPECT_TRUE(find<RealBox>("snr")->isVisibleTo(page));
    EXPECT_FALSE(find<QComboBox>("task")->isVisibleTo(page));
    find<QComboBox>("criterion")->setCurrentIndex(1);
    EXPECT_FALSE(find<RealBox>("snr")->isVisibleTo(page));
    EXPECT_TRUE(find<QComboBox>("task")->isVisibleTo(page));
    find<RealBox>("backgroundTemperature")->setValue(290.0);
    find<RealBox>("nearest")->setValue(20.0);
    find<RealBox>("probability")->setValue(80.0);
    find<QComboBox>("task")->setCurrentIndex(0);
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains(
        "--criterion johnson --task detection --probability 80"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    const std::vector<double> detected = page->plot().polar()->data().curves[0].y;
    find<QComboBox>("task")->setCurrentIndex(2);
    run();
    const std::vector<double> identified = page->plot().polar()->data().curves[0].y;
    ASSERT_EQ(identified.size(), detected.size());
    for (std::size_t i = 0; i < detected.size(); ++i) {
        EXPECT_LT(identified[i], 0.5 * detected[i]);
    }
}

TEST_F(DetectionPageTest, TheTargetingTaskHasItsOwnCyclesAndADisplay) {
    openPage();
    EXPECT_FALSE(find<RealBox>("sceneContrast")->isVisibleTo(page));
    find<QComboBox>("criterion")->setCurrentIndex(2);
    EXPECT_TRUE(find<RealBox>("sceneContrast")->isVisibleTo(page));
    EXPECT_EQ(find<QComboBox>("task")->itemText(1), "recognition: 14.5 cycles");
    find<RealBox>("backgroundTemperature")->setValue(290.0);
    find<RealBox>("nearest")->setValue(20.0);
    find<RealBox>("sceneContrast")->setValue(15.0);
    find<QComboBox>("task")->setCurrentIndex(1);
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains(
        "--criterion ttp --task recognition --scene-contrast 15"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    for (const double range_m : page->plot().polar()->data().curves[0].y) {
        EXPECT_GT(range_m, 20.0);
    }
    find<QComboBox>("criterion")->setCurrentIndex(1);
    EXPECT_EQ(find<QComboBox>("task")->itemText(1), "recognition: 3 cycles");
}

TEST_F(DetectionPageTest, APointHasFalseAlarmsProbabilityClutterAndSensitivity) {
    openPage();
    EXPECT_FALSE(find<RealBox>("falseAlarms")->isVisibleTo(page));
    EXPECT_FALSE(find<RealBox>("clutter")->isVisibleTo(page));
    find<QComboBox>("thresholdBy")->setCurrentIndex(1);
    EXPECT_TRUE(find<RealBox>("falseAlarms")->isVisibleTo(page));
    EXPECT_FALSE(find<RealBox>("snr")->isVisibleTo(page));
    EXPECT_NEAR(page->request().threshold, 4.753424309, 1e-6) << "once in a million";
    find<RealBox>("pointProbability")->setValue(90.0);
    find<QComboBox>("clutterBy")->setCurrentIndex(1);
    find<RealBox>("clutter")->setValue(0.25);
    EXPECT_EQ(page->request().clutter_K, 0.25);
    find<RealBox>("backgroundTemperature")->setValue(290.0);
    find<RealBox>("farthest")->setValue(1e7);
    find<QCheckBox>("sensitivity")->setChecked(true);
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains(
        "--probability 90 --clutter 0.25 --sensitivity"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    EXPECT_TRUE(find<QLabel>("summary")->text().contains(
        "Sensitivity of the range to: temperatures of the target"))
        << find<QLabel>("summary")->text().toStdString();
    EXPECT_TRUE(find<QLabel>("summary")->text().contains(", clutter: -0."));
    auto* quantity = find<QComboBox>("quantity");
    EXPECT_GE(quantity->findData("sensitivity_aperture"), 0);
    window->resize(1280, 900);
    test::keepScreenshot(*window, "detection-fields");
    find<QComboBox>("clutterBy")->setCurrentIndex(2);
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains("--clutter auto"));
    EXPECT_EQ(page->request().clutter_K, 0.0);
}

TEST_F(DetectionPageTest, PlotsRangesAgainstPaintAndProbabilityOverRange) {
    openPage();
    find<RealBox>("backgroundTemperature")->setValue(290.0);
    find<RealBox>("farthest")->setValue(1e7);
    auto* tableOf = find<QComboBox>("tableOf");
    EXPECT_FALSE(find<QLineEdit>("values")->isVisibleTo(page));
    tableOf->setCurrentIndex(tableOf->findText("ranges against paint"));
    EXPECT_TRUE(find<QLineEdit>("values")->isVisibleTo(page));
    EXPECT_FALSE(find<QCheckBox>("sensitivity")->isVisibleTo(page));
    EXPECT_FALSE(find<QPushButton>("run")->isEnabled()) << "no values yet";
    find<QLineEdit>("values")->setText("0.1, 0.5, 0.9");
    find<QLineEdit>("paint")->setText("ship paint");
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains(
        "--against paint --values 0.1,0.5,0.9 --paint 'ship paint'"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    ASSERT_NE(page->plot().cartesian(), nullptr);
    const PlotData& curves = page->plot().cartesian()->data();
    ASSERT_EQ(curves.curves.size(), 1u);
    EXPECT_EQ(curves.curves[0].x, (std::vector<double>{0.1, 0.5, 0.9}));
    EXPECT_EQ(curves.curves[0].error.size(), 3u) << "its error is drawn, too";
    window->resize(1280, 900);
    test::keepScreenshot(*window, "detection-against");

    tableOf->setCurrentIndex(tableOf->findText("probability over range"));
    EXPECT_FALSE(find<RealBox>("nearest")->isVisibleTo(page));
    find<QLineEdit>("ranges")->setText("20000, 80000, 95000");
    find<RealBox>("draws")->setValue(2.0);
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains("--ranges 20000,80000,95000 --draws 2"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    EXPECT_EQ(page->plot().cartesian()->data().curves[0].x.size(), 3u);
    test::keepScreenshot(*window, "detection-probability");
}

TEST_F(DetectionPageTest, ShowsDirectionsAsATableOfSignatures) {
    openPage();
    workbench.set("table.azimuthStep", "90");
    workbench.set("table.elevationStep", "45");
    workbench.set("table.elevationFrom", "0");
    find<RealBox>("backgroundTemperature")->setValue(290.0);
    find<RealBox>("farthest")->setValue(1e7);
    find<QComboBox>("tableOf")->setCurrentIndex(1);
    EXPECT_FALSE(find<RealBox>("aspectStep")->isVisibleTo(page));
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains("--cases directions"))
        << find<QLineEdit>("command")->text().toStdString();
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains("table.elevationStep=45"))
        << find<QLineEdit>("command")->text().toStdString();
    run();
    ASSERT_NE(page->table(), nullptr);
    window->resize(1280, 900);
    test::keepScreenshot(*window, "detection-directions");
    const auto file = folder / "directions.csv";
    page->exportTo(file);
    EXPECT_EQ(ResultTable::load(file).rowCount(), 12u);
}

TEST_F(DetectionPageTest, HotPartsAreLeftOutByTheirNames) {
    openPage();
    auto* leftOut = find<QToolButton>("leftOut");
    EXPECT_FALSE(leftOut->isVisibleTo(page));
    find<QComboBox>("criterion")->setCurrentIndex(1);
    EXPECT_TRUE(leftOut->isVisibleTo(page));
    EXPECT_EQ(leftOut->text(), "nothing");
    emit leftOut->menu()->aboutToShow();
    for (QAction* action : leftOut->menu()->actions()) {
        if (action->text() == "funnel") {
            action->trigger();
        }
    }
    EXPECT_EQ(leftOut->text(), "funnel");
    EXPECT_EQ(page->request().leftOut, std::vector<std::string>{"funnel"});
    EXPECT_TRUE(find<QLineEdit>("command")->text().contains("--leave-out funnel"));
    find<QComboBox>("criterion")->setCurrentIndex(0);
    EXPECT_TRUE(page->request().leftOut.empty());
}

TEST_F(DetectionPageTest, SaysWhatIsWrongWithASensorAndWithLimits) {
    openPage();
    const std::filesystem::path bad = folder / "bad.smatsensor";
    std::ofstream(bad) << "{\"format\": \"smat-sensor\", \"version\": 1}";
    chosen = QString::fromStdString(bad.string());
    auto* sensors = find<QComboBox>("sensorFile");
    sensors->setCurrentIndex(sensors->count() - 1);
    emit sensors->activated(sensors->count() - 1);
    EXPECT_FALSE(find<QPushButton>("run")->isEnabled());
    EXPECT_EQ(find<QLabel>("sensorText")->text(), "This sensor cannot be used.");
    EXPECT_THROW((void)page->request(), irsg::InputError);
    sensors->setCurrentIndex(0);
    emit sensors->activated(0);
    EXPECT_TRUE(find<QPushButton>("run")->isEnabled());
    find<RealBox>("farthest")->setValue(50.0);
    EXPECT_FALSE(find<QPushButton>("run")->isEnabled());
    // A question that is not answered changes nothing.
    chosen.clear();
    sensors->setCurrentIndex(sensors->count() - 1);
    emit sensors->activated(sensors->count() - 1);
    EXPECT_EQ(sensors->currentIndex(), 0);
}

} // namespace
} // namespace smat::gui
