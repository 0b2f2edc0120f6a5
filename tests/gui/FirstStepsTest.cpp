#include <map>

#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTabBar>
#include <QToolButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include "gui/analysis/ResultPage.h"
#include "gui/database/CopyEntriesDialog.h"
#include "gui/plot/PolarPlot.h"
#include "irsg/radiometry/Errors.h"
#include "tests/gui/DatabaseFixture.h"

namespace smat::gui {
namespace {

/// What a person does on the first day: paint an aircraft, heat its engines, see it.
class FirstStepsTest : public test::DatabaseFixture {
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

/// The first page of the user guide, docs/user-guide/first-signature.md, step by step.
TEST_F(FirstStepsTest, TheEditorSaysWhatToOpenWhileNothingIs) {
    const auto* empty = dock().findChild<QLabel*>("databaseEmpty");
    EXPECT_FALSE(empty->isHidden());
    openCopy("turboprop4", {});
    EXPECT_TRUE(empty->isHidden());
}

TEST_F(FirstStepsTest, TheFirstPageOfTheGuide) {
    openAircraft({{"polar.step", "90"}, {"state.power", "0.7"}}, true);
    SceneView& view = *window->sceneView();
    const auto sum = [&] {
        EXPECT_TRUE(test::waitUntil([&] { return view.isUpToDate(); }));
        double all = 0.0;
        for (const float value : view.shownPicture()->image->primary().values) {
            all += static_cast<double>(value);
        }
        return all;
    };

    // See it in the infrared, from behind.
    view.showWholeModel();
    window->findChild<QAction*>("infraredDisplay")->trigger();
    workbench.set("camera.azimuth", "150");
    const double before = sum();

    // Paint it: a click on the fuselage shows its material, and a lower emissivity shows at once.
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
    EXPECT_EQ(find<QLineEdit>("entryName", find<QWidget>("materialPanel"))->text(), "grey paint");
    auto* table = find<QWidget>("emissivity")->findChild<NodeTable*>()->model();
    const auto rows = session().value().materials.at(grey).emissivity.wavelengths_um().size();
    for (int row = 0; row < static_cast<int>(rows); ++row) {
        table->setData(table->index(row, 1), "0.3", Qt::EditRole);
    }
    const double painted = sum();
    EXPECT_NE(painted, before);
    test::keepScreenshot(*window, "guide-1-painted");

    // Ctrl+Z takes any step back, by name.
    EXPECT_TRUE(workbench.undoStack().undoText().contains("emissivity"))
        << workbench.undoStack().undoText().toStdString();
    while (session().isDirty() && workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    EXPECT_NEAR(sum(), before, 1e-9 * std::abs(before));
    while (workbench.undoStack().canRedo()) {
        workbench.undoStack().redo();
    }

    // Heat its engines: T0 of the exhaust pipes up by 100 K.
    heatPipes(100.0);
    EXPECT_GT(sum(), painted);
    test::keepScreenshot(*window, "guide-2-heated");

    // Plot it, and keep it.
    runAnalysis("polar");
    EXPECT_EQ(workbench.results().back().data->table.rowCount(), 4U);
    const auto edited = session().value();
    while (session().isDirty() && workbench.undoStack().canUndo()) {
        workbench.undoStack().undo();
    }
    auto* list = window->findChild<QListWidget*>("resultList");
    list->setCurrentRow(0);
    window->findChild<QToolButton*>("rerunResult")->click();
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
    QTest::qWait(50);
    list->selectAll();
    window->findChild<QToolButton*>("overlayResults")->click();
    const auto& curves = window->currentPage()->polarPlot()->data().curves;
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_NE(curves[0].y, curves[1].y) << "before and after";
    QTest::qWait(50);
    test::keepScreenshot(*window, "guide-3-plotted");
    while (workbench.undoStack().canRedo()) {
        workbench.undoStack().redo();
    }
    EXPECT_EQ(session().value(), edited);
    trigger("saveDatabase");
    trigger("saveProject");
    EXPECT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    EXPECT_FALSE(session().isDirty());
    EXPECT_EQ(irsg::loadSignatureFile(folder / "turboprop4.sigdb").database, session().value());
}

} // namespace
} // namespace smat::gui
