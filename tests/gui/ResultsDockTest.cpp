#include "gui/analysis/ResultsDock.h"

#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeWidget>

#include "gui/analysis/AnalysisGeneratorDialog.h"
#include "gui/analysis/FloatingPages.h"
#include "gui/analysis/ResultPage.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/ResultList.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class ResultsDockTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        if (!IsSkipped()) {
            openSample();
        }
    }
    QListWidget* list() const { return window->findChild<QListWidget*>("resultList"); }
    QAction* action(const char* name) const {
        return window->findChild<QAction*>(QString(name) + "Action");
    }
    void choose(const QList<int>& rows) {
        list()->clearSelection();
        for (const int row : rows) {
            list()->item(row)->setSelected(true);
        }
    }
    void settle() {
        ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
        QTest::qWait(20);
    }
    QString path(const char* name) const {
        return QString::fromStdString((folder / name).string());
    }
};

TEST_F(ResultsDockTest, TellsWhenHowLongAndWhatWasAsked) {
    runAnalysis("range");
    const QString detail = list()->item(0)->data(Qt::UserRole + 1).toString();
    EXPECT_TRUE(detail.contains(" s · ")) << detail.toStdString();
    EXPECT_TRUE(detail.contains(" · range ")) << detail.toStdString();
    EXPECT_TRUE(list()->item(0)->toolTip().contains("5 cases, range "));
    EXPECT_TRUE(list()->item(0)->toolTip().contains("Highest contrast intensity"));
}

TEST_F(ResultsDockTest, RunsAgainAndGivesTheSameNumbers) {
    runAnalysis("polar");
    workbench.set("sensor.band", "8-12"); // the result remembers what it was asked
    choose({0});
    action("rerunResult")->trigger();
    settle();
    ASSERT_EQ(workbench.results().size(), 2U);
    EXPECT_EQ(workbench.results()[0].data->table, workbench.results()[1].data->table);
}

TEST_F(ResultsDockTest, EditsWhatWasAskedAndRunsAgain) {
    runAnalysis("polar");
    choose({0});
    onDialog = [](QDialog& dialog) {
        QLineEdit* step = dialog.findChild<QComboBox*>("polar.step")->lineEdit();
        step->selectAll();
        QTest::keyClicks(step, "90");
    };
    action("editResult")->trigger();
    settle();
    ASSERT_EQ(workbench.results().size(), 2U);
    EXPECT_EQ(workbench.results()[1].data->table.rowCount(), 4U);
    EXPECT_EQ(workbench.settings().text("polar.step"), "30");
}

TEST_F(ResultsDockTest, RenamesInPlaceAndOnItsPage) {
    runAnalysis("range");
    choose({0});
    list()->setFocus();
    action("renameResult")->trigger();
    ASSERT_NO_FATAL_FAILURE(test::typeNewName(*list(), "cold morning"));
    EXPECT_EQ(workbench.results()[0].title, "cold morning");
    EXPECT_EQ(window->findChild<QTabWidget*>("tabs")->tabText(1), "cold morning");
    EXPECT_EQ(window->currentPage()->cartesianPlot()->data().curves[0].name, "cold morning");
    workbench.resultStore().rename(1, "  ");
    EXPECT_EQ(workbench.results()[0].title, "cold morning");
}

TEST_F(ResultsDockTest, ShowsTheCommandLineAndCopiesIt) {
    test::keepClipboard();
    runAnalysis("polar");
    choose({0});
    bool seen = false;
    onDialog = [&](QDialog& dialog) {
        const QString text = dialog.findChild<QPlainTextEdit*>("commandLine")->toPlainText();
        EXPECT_TRUE(text.startsWith("smat-batch polar ")) << text.toStdString();
        dialog.findChild<QPushButton*>("copyCommand")->click();
        EXPECT_EQ(QApplication::clipboard()->text(), text);
        const auto* list = dialog.findChild<QTreeWidget*>("provenance");
        EXPECT_GT(list->topLevelItemCount(), 8);
        for (const char* stage : {"Time: load", "Time: set up", "Time: analyse", "Time: sum"}) {
            EXPECT_EQ(list->findItems(stage, Qt::MatchStartsWith).isEmpty(), false) << stage;
        }
        test::keepScreenshot(dialog, "result-details");
        seen = true;
    };
    action("showCommandLine")->trigger();
    EXPECT_TRUE(seen);
    // The stages leave nothing of the run out.
    const AnalysisData& data = *workbench.results().front().data;
    double sum_s = 0.0;
    for (const auto& stage : data.stages) {
        sum_s += stage.seconds;
    }
    EXPECT_GE(sum_s, data.elapsed_s);
}

