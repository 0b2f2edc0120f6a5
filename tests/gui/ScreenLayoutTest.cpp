// The layout is kept for each screen. A screen is as large as a process finds it: this test runs
// itself again, on the screen as it is and on the same one with pixels of another size.
#include <QCoreApplication>
#include <QDockWidget>
#include <QProcess>
#include <QScreen>
#include <QSettings>
#include <QTest>
#include <gtest/gtest.h>

#include "gui/MainWindow.h"
#include "smatcore/support/TextFile.h"
#include "tests/gui/GuiEnvironment.h"

namespace smat::gui {
namespace {

constexpr const char* act = "SMAT_TEST_LAYOUT_ACT";        ///< "look", or a dock that is put away
constexpr const char* memories = "SMAT_TEST_LAYOUT_PLACE"; ///< folder of what is remembered

/// A start of the window in a process of its own: what it shows goes to `report`, and what is asked
/// is left behind.
void start(const std::filesystem::path& report) {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, qEnvironmentVariable(memories));
    Workbench workbench;
    MainWindow window(workbench, Dialogs());
    window.show();
    QTest::qWait(60);
    std::string text;
    for (const char* name : {"sceneDock", "resultsDock", "databaseDock"}) {
        const auto* dock = window.findChild<QDockWidget*>(name);
        text += std::string(name) + (dock->isHidden() ? " away, " : " there, ");
        text += window.dockWidgetArea(const_cast<QDockWidget*>(dock)) == Qt::LeftDockWidgetArea
                    ? "left\n"
                    : "right\n";
    }
    const QSize screen = window.screen()->size();
    const bool fits = window.width() <= screen.width() && window.height() <= screen.height();
    text += "screen " + std::to_string(screen.width()) + (fits ? ", fits\n" : ", too large\n");
    writeTextFile(report, text);
    const std::string asked = qEnvironmentVariable(act).toStdString();
    if (asked != "look") {
        auto* dock = window.findChild<QDockWidget*>(QString::fromStdString(asked));
        ASSERT_NE(dock, nullptr) << asked;
        dock->hide();
        window.addDockWidget(Qt::LeftDockWidgetArea, window.findChild<QDockWidget*>("resultsDock"));
    }
    ASSERT_TRUE(window.close());
}

class ScreenLayoutTest : public ::testing::Test {
  protected:
    std::string run(const std::string& what, const char* scale) {
        const std::filesystem::path report = folder / "report";
        std::filesystem::remove(report);
        QProcess process;
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert(act, QString::fromStdString(what));
        environment.insert(memories, QString::fromStdString((folder / "kept").string()));
        environment.insert("SMAT_TEST_LAYOUT_REPORT", QString::fromStdString(report.string()));
        environment.insert("QT_SCALE_FACTOR", scale);
        environment.insert("TMPDIR", QString::fromStdString((folder / "child").string()));
        process.setProcessEnvironment(environment);
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        process.start(QCoreApplication::applicationFilePath(),
                      {QString("--gtest_filter=%1.%2").arg(info->test_suite_name(), info->name())});
        EXPECT_TRUE(process.waitForFinished(60000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardOutput().toStdString();
        return std::filesystem::exists(report) ? readTextFile(report) : "no report";
    }
    std::filesystem::path folder = test::freshFolder("screens");
};

TEST_F(ScreenLayoutTest, EachScreenHasTheLayoutThatItWasLeftWith) {
    if (const QString report = qEnvironmentVariable("SMAT_TEST_LAYOUT_REPORT"); !report.isEmpty()) {
        return start(report.toStdString());
    }
    std::filesystem::create_directories(folder / "kept");
    std::filesystem::create_directories(folder / "child");
    const char *const large = "1", *const small = "1.25";
    const std::string first = run("look", large);
    for (const char* words :
         {"sceneDock there", "databaseDock there", "resultsDock there", ", fits"}) {
        EXPECT_NE(first.find(words), std::string::npos) << first;
    }
    run("sceneDock", large);
    // Another screen: the first start on it, whatever was left on the other.
    const std::string other = run("look", small);
    EXPECT_NE(other.substr(other.find("screen")), first.substr(first.find("screen")))
        << "the screen has not changed";
    EXPECT_NE(other.find("sceneDock there"), std::string::npos) << other;
    EXPECT_NE(other.find("resultsDock there, right"), std::string::npos) << other;
    EXPECT_NE(other.find(", fits"), std::string::npos) << other;
    run("databaseDock", small);
    // And back: each as it was left.
    const std::string back = run("look", large);
    EXPECT_NE(back.find("sceneDock away"), std::string::npos) << back;
    EXPECT_NE(back.find("databaseDock there"), std::string::npos) << back;
    EXPECT_NE(back.find("resultsDock there, left"), std::string::npos) << back;
    const std::string again = run("look", small);
    EXPECT_NE(again.find("sceneDock there"), std::string::npos) << again;
    EXPECT_NE(again.find("databaseDock away"), std::string::npos) << again;
    EXPECT_NE(again.find(", fits"), std::string::npos) << again;
}

} // namespace
} // namespace smat::gui
