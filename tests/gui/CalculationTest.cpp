#include "gui/tools/Calculation.h"

#include <thread>

#include <QLabel>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <gtest/gtest.h>

#include "gui/tools/AtmosphereToolPage.h"
#include "gui/widgets/BackgroundPool.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "tests/gui/GuiEnvironment.h"
#include "tests/gui/SampleProject.h"

namespace smat::gui {
namespace {

/// Work that ends when the test says so, and by itself should nobody ever say it.
struct Held {
    QSemaphore gate;
    std::atomic<bool> done = false;

    Calculation::Work work(int& answer, int value) {
        return [this, &answer, value]() -> std::function<void()> {
            (void)gate.tryAcquire(1, 10000);
            done = true;
            return [&answer, value] { answer = value; };
        };
    }
};

class CalculationTest : public ::testing::Test {
  protected:
    void TearDown() override {
        held.gate.release(8);
        EXPECT_TRUE(backgroundPool().waitForDone(20000));
    }
    Held held;
    int answer = 0;
};

TEST_F(CalculationTest, NothingWaitsForWorkThatWasLeft) {
    auto calculation = std::make_unique<Calculation>();
    const QSignalSpy ended(calculation.get(), &Calculation::ended);
    calculation->start(held.work(answer, 1));
    EXPECT_TRUE(calculation->isRunning());
    calculation->cancel();
    EXPECT_FALSE(calculation->isRunning());
    EXPECT_EQ(ended.count(), 1);
    calculation->start(held.work(answer, 2));
    calculation.reset();
    EXPECT_FALSE(held.done);
    held.gate.release(8);
    EXPECT_TRUE(backgroundPool().waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(answer, 0);
}

TEST_F(CalculationTest, OnlyTheLastOneAskedForAnswers) {
    Calculation calculation;
    const QSignalSpy ended(&calculation, &Calculation::ended);
    calculation.start(held.work(answer, 1));
    calculation.start(held.work(answer, 2));
    held.gate.release(2);
    ASSERT_TRUE(test::waitUntil([&] { return !calculation.isRunning(); }, 20.0));
    EXPECT_EQ(answer, 2);
    EXPECT_EQ(ended.count(), 1);
}

TEST_F(CalculationTest, SaysWhatWasRefused) {
    Calculation calculation;
    QStringList said;
    QObject::connect(&calculation, &Calculation::refused,
                     [&](const QStringList& sentences) { said += sentences; });
    calculation.start([]() -> std::function<void()> {
        throw irsg::InputError({"air.csv", "line 3", "a word", "a number"});
    });
    ASSERT_TRUE(test::waitUntil([&] { return !calculation.isRunning(); }, 20.0));
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said.front().contains("air.csv"));
}

class HeldPage : public AtmosphereToolPage {
  public:
    HeldPage(Workbench& workbench, Held& held, int& answer)
        : AtmosphereToolPage(workbench, {}), held_(held), answer_(answer) {}

  protected:
    Calculation::Work work() override { return held_.work(answer_, 1); }

  private:
    Held& held_;
    int& answer_;
};

TEST_F(CalculationTest, APageThatComputesForASecondTellsForHowLong) {
    Workbench workbench;
    HeldPage page(workbench, held, answer);
    page.resize(900, 600);
    page.show();
    const auto* elapsed = page.findChild<QLabel*>("elapsed");
    EXPECT_FALSE(elapsed->isVisible());
    page.compute();
    EXPECT_TRUE(test::waitUntil([&] { return elapsed->isVisible(); }, 8.0));
    EXPECT_TRUE(page.isRunning());
    EXPECT_TRUE(elapsed->text().endsWith(" s elapsed")) << elapsed->text().toStdString();
    EXPECT_GE(elapsed->text().split(' ').front().toDouble(), 1.0);
    test::keepScreenshot(page, "air-tool-elapsed");
    page.findChild<QPushButton*>("cancel")->click();
    EXPECT_FALSE(elapsed->isVisible());
    EXPECT_FALSE(held.done);
}

} // namespace
} // namespace smat::gui
