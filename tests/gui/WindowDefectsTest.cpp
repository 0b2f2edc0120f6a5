#include <fstream>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeWidget>

#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/RankingBars.h"
#include "gui/plot/ResultPlot.h"
#include "gui/view/ViewHud.h"
#include "smatcore/project/ProjectFile.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// What went wrong once, a test each.
class WindowDefectsTest : public test::WindowFixture {};

TEST_F(WindowDefectsTest, KeysDoNotReachFieldsOfADockBehindAnother) {
    openSample();
    auto* database = window->findChild<QDockWidget*>("databaseDock");
    auto* results = window->findChild<QDockWidget*>("resultsDock");
    const auto isInside = [&](QDockWidget* dock) {
        const QWidget* focus = QApplication::focusWidget();
        return focus != nullptr && dock->isAncestorOf(focus);
    };
    window->activateWindow();
    database->raise();
    QTest::qWait(30);
    QLineEdit* field = nullptr;
    for (auto* one : database->findChildren<QLineEdit*>()) {
        if (one->isVisible() && one->isEnabled() && !one->isReadOnly()) {
            field = one;
        }
    }
    ASSERT_NE(field, nullptr);
    field->setFocus();
    ASSERT_TRUE(isInside(database));
    results->raise();
    QTest::qWait(30);
    EXPECT_FALSE(isInside(database));
    // Nor does Tab come back to them.
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget()
                                                               : window.get(),
                        Qt::Key_Tab);
        ASSERT_FALSE(isInside(database)) << "after " << i + 1 << " times Tab";
    }
    database->raise();
    QTest::qWait(30);
    EXPECT_TRUE(field->isVisible());
    EXPECT_EQ(workbench.undoStack().count(), 0);
}

TEST_F(WindowDefectsTest, AFileThatIsNoModelLeavesWhatIsOpenUntouched) {
    openSample();
    const auto pdf = folder / "report.pdf";
    std::ofstream(pdf) << "%PDF-1.4\n";
    workbench.set("camera.azimuth", "7");
    answer = 1;
    EXPECT_FALSE(window->open(pdf));
    ASSERT_EQ(told.size(), 1);
    EXPECT_TRUE(told.front().contains("report.pdf")) << told.front().toStdString();
    EXPECT_EQ(workbench.project().displayName(), "ship.smat");
    EXPECT_EQ(workbench.settings().text("camera.azimuth"), "7");
    EXPECT_EQ(workbench.undoStack().count(), 1);
}

TEST_F(WindowDefectsTest, LoadingOfAModelCanBeCancelled) {
    Project project;
    const auto sample = std::filesystem::path(SMAT_SOURCE_DIR) / "samples/turboprop4";
    project.models.assign(40, {.file = sample / "turboprop4.flt", .database = {}});
    saveProject(project, folder / "large.smat");
    ASSERT_TRUE(window->open(folder / "large.smat"));
    auto* cancel = window->findChild<QToolButton*>("cancelLoading");
    ASSERT_NE(cancel, nullptr);
    ASSERT_TRUE(window->isLoadingModel());
    cancel->click();
    EXPECT_TRUE(window->sceneView()->facesAt(window->sceneView()->rect().center()).empty());
    EXPECT_TRUE(window->statusBar()->currentMessage().contains("was not read"));
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    // The project is open, and another one is shown as ever.
    openSample();
    EXPECT_FALSE(window->isLoadingModel());
}

TEST_F(WindowDefectsTest, WhatIsSaidOfAResultGoesWithItsPage) {
    openSample();
    workbench.set("sensor.fov", "0.5");
    runAnalysis("polar");
    const auto says = [&] { return window->statusBar()->currentMessage(); };
    EXPECT_TRUE(says().contains("beyond the frame")) << says().toStdString();
    auto* tabs = window->findChild<QTabWidget*>("tabs");
    const int page = tabs->currentIndex();
    ASSERT_GT(page, 0);
    tabs->setCurrentIndex(0);
    EXPECT_FALSE(says().contains("beyond the frame")) << says().toStdString();
    workbench.set("sensor.fov", "40");
    runAnalysis("polar");
    EXPECT_FALSE(says().contains("beyond the frame")) << says().toStdString();
    tabs->setCurrentIndex(page);
    EXPECT_TRUE(says().contains("beyond the frame")) << says().toStdString();
    // What came after it stays.
    window->statusBar()->showMessage("something else");
    tabs->setCurrentIndex(0);
    EXPECT_EQ(says(), "something else");
    emit tabs->tabCloseRequested(page);
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
}

