#include "gui/tools/SelfTestDialog.h"

#include <QCheckBox>
#include <QClipboard>
#include <QElapsedTimer>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "smatcore/selftest/SelfTest.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

class SelfTestDialogTest : public test::WindowFixture {
  protected:
    /// Opens it from the menu and does that in it.
    void inDialog(const std::function<void(SelfTestDialog&)>& work) {
        bool done = false;
        onDialog = [&](QDialog& dialog) {
            auto* opened = dynamic_cast<SelfTestDialog*>(&dialog);
            ASSERT_NE(opened, nullptr);
            dialog.show();
            work(*opened);
            done = true;
        };
        trigger("selfTest");
        EXPECT_TRUE(done);
    }
    static void press(const SelfTestDialog& dialog, const char* name) {
        QTest::mouseClick(dialog.findChild<QPushButton*>(name), Qt::LeftButton);
    }
};

TEST_F(SelfTestDialogTest, RunsEveryCheckAndTellsOfEach) {
    inDialog([](SelfTestDialog& dialog) {
        press(dialog, "selfTestStart");
        EXPECT_TRUE(dialog.isRunning());
        EXPECT_EQ(dialog.findChild<QPushButton*>("selfTestStart")->text(), "Stop");
        ASSERT_TRUE(test::waitUntil([&] { return !dialog.isRunning(); }, 120.0));
        const auto* table = dialog.findChild<QTreeWidget*>("selfTestTable");
        EXPECT_EQ(static_cast<std::size_t>(table->topLevelItemCount()), selfTestChecks().size());
        EXPECT_EQ(table->topLevelItem(0)->text(0).toStdString(), selfTestChecks().front().name);
        EXPECT_EQ(table->topLevelItem(0)->toolTip(0).toStdString(), selfTestChecks().front().says);
        const QString counts = dialog.findChild<QLabel*>("selfTestCounts")->text();
        EXPECT_TRUE(counts.contains(" 0 failed")) << counts.toStdString();
        press(dialog, "selfTestCopy");
        const QString copied = QGuiApplication::clipboard()->text();
        EXPECT_TRUE(copied.contains("radiometry.wien")) << copied.toStdString();
        EXPECT_TRUE(copied.contains(counts));
        test::keepScreenshot(dialog, "self-test");
    });
}

TEST_F(SelfTestDialogTest, StopsAfterTheCheckThatRuns) {
    inDialog([](SelfTestDialog& dialog) {
        dialog.findChild<QCheckBox*>("selfTestHard")->setChecked(false);
        press(dialog, "selfTestStart");
        press(dialog, "selfTestStart");
        ASSERT_TRUE(test::waitUntil([&] { return !dialog.isRunning(); }, 60.0));
        EXPECT_LT(static_cast<std::size_t>(
                      dialog.findChild<QTreeWidget*>("selfTestTable")->topLevelItemCount()),
                  selfTestChecks({.hard = false, .only = {}}).size());
        EXPECT_EQ(dialog.findChild<QPushButton*>("selfTestStart")->text(), "Start");
    });
}

TEST_F(SelfTestDialogTest, ClosesAtOnceWhileItRuns) {
    QElapsedTimer closing;
    inDialog([&](SelfTestDialog& dialog) {
        press(dialog, "selfTestStart");
        closing.start();
    });
    EXPECT_LT(closing.elapsed(), 2000);
}

} // namespace
} // namespace smat::gui
