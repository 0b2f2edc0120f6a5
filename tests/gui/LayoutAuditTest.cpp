// Nothing of the window lies on something else or is cut, on two small screens.
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
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
    page.show();
    const QString faults = test::layoutFaults(page).join('\n');
    EXPECT_TRUE(faults.contains("cut words: QLabel")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("one on the other: QLabel")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut off: QToolButton")) << faults.toStdString();
    EXPECT_TRUE(faults.contains("cut choice: QComboBox")) << faults.toStdString();
    EXPECT_EQ(test::layoutFaults(page).size(), 4) << faults.toStdString();
    label->setGeometry(10, 40, label->sizeHint().width(), 20);
    outside->move(200, 60);
    box->resize(240, 24);
    EXPECT_EQ(test::layoutFaults(page).join('\n').toStdString(), "");
}

class WindowLayoutTest : public test::WindowFixture {
  protected:
    void look(const char* page) {
        QTest::qWait(60);
        test::keepScreenshot(*window,
                             QString("layout-%1-%2").arg(window->width()).arg(page).toStdString());
        const QStringList faults = test::layoutFaults(*window);
        EXPECT_TRUE(faults.isEmpty()) << page << ":\n" << faults.join('\n').toStdString();
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
    window->resize(1280, 800);
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
    look("beside");
    trigger("moveAcross");
    lookAtTools();
    trigger("compareImages");
    look("compareImages");
    window->findChild<QTabWidget*>("tabs")->setCurrentIndex(0);
    auto& editor = window->databaseEditor();
    editor.raise();
    for (int i = 0; i < editor.tabs()->count(); ++i) {
        editor.tabs()->setCurrentIndex(i);
        look(("database-" + editor.tabs()->tabText(i)).toUtf8().constData());
    }
}

TEST_F(WindowLayoutTest, FormsOfToolsFoldOnAVerySmallScreen) {
    window->resize(1024, 700);
    look("start");
    openSample();
    look("model");
    for (const char* word : {"image", "polar", "range"}) {
        runAnalysis(word);
        look(word);
    }
    lookAtTools();
    // And stand beside their results again where there is room.
    window->resize(1360, 840);
    look("wide");
}

} // namespace
} // namespace smat::gui
