#include <QDockWidget>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabWidget>

#include "gui/database/DatabaseDock.h"
#include "gui/database/NodePlot.h"
#include "gui/tools/AtmosphereToolPage.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

constexpr QSize smallScreen(1280, 800);

class WindowSizeTest : public test::WindowFixture {
  protected:
    bool fits(const char* page) {
        QTest::qWait(30);
        const QSize least = window->minimumSizeHint();
        EXPECT_LE(least.width(), smallScreen.width()) << page;
        EXPECT_LE(least.height(), smallScreen.height()) << page;
        EXPECT_EQ(window->size(), smallScreen) << page;
        return least.width() <= smallScreen.width() && window->size() == smallScreen;
    }
};

TEST_F(WindowSizeTest, EveryPageAndDockFitsASmallScreen) {
    window->resize(smallScreen);
    fits("empty");
    openSample();
    fits("model");
    for (const char* word : {"image", "spectrum", "polar", "time", "range"}) {
        runAnalysis(word);
        fits(word);
    }
    for (const char* tool :
         {"compareImages", "radiativeOutput", "temperatureProfile", "detectionRange", "sensorChain",
          "monteCarlo", "frontier", "newAir", "projectAir"}) {
        trigger(tool);
        fits(tool);
        test::keepScreenshot(*window, std::string("small-") + tool);
    }
    auto* radiative = window->findChild<AtmosphereToolPage*>("radiativePage");
    radiative->compute();
    ASSERT_TRUE(test::waitUntil([&] { return !radiative->isRunning(); }));
    window->findChild<QTabWidget*>("tabs")->setCurrentWidget(radiative);
    fits("radiative output with its plot");
    test::keepScreenshot(*window, "small-radiative-plot");
    for (auto* dock : window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        fits(dock->objectName().toUtf8().constData());
    }
    auto& editor = window->databaseEditor();
    editor.raise();
    for (int i = 0; i < editor.tabs()->count(); ++i) {
        editor.tabs()->setCurrentIndex(i);
        fits("editor");
    }
}

TEST_F(WindowSizeTest, TheDatabaseDoesNotWidenASmallWindow) {
    constexpr QSize small(1024, 700);
    openSample();
    window->findChild<QDockWidget*>("resultsDock")->raise();
    window->resize(small);
    QTest::qWait(30);
    auto& editor = window->databaseEditor();
    editor.raise();
    for (int i = 0; i < editor.tabs()->count(); ++i) {
        editor.tabs()->setCurrentIndex(i);
        QTest::qWait(30);
        EXPECT_EQ(window->size(), small) << i;
        EXPECT_LE(window->minimumSizeHint().width(), small.width()) << i;
    }
    test::keepScreenshot(*window, "small-database");
}

TEST_F(WindowSizeTest, TheLayoutIsKeptForTheNextTime) {
    const auto dock = [this](const char* name) { return window->findChild<QDockWidget*>(name); };
    window->resize(1200, 790);
    dock("sceneDock")->hide();
    window->addDockWidget(Qt::LeftDockWidgetArea, dock("resultsDock"));
    ASSERT_TRUE(window->close());
    makeWindow();
    EXPECT_FALSE(dock("sceneDock")->isVisible());
    EXPECT_EQ(window->dockWidgetArea(dock("resultsDock")), Qt::LeftDockWidgetArea);
    EXPECT_EQ(window->dockWidgetArea(dock("databaseDock")), Qt::RightDockWidgetArea);
    // As it was, for the tests that follow.
    QSettings memory(QSettings::IniFormat, QSettings::UserScope, "smat", "workbench");
    for (const QString& key : memory.allKeys()) {
        if (key.startsWith("layout-") || key.startsWith("geometry-")) {
            memory.remove(key);
        }
    }
}

TEST_F(WindowSizeTest, ToolPagesNeedNoScrollingOnASmallScreen) {
    window->resize(smallScreen);
    openSample();
    auto* centre = window->findChild<QScrollArea*>("centre");
    ASSERT_NE(centre, nullptr);
    for (const char* tool : {"compareImages", "radiativeOutput", "temperatureProfile",
                             "detectionRange", "sensorChain", "monteCarlo", "frontier"}) {
        trigger(tool);
        QTest::qWait(30);
        EXPECT_LE(centre->widget()->minimumSizeHint().width(), centre->viewport()->width()) << tool;
        for (auto* side : window->findChild<QTabWidget*>("tabs")
                              ->currentWidget()
                              ->findChildren<QScrollArea*>()) {
            if (side->isVisible() && side->widget() != nullptr) {
                EXPECT_LE(side->widget()->minimumSizeHint().width(), side->viewport()->width())
                    << tool;
                EXPECT_EQ(side->verticalScrollBar()->maximum(), 0) << tool;
            }
        }
    }
}

TEST_F(WindowSizeTest, PagesOfTheAirScrollNowhereSidewaysOnASmallScreen) {
    window->resize(smallScreen);
    openSample();
    auto* centre = window->findChild<QScrollArea*>("centre");
    for (const char* tool : {"newAir", "projectAir"}) {
        trigger(tool);
        QTest::qWait(30);
        EXPECT_LE(centre->widget()->minimumSizeHint().width(), centre->viewport()->width()) << tool;
        EXPECT_EQ(centre->horizontalScrollBar()->maximum(), 0) << tool;
        EXPECT_EQ(centre->verticalScrollBar()->maximum(), 0) << tool;
    }
}

TEST_F(WindowSizeTest, TheDatabaseEditorNeedsNoScrollingOnASmallScreen) {
    window->resize(smallScreen);
    openSample();
    auto& editor = window->databaseEditor();
    editor.show();
    editor.raise();
    const auto* scroll = qobject_cast<QScrollArea*>(editor.widget());
    ASSERT_NE(scroll, nullptr);
    const auto fitsEditor = [&](const QString& page) {
        QTest::qWait(30);
        EXPECT_EQ(scroll->verticalScrollBar()->maximum(), 0) << page.toStdString();
        EXPECT_EQ(scroll->horizontalScrollBar()->maximum(), 0) << page.toStdString();
        for (const auto* plot : editor.findChildren<NodePlot*>()) {
            if (plot->isVisible()) {
                EXPECT_EQ(plot->visibleRegion().boundingRect(), plot->rect()) << page.toStdString();
            }
        }
    };
    int pages = 0;
    for (int i = 0; i < editor.tabs()->count(); ++i) {
        editor.tabs()->setCurrentIndex(i);
        fitsEditor(editor.tabs()->tabText(i));
        for (auto* inner : editor.tabs()->currentWidget()->findChildren<QTabWidget*>()) {
            for (int k = 0; k < inner->count(); ++k) {
                if (!inner->isTabVisible(k)) {
                    continue;
                }
                inner->setCurrentIndex(k);
                fitsEditor(editor.tabs()->tabText(i) + ", " + inner->tabText(k));
                test::keepScreenshot(*window, "small-editor-" + std::to_string(++pages));
            }
        }
    }
    EXPECT_GE(pages, 8);
}

} // namespace
} // namespace smat::gui
