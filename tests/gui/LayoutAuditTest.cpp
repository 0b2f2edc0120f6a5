// Nothing of the window lies on something else or is cut, on two small screens.
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include "gui/database/DatabaseDock.h"
#include "gui/tools/AtmosphereToolPage.h"
#include "tests/gui/LayoutAudit.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

TEST(LayoutAudit, FindsWhatIsCutOrCovered) {
    QWidget page;
    page.resize(300, 200);
    auto* label = new QLabel("some words that need their room", &page);
    label->setGeometry(10, 10, 40, 20);
    auto* button = new QToolButton(&page);
    button->setText("Export");
    button->setGeometry(30, 12, 80, 24);
    auto* outside = new QToolButton(&page);
    outside->setGeometry(280, 60, 60, 24);
    auto* box = new QComboBox(&page);
    box->addItem("a long choice of words");
    box->setGeometry(10, 100, 60, 24);
    auto* area = new QScrollArea(&page);
    auto* wide = new QLabel("wider than its area", area);
    wide->setMinimumWidth(200);
    area->setWidget(wide);
    area->setGeometry(180, 120, 110, 70);
    auto* tabs = new QTabBar(&page);
    tabs->addTab("a title of several words");
    tabs->setElideMode(Qt::ElideRight);
    tabs->setGeometry(10, 150, 70, 24);
    page.show();
    const QString faults = test::layoutFaults(page).join('\n');
    EXPECT_TRUE(faults.contains("cut words: QLabel")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("one on the other: QLabel")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut off: QToolButton")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut choice: QComboBox")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("scrolls sideways: QScrollArea")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut off at the right: QLabel")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut tab: QTabBar")) << faults.toStdString();
    EXPECT_EQ(test::layoutFaults(page).size(), 7) << faults.toStdString();
    label->setGeometry(10, 40, label->sizeHint().width(), 20);
    outside->move(200, 60);
    box->resize(240, 24);
    wide->setMinimumWidth(0);
    wide->resize(60, 20);
    wide->setText("fits");
    tabs->resize(tabs->sizeHint());
    EXPECT_EQ(test::layoutFaults(page).join('\n').toStdString(), "");
}

class WindowLayoutTest : public test::WindowFixture {
  protected:
    void look(const char* page) {
        QTest::qWait(60);
        test::waitUntil([this] { return test::layoutFaults(*window).isEmpty(); }, 1.0);
        EXPECT_LE(window->minimumSizeHint().width(), window->width()) << page;
        test::keepScreenshot(*window,
                             QString("layout-%1-%2").arg(window->width()).arg(page).toStdString());
        const QStringList faults = test::layoutFaults(*window);
        EXPECT_TRUE(faults.isEmpty()) << page << ":\n" << faults.join('\n').toStdString();
    }
    /// Every page, every tab of the database and every dock.
    void lookAtAll(const QSize& screen) {
        window->resize(screen);
        look("start");
        openSample();
        look("model");
        trigger("infraredDisplay");
        look("infrared");
        trigger("infraredDisplay");
        for (const char* word : {"image", "spectrum", "time", "range", "polar"}) {
            runAnalysis(word);
            look(word);
        }
        trigger("moveAcross"); // half as wide
        if (screen.width() >= 1280) {
            look("beside");
        } else {
            QTest::qWait(60); // two pages scroll in so little room
            EXPECT_EQ(window->size(), screen);
        }
        trigger("moveAcross");
        lookAtTools();
        trigger("compareImages");
        look("compareImages");
        window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
        lookAtDatabase();
        for (auto* dock : window->findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            look(dock->objectName().toUtf8().constData());
        }
        EXPECT_EQ(window->size(), screen);
    }
    void lookAtDatabase() {
        auto& editor = window->databaseEditor();
        editor.raise();
        for (int i = 0; i < editor.tabs()->count(); ++i) {
            editor.tabs()->setCurrentIndex(i);
            const QString name = "database-" + editor.tabs()->tabText(i);
            look(name.toUtf8().constData());
            for (auto* inner : editor.tabs()->currentWidget()->findChildren<QTabWidget*>()) {
                for (int k = 1; k < inner->count(); ++k) {
                    if (inner->isTabVisible(k)) {
                        inner->setCurrentIndex(k);
                        look((name + "-" + inner->tabText(k)).toUtf8().constData());
                    }
                }
            }
        }
    }
    void lookAtTools() {
        for (const char* tool :
             {"radiativeOutput", "temperatureProfile", "hotGas", "detectionRange", "sensorChain",
              "monteCarlo", "frontier", "newAir", "projectAir"}) {
            trigger(tool);
            look(tool);
        }
    }
};

TEST_F(WindowLayoutTest, NothingIsCutOrCoveredOnASmallScreen) {
    lookAtAll({1280, 800});
}

TEST_F(WindowLayoutTest, NothingIsCutOrCoveredOnAVerySmallScreen) {
    lookAtAll({1024, 700});
    // Forms of tools fold there, and stand beside their results again where there is room.
    trigger("monteCarlo");
    window->resize(1360, 840);
    look("wide");
}

} // namespace
} // namespace smat::gui
