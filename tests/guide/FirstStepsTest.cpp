#include <map>

#include <QDockWidget>
#include <QTabBar>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "gui/database/CopyEntriesDialog.h"
#include "gui/plot/PolarPlot.h"
#include "irsg/core/Errors.h"
#include "tests/guide/GuideFixture.h"

namespace smat::gui {
namespace {

/// What a person does on the first day: paint an aircraft, heat its engines, see it.
class FirstStepsTest : public test::GuideFixture {
  protected:
    /// A copy of the sample aircraft in a small picture from ahead and above.
    void openAircraft(const std::map<std::string, std::string>& more, bool withDatabase) {
        std::map<std::string, std::string> settings{
            {"sensor.width", "320"},     {"sensor.height", "256"},    {"sensor.fov", "3"},
            {"camera.azimuth", "60"},    {"camera.elevation", "12"},  {"camera.range", "900"},
            {"target.altitude", "1500"}, {"render.antialiasing", "0"}};
        settings.insert(more.begin(), more.end());
        openCopy("turboprop4", settings, withDatabase);
    }
    void walkTheRest(test::GuideWalk& walk, SceneView& view) {
        walk.step(
            "Look around. Drag with the left button to turn the model, use the wheel to come "
            "nearer: that is the inspection camera, which changes nothing, while a corner shows "
            "what the sensor sees. F7 goes back to the sensor.");
        const QPointF middle(view.rect().center());
        drag(&view, Qt::LeftButton, middle, {60, 20});
        wheel(&view, middle, 2);
        EXPECT_TRUE(view.cameras().isInspecting());
        EXPECT_FALSE(workbench.isModified());
        QTest::qWait(60);
        EXPECT_FALSE(view.insetRect().isNull());
        act("inspectionCamera");
        EXPECT_FALSE(view.cameras().isInspecting());
        write(get<QLineEdit>("camera.azimuth"), "150");
        EXPECT_EQ(workbench.camera().azimuth_deg, 150.0);
        EXPECT_LT(view.projection().eye.forward().y, 0.0 + 1.0);
        EXPECT_GT(irsg::dot(view.projection().eye.forward(), {0, 1, 0}), 0.5) << "from behind";

        walk.step(
            "See it in the infrared. View → Infrared display (Ctrl+Shift+I) shows the apparent "
            "radiance in the sensor's band");
        view.showWholeModel();
        EXPECT_EQ(get<QAction>("infraredDisplay")->shortcut(), QKeySequence("Ctrl+Shift+I"));
        act("infraredDisplay");
        const auto sum = [&] { return sumOfPicture(view); };
        const double before = sum();
        const auto& values = view.shownPicture()->image->primary().values;
        std::vector<float> sorted(values.begin(), values.end());
        std::ranges::sort(sorted);
        EXPECT_GT(sorted.back(), 20.0F * sorted[sorted.size() / 2]) << "the pipes shine";

        walk.step("Paint it. Open the signature database at the side (View → Signature database). "
                  "Click on the fuselage: the tab Material shows the material of that face, grey "
                  "paint. Lower its emissivity, for example to 0.3, by typing into the table");
        int grey = 0;
        for (const auto& [index, material] : session().value().materials) {
            grey = material.name == "grey paint" ? index : grey;
        }
        QPoint fuselage;
        for (int y = 10; y < view.height() && fuselage.isNull(); y += 7) {
            for (int x = 10; x < view.width() && fuselage.isNull(); x += 7) {
                if (const auto hits = view.facesAt(QPointF(x, y));
                    !hits.empty() && hits.front().codes.material == grey) {
                    fuselage = {x, y};
                }
            }
        }
        ASSERT_FALSE(fuselage.isNull());
        QTest::mouseClick(&view, Qt::LeftButton, {}, fuselage);
        dock().tabs()->setCurrentIndex(0);
        ASSERT_EQ(*dock().current(), (EntryKey{EntryKind::material, grey}));
        EXPECT_EQ(find<QLineEdit>("entryName", find<QWidget>("materialPanel"))->text(),
                  "grey paint");
        runAnalysis("polar"); // of the old paint, to be compared with
        window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
        dock().raise();
        auto* table = find<QWidget>("emissivity")->findChild<NodeTable*>()->model();
        const auto rows = session().value().materials.at(grey).emissivity.wavelengths_um().size();
        for (int row = 0; row < static_cast<int>(rows); ++row) {
            table->setData(table->index(row, 1), "0.3", Qt::EditRole);
        }
        const double painted = sum();
        EXPECT_NE(painted, before);
        test::keepScreenshot(*window, "guide-1-painted");
        EXPECT_TRUE(workbench.undoStack().undoText().contains("emissivity"))
            << workbench.undoStack().undoText().toStdString();
        while (session().isDirty() && workbench.undoStack().canUndo()) {
            workbench.undoStack().undo();
        }
        EXPECT_NEAR(sum(), before, 1e-9 * std::abs(before));
        while (workbench.undoStack().canRedo()) {
            workbench.undoStack().redo();
        }

        walk.step("Heat its engines. In the tab Temperature choose exhaust pipes. The terms of the "
                  "temperature equation are in a tab of their own; raise T_0 by 100 K");
        heatPipes(100.0);
        EXPECT_GT(sum(), painted);
        chooseTab("temperatureTabs", "Result");
        EXPECT_FALSE(find<QLabel>("resultingTemperature")->text().isEmpty());
        test::keepScreenshot(*window, "guide-2-heated");
        act("undo");

        walk.step(
            "Plot it. Analysis → New polar analysis… (Ctrl+3). Run turns the camera around the "
            "aircraft; the plot shows the contrast intensity in W/sr over the aspect, the nose "
            "at the top.");
        EXPECT_EQ(get<QAction>("new-polar")->shortcut(), QKeySequence("Ctrl+3"));
        runAnalysis("polar");
        EXPECT_EQ(workbench.results().back().data->table.rowCount(), 4U);
        EXPECT_TRUE(window->currentPage()->polarPlot()->data().radiusTitle.contains("Contrast"));
        const auto edited = session().value();
        while (session().isDirty() && workbench.undoStack().canUndo()) {
            workbench.undoStack().undo();
        }
        selectResults({1});
        get<QToolButton>("rerunResult")->click(); // with the old paint
        ASSERT_TRUE(settled());
        EXPECT_EQ(workbench.results().back().data->table.columns(),
                  workbench.results().front().data->table.columns());
        selectResults({1, 2});
        get<QToolButton>("overlayResults")->click();
        const auto& curves = window->currentPage()->polarPlot()->data().curves;
        ASSERT_EQ(curves.size(), 2U);
        EXPECT_EQ(curves[0].name, "ε 0.3");
        EXPECT_EQ(curves[1].name, "ε 0.7-0.95");
        QTest::qWait(50);
        test::keepScreenshot(*window, "guide-3-plotted");
        while (workbench.undoStack().canRedo()) {
            workbench.undoStack().redo();
        }
        act("undo"); // the engines are as they were when it was plotted

        walk.step("Keep it. Ctrl+S saves the project, Ctrl+Shift+D the signature database; Export… "
                  "(Ctrl+E) writes the plot as a picture or as numbers. The asterisk in the title "
                  "disappears.");
        for (const auto& [action, key] : {std::pair{"saveProject", "Ctrl+S"},
                                          {"saveDatabase", "Ctrl+Shift+D"},
                                          {"exportShown", "Ctrl+E"}}) {
            EXPECT_EQ(get<QAction>(action)->shortcut(), QKeySequence(key)) << action;
        }
        for (const char* name : {"plot.png", "plot.csv"}) {
            chosen = path(name);
            act("exportShown");
            EXPECT_GT(std::filesystem::file_size(folder / name), 100U) << name;
        }
        EXPECT_TRUE(window->isWindowModified());
        trigger("saveDatabase");
        trigger("saveProject");
        EXPECT_TRUE(told.isEmpty()) << said();
        EXPECT_FALSE(session().isDirty());
        EXPECT_FALSE(window->isWindowModified());
        EXPECT_EQ(irsg::loadSignatureFile(folder / "turboprop4.sigdb").database, session().value());
        EXPECT_EQ(session().value(), edited);

        walk.note("From a terminal the same polar plot is");
        walk.step("build/release/bin/smat-batch polar samples/turboprop4/turboprop4.smat --out "
                  "polar.csv");
        terminal("smat-batch polar turboprop4.smat --out polar.csv");
        EXPECT_EQ(ResultTable::load(folder / "polar.csv").columns(),
                  workbench.results()[1].data->table.columns());
    }
};

TEST_F(FirstStepsTest, PaintAnAircraftHeatItsEnginesAndSeeIt) {
    openAircraft({{"state.power", "1"}}, false);
    EXPECT_FALSE(session().isOpen());
    test::keepScreenshot(*window, "first-steps-1-no-database");

    const auto file = folder / "mine.sigdb";
    chosen = QString::fromStdString(file.string());
    find<QPushButton>("newDatabase")->click();
    ASSERT_TRUE(test::waitUntil([&] { return session().isOpen(); }))
        << told.join('\n').toStdString();
    EXPECT_TRUE(session().isDirty());
    EXPECT_GE(session().value().materials.size(), 4U);
    runAnalysis("image");
    const auto cold = workbench.results().back().data->image.primary().values;
    window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);

