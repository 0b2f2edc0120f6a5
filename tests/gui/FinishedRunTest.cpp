#include <QStatusBar>
#include <QTabWidget>

#include "gui/analysis/AnalysisJob.h"
#include "gui/analysis/ResultPage.h"
#include "gui/analysis/ResultPages.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class FinishedRunTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        openSample();
        tabs = window->findChild<QTabWidget*>("tabs");
        ASSERT_NE(tabs, nullptr);
    }
    /// Starts a short sweep, does something meanwhile, and waits for its end.
    void runs(const std::function<void()>& meanwhile, const char* step_deg = "60") {
        Settings settings = workbench.settings();
        settings.set("polar.step", step_deg);
        workbench.start(AnalysisData::of(workbench.project(), AnalysisKind::polar, settings));
        ASSERT_TRUE(test::waitUntil([this] { return workbench.isRunning(); }));
        QTest::qWait(100);
        meanwhile();
        ASSERT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }));
        QTest::qWait(50);
    }
    QTabWidget* tabs = nullptr;
};

TEST_F(FinishedRunTest, ComesToTheFrontWhereOneWaitsForIt) {
    runs([] {});
    EXPECT_EQ(tabs->currentIndex(), 1);
    EXPECT_NE(qobject_cast<ResultPage*>(tabs->currentWidget()), nullptr);
}

TEST_F(FinishedRunTest, TakesNoPageAwayFromWorkAndHasADotUntilItIsLookedAt) {
    runs([this] { QTest::keyClick(window.get(), Qt::Key_Shift); });
    ASSERT_EQ(tabs->count(), 2);
    EXPECT_EQ(tabs->currentIndex(), 0) << "the page in front stays";
    EXPECT_TRUE(window->statusBar()->currentMessage().contains("a dot marks its tab"))
        << window->statusBar()->currentMessage().toStdString();
    const QImage dotted = tabs->tabIcon(1).pixmap(tabs->iconSize()).toImage();
    tabs->setCurrentIndex(1);
    EXPECT_NE(tabs->tabIcon(1).pixmap(tabs->iconSize()).toImage(), dotted);
    EXPECT_NE(qobject_cast<ResultPage*>(tabs->currentWidget()), nullptr);
}

TEST_F(FinishedRunTest, OfWhichAPartIsThereSaysSo) {
    ResultPages* pages = window->findChild<ResultPages*>();
    ASSERT_NE(pages, nullptr);
    QStringList said;
    QObject::connect(pages, &ResultPages::said, [&](const QString& sentence) { said << sentence; });
    bool hasBegun = false;
    const auto cancelOnTheWay = [&] {
        QTest::keyClick(window.get(), Qt::Key_Shift);
        QObject::connect(
            workbench.job(), &AnalysisJob::progressed, window.get(),
            [&](const smat::Progress& progress) { hasBegun = hasBegun || progress.done > 1; });
        ASSERT_TRUE(test::waitUntil([&] { return hasBegun; }));
        workbench.cancel();
    };
    runs(cancelOnTheWay, "1");
    ASSERT_FALSE(said.isEmpty());
    EXPECT_TRUE(said.back().contains("is partial: a dot marks its tab"))
        << said.back().toStdString();
}

} // namespace
} // namespace smat::gui