TEST_F(ResultsDockTest, SavesInEveryFormAndOpensAsAResultAgain) {
    runAnalysis("polar");
    runAnalysis("image");
    const auto saved = [&](int row, const char* name) {
        choose({row});
        chosen = path(name);
        action("saveResult")->trigger();
        EXPECT_GT(std::filesystem::file_size(folder / name), 100U) << name;
    };
    for (const char* name : {"p.csv", "p.json"}) {
        saved(0, name);
    }
    for (const char* name : {"i.exr", "i.csv", "i.png", "i.json"}) {
        saved(1, name);
    }
    for (const char* name : {"p.csv", "p.json", "i.exr", "i.csv"}) {
        chosen = path(name);
        action("openResult")->trigger();
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
        const ResultEntry& opened = workbench.results().back();
        EXPECT_EQ(opened.origin, ResultEntry::Origin::file) << name;
        ASSERT_NE(window->currentPage(), nullptr) << name;
        if (*name == 'p') {
            EXPECT_EQ(opened.data->table, workbench.results()[0].data->table) << name;
            EXPECT_NE(window->currentPage()->polarPlot(), nullptr) << name;
        } else {
            EXPECT_EQ(opened.data->image.primary().values,
                      workbench.results()[1].data->image.primary().values)
                << name;
            EXPECT_NE(window->currentPage()->imageView(), nullptr) << name;
        }
        EXPECT_FALSE(opened.data->commandLine.empty()) << name;
        // What was asked is not in a file.
        EXPECT_FALSE(action("rerunResult")->isEnabled()) << name;
    }
    chosen = path("missing.csv");
    action("openResult")->trigger();
    EXPECT_EQ(told.size(), 1);
    EXPECT_TRUE(told.value(0).contains("missing.csv"));
    test::keepScreenshot(*window, "window-results");
}

TEST_F(ResultsDockTest, SubtractsTwoResultsOnOneAxis) {
    runAnalysis("range");
    workbench.set("sensor.band", "8-12");
    runAnalysis("range");
    choose({0, 1});
    action("subtractResults")->trigger();
    ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    ASSERT_EQ(workbench.results().size(), 3U);
    const auto& difference = workbench.results()[2].data->table;
    const auto& a = workbench.results()[0].data->table.find("contrast_intensity")->values;
    const auto& b = workbench.results()[1].data->table.find("contrast_intensity")->values;
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_DOUBLE_EQ(difference.find("difference_contrast_intensity")->values[i], a[i] - b[i]);
    }
    const auto& shown = window->currentPage()->cartesianPlot()->data();
    EXPECT_EQ(shown.yTitle, "Difference of contrast intensity (W·sr⁻¹)");
    test::keepScreenshot(*window, "window-difference");

    // Results that do not fit are refused in a sentence.
    runAnalysis("polar");
    choose({0, 3});
    action("subtractResults")->trigger();
    EXPECT_EQ(told.size(), 1);
    EXPECT_TRUE(told.value(0).contains("angle [deg]")) << told.join('\n').toStdString();
    EXPECT_EQ(workbench.results().size(), 4U);
}