    // Paint: the grey of the library in place of material 1.
    onDialog = [&](QDialog& dialog) {
        dialog.findChild<QLineEdit*>("copyFilter")->setText("aircraft");
        auto& copy = dynamic_cast<CopyEntriesDialog&>(dialog);
        for (const auto& [index, material] : copy.source().materials) {
            if (material.name != "grey aircraft paint, matt") {
                continue;
            }
            copy.choose({EntryKind::material, index});
            auto* list = copy.findChild<QTreeWidget*>("copyList");
            static_cast<QLineEdit*>(list->itemWidget(list->currentItem(), 2))->setText("1");
            static_cast<QComboBox*>(list->itemWidget(list->currentItem(), 3))->setCurrentIndex(1);
        }
        test::keepScreenshot(dialog, "first-steps-2-library");
    };
    find<QToolButton>("addFromLibrary")->click();
    onDialog = nullptr;
    EXPECT_EQ(session().value().materials.at(1).name, "grey aircraft paint, matt");
    test::keepScreenshot(*window, "first-steps-3-painted");

    // Heat: 250 K more at full power for the exhaust pipes, number 5.
    const int engine = 5;
    dock().select({EntryKind::temperature, engine});
    type("entryName", "engine", find<QWidget>("temperaturePanel"));
    chooseTab("temperatureTabs", "Equation terms");
    find<QTabBar>("termTables")->setCurrentIndex(1);
    fill(find<QWidget>("termsPanel"), {{0, 0}, {1, 250}});
    test::keepScreenshot(*window, "first-steps-4-heated");