TEST_F(WindowDefectsTest, TheReadOutCallsSurfacesByTheirNames) {
    openSample();
    const auto& database = workbench.database().value();
    SceneView& view = *window->sceneView();
    int faces = 0;
    for (int x = 20; x < view.width(); x += 40) {
        const QPointF at(x, 0.5 * view.height());
        const auto hits = view.facesAt(at);
        if (hits.empty()) {
            continue;
        }
        ++faces;
        const QString said = view.readoutAt(at);
        for (const std::string& name :
             {database.temperatures.at(hits.front().codes.temperature).name,
              database.materials.at(hits.front().codes.material).name}) {
            EXPECT_FALSE(name.empty());
            EXPECT_TRUE(said.contains("(" + QString::fromStdString(name) + ")"))
                << said.toStdString() << ", where the surface is " << name;
        }
    }
    EXPECT_GT(faces, 2);
}

TEST_F(WindowDefectsTest, AnAzimuthSweepSaysThatTheElevationOfTheViewIsNotUsed) {
    openSample();
    AnalysisGeneratorDialog dialog(workbench.project(), workbench.settings(), AnalysisKind::polar,
                                   [](const QString&, const QString&) { return QString(); });
    const auto* ignored = dialog.findChild<QLabel*>("ignored");
    ASSERT_NE(ignored, nullptr);
    EXPECT_FALSE(ignored->isHidden());
    EXPECT_TRUE(ignored->text().contains("elevation 15")) << ignored->text().toStdString();
    auto* type = dialog.findChild<QComboBox*>("polar.type");
    ASSERT_NE(type, nullptr);
    dialog.show();
    QTest::keyClick(type, Qt::Key_End); // model yaw, before a camera that stays
    EXPECT_FALSE(ignored->text().contains("elevation 15")) << ignored->text().toStdString();
}

TEST(ViewHud, WhatIsWaitedForLeavesTheCameraLegible) {
    for (const int width : {420, 530, 700, 1100}) {
        ViewHud hud;
        hud.hasProject = hud.hasModel = true;
        hud.viewAxes = false;
        hud.frame = {0.26, width, 300};
        hud.projection.window = QSizeF(width, 300);
        hud.camera = {52.0, 14.0, 120.0};
        const auto drawn = [&] {
            QImage image(width, 300, QImage::Format_RGB32);
            image.fill(Qt::blue);
            QPainter painter(&image);
            hud.paint(painter);
            painter.end();
            return image;
        };
        const QImage camera = drawn();
        hud.busy = "infrared: adding inter-reflection… 23.9 s";
        const QImage both = drawn();
        EXPECT_NE(both, camera);
        int changed = 0, words = 0;
        for (int y = 0; y < 60; ++y) {
            for (int x = 0; x < width / 2; ++x) {
                const bool isWord = camera.pixel(x, y) != QColor(Qt::blue).rgb();
                words += isWord ? 1 : 0;
                changed += isWord && both.pixel(x, y) != camera.pixel(x, y) ? 1 : 0;
            }
        }
        EXPECT_GT(words, 500) << width;
        EXPECT_EQ(changed, 0) << width;
    }
}

TEST(TemperatureProfilePlot, HasItsAltitudeUpward) {
    ResultTable table;
    table.provenance.add("analysis", "temperature-profile");
    table.add(irsg::Quantity::altitude);
    table.add(irsg::Quantity::temperature);
    table.addRow({0.0, 288.0});
    table.addRow({1000.0, 281.5});
    table.addRow({2000.0, 275.0});
    const PlotData data = cartesianData({{"", &table}}, plottableQuantities(table).front());
    ASSERT_EQ(data.curves.size(), 1U);
    EXPECT_EQ(data.curves[0].y, (std::vector<double>{0.0, 1000.0, 2000.0}));
    EXPECT_TRUE(data.yTitle.startsWith("Altitude")) << data.yTitle.toStdString();
    EXPECT_TRUE(data.xTitle.contains("emperature")) << data.xTitle.toStdString();
}

TEST(RankingBars, AnIndexBelowZeroIsSeenAsWhatItIs) {
    RankingBars bars;
    const auto estimate = [](double value, double low, double high) {
        return Estimate{value, 0.02, low, high};
    };
    bars.setBars({{"a", estimate(0.6, 0.5, 0.7), estimate(0.7, 0.6, 0.8)},
                  {"b", estimate(-0.08, -0.2, 0.04), estimate(-0.03, -0.1, 0.05)}});
    EXPECT_LE(bars.axis().least, -0.2);
    EXPECT_GE(bars.axis().most, 0.7);
    EXPECT_TRUE(bars.caption().contains("below 0")) << bars.caption().toStdString();
    // Both marks of the second bar's interval lie inside of the axis.
    bars.resize(420, 260);
    test::keepScreenshot(bars, "ranking-negative");
    bars.setBars({{"a", estimate(0.6, 0.5, 0.7), estimate(0.7, 0.6, 0.8)}});
    EXPECT_EQ(bars.axis().least, 0.0);
    EXPECT_FALSE(bars.caption().contains("below 0"));
}

} // namespace
} // namespace smat::gui