TEST_F(ResultsDockTest, RefusesToOverlayWhatDoesNotFit) {
    runAnalysis("range");
    runAnalysis("time");
    choose({0, 1});
    action("overlayResults")->trigger();
    EXPECT_EQ(told.size(), 1);
    EXPECT_TRUE(told.value(0).contains("as in 1  Range plot")) << told.join('\n').toStdString();
    told.clear();
    runAnalysis("image");
    choose({0, 2});
    EXPECT_FALSE(action("overlayResults")->isEnabled());
    EXPECT_FALSE(action("subtractResults")->isEnabled());
}

TEST_F(ResultsDockTest, PagesFloatAndComeBack) {
    runAnalysis("range");
    auto* tabs = window->findChild<QTabWidget*>("tabs");
    auto* pages = tabs->findChild<FloatingPages*>();
    ASSERT_NE(pages, nullptr);
    QWidget* page = window->currentPage();
    pages->detach(page);
    QTest::qWait(30);
    EXPECT_EQ(tabs->count(), 1);
    EXPECT_TRUE(pages->isDetached(page));
    EXPECT_TRUE(page->isVisible());
    auto* floating = window->findChild<QWidget*>("floatingPage");
    ASSERT_NE(floating, nullptr);
    EXPECT_EQ(floating->windowTitle(), "1  Range plot");
    test::keepScreenshot(*floating, "floating-page");
    // A floating page follows its result, and is found instead of shown twice.
    workbench.resultStore().rename(1, "far");
    EXPECT_EQ(floating->windowTitle(), "far");
    choose({0});
    action("showResult")->trigger();
    EXPECT_EQ(tabs->count(), 1);
    floating->findChild<QToolButton*>("attachPage")->click();
    EXPECT_EQ(tabs->count(), 2);
    EXPECT_EQ(window->currentPage(), page);

    pages->detach(page);
    workbench.removeResult(1);
    QTest::qWait(20);
    EXPECT_TRUE(pages->pages().empty());
    EXPECT_EQ(window->findChild<QWidget*>("floatingPage"), nullptr);
}

TEST_F(ResultsDockTest, ClosesWithFloatingPages) {
    runAnalysis("range");
    window->findChild<QTabWidget*>("tabs")->findChild<FloatingPages*>()->detach(
        window->currentPage());
    window.reset();
    EXPECT_EQ(workbench.results().size(), 1U);
}

TEST_F(ResultsDockTest, LooksRightInTheDark) {
    applyTheme(*qApp, ThemeMode::dark);
    window.reset();
    makeWindow();
    openSample();
    runAnalysis("range");
    runAnalysis("polar");
    // How much of a widget is of that lightness: its ground, not what is written on it.
    const auto share = [](QWidget& widget, int least, int most) {
        const QImage picture = widget.grab().toImage();
        long found = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const int lightness = picture.pixelColor(x, y).lightness();
                found += lightness >= least && lightness <= most;
            }
        }
        return static_cast<double>(found) / (picture.width() * picture.height());
    };
    const auto isDarkThere = [&](QWidget& widget) {
        EXPECT_GT(share(widget, 0, 90), 0.7) << widget.objectName().toStdString();
        // Something is written on it, and can be read.
        EXPECT_GT(share(widget, 150, 255), 0.001) << widget.objectName().toStdString();
    };
    isDarkThere(*window->currentPage());
    isDarkThere(*list());
    test::keepScreenshot(*window, "window-results-dark");
    choose({1});
    onDialog = [&](QDialog& dialog) {
        isDarkThere(dialog);
        test::keepScreenshot(dialog, "result-details-dark");
    };
    action("showCommandLine")->trigger();
    accept = false;
    onDialog = [&](QDialog& dialog) {
        isDarkThere(dialog);
        test::keepScreenshot(dialog, "dialog-edit-dark");
    };
    action("editResult")->trigger();
    applyTheme(*qApp, ThemeMode::light);
    QTest::qWait(50);
    // Open pages follow the theme.
    EXPECT_GT(share(*window->currentPage(), 200, 255), 0.7);
    EXPECT_GT(share(*list(), 200, 255), 0.7);
    test::keepScreenshot(*window, "window-results-light-again");
}

} // namespace
} // namespace smat::gui