    // See it, and keep it.
    runAnalysis("image");
    test::keepScreenshot(*window, "first-steps-5-seen");
    const auto hot = workbench.results().back().data->image.primary().values;
    EXPECT_GT(*std::max_element(hot.begin(), hot.end()),
              2.0F * *std::max_element(cold.begin(), cold.end()));
    window->findChild<QAction*>("saveDatabase")->trigger();
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_EQ(irsg::loadSignatureFile(file).database, session().value());
    runAnalysis("image");
    EXPECT_EQ(workbench.results().back().data->image.primary().values, hot);
}

TEST_F(FirstStepsTest, TheEditorSaysWhatToOpenWhileNothingIs) {
    const auto* empty = dock().findChild<QLabel*>("databaseEmpty");
    EXPECT_FALSE(empty->isHidden());
    openCopy("turboprop4", {});
    EXPECT_TRUE(empty->isHidden());
}

/// The sample itself, from the start page; then a copy that may be written.
TEST_F(FirstStepsTest, TheFirstPageOfTheGuide) {
    test::GuideWalk walk("first-signature");
    walk.step("Ten minutes, with the four-engined aircraft of the samples. In the folder of the "
              "program:");
    walk.step("build/release/bin/smat samples/turboprop4/turboprop4.smat");
    ASSERT_TRUE(opens(SMAT_SOURCE_DIR "/samples/turboprop4/turboprop4.smat"));
    walk.step("or without a file, and then Transport aircraft on the start page.");
    window.reset();
    makeWindow();
    auto* card = get<QToolButton>("sample-turboprop4");
    EXPECT_TRUE(card->text().contains("Transport aircraft")) << card->text().toStdString();
    openAircraft({{"polar.step", "90"}, {"state.power", "0.7"}, {"render.bounces", "0"}}, true);
    walkTheRest(walk, *window->sceneView());
}

} // namespace
} // namespace smat::gui
