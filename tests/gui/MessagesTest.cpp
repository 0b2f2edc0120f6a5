#include <QApplication>
#include <QClipboard>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeWidget>

#include "gui/MessagesDock.h"
#include "gui/WindowMessages.h"
#include "gui/analysis/ResultPage.h"
#include "irsg/core/Remarks.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

TEST(MessageLog, KeepsWhatWasSaidAndCountsWhatIsSaidAgain) {
    MessageLog log;
    int added = 0, repeated = 0, dropped = 0;
    QObject::connect(&log, &MessageLog::added, &log, [&] { ++added; });
    QObject::connect(&log, &MessageLog::repeated, &log, [&] { ++repeated; });
    QObject::connect(&log, &MessageLog::dropped, &log, [&] { ++dropped; });
    log.add({MessageKind::remark, "a.ac", "no normals"});
    log.add({MessageKind::remark, "a.ac", "no normals"});
    log.add({MessageKind::warning, "a.ac", "no normals"});
    log.add({MessageKind::remark, "a.ac", ""});
    ASSERT_EQ(log.messages().size(), 2u);
    EXPECT_EQ(log.messages().front().count, 2);
    EXPECT_TRUE(log.messages().front().time.isValid());
    EXPECT_EQ(added, 2);
    EXPECT_EQ(repeated, 1);
    for (std::size_t i = 0; i < MessageLog::most; ++i) {
        log.add({MessageKind::remark, {}, QString::number(i)});
    }
    EXPECT_EQ(log.messages().size(), MessageLog::most);
    EXPECT_EQ(dropped, 2);
    EXPECT_EQ(log.messages().front().sentence, "0");
}

class MessagesTest : public test::WindowFixture {
  protected:
    QTreeWidget& list() { return *window->findChild<QTreeWidget*>("messages"); }
    QToolButton& counter() { return *window->findChild<QToolButton*>("messageCount"); }
    QString cell(int row, int column) { return list().topLevelItem(row)->text(column); }
    QString status() { return window->statusBar()->currentMessage(); }
    void pressShow(int row) {
        auto* button = qobject_cast<QToolButton*>(list().itemWidget(list().topLevelItem(row), 3));
        ASSERT_NE(button, nullptr);
        button->click();
    }
};

TEST_F(MessagesTest, AWarningOfAResultIsKeptWithAButtonThatShowsIt) {
    openSample();
    EXPECT_FALSE(counter().isVisible());
    workbench.set("sensor.fov", "1"); // the ship reaches out of it
    runAnalysis("range");
    const ResultEntry& result = workbench.results().back();
    ASSERT_FALSE(result.data->warnings.empty());
    ASSERT_EQ(list().topLevelItemCount(), static_cast<int>(result.data->warnings.size()));
    EXPECT_EQ(cell(0, 1), result.title);
    EXPECT_TRUE(cell(0, 2).contains("reaches beyond the frame")) << cell(0, 2).toStdString();
    EXPECT_TRUE(status().contains("reaches beyond the frame"));
    EXPECT_TRUE(counter().isVisible());
    EXPECT_EQ(counter().text(), QString::number(list().topLevelItemCount()));

    counter().click();
    EXPECT_TRUE(window->findChild<MessagesDock*>()->isVisible());
    EXPECT_FALSE(counter().isVisible());
    window->findChild<PageTabs*>()->setCurrentIndex(0);
    EXPECT_EQ(window->currentPage(), nullptr);
    pressShow(0);
    ASSERT_NE(window->currentPage(), nullptr);
    EXPECT_EQ(window->currentPage()->resultIds(), QList<int>{result.id});

    workbench.removeResult(result.id);
    pressShow(0);
    EXPECT_EQ(status(), "That result is no longer open");
}

TEST_F(MessagesTest, ARemarkOfAReaderNamesItsFileAndLeadsToIt) {
    openSample();
    const Project& project = workbench.project();
    const std::string model = project.resolve(project.models[0].file).string();
    const std::string database = project.resolve(project.models[0].database).string();
    irsg::remarkOn(model, "lines end in CR");
    irsg::remarkOn(database, "an older form");
    irsg::remarkOn("nowhere.csv", "semicolons");
    const int before = list().topLevelItemCount();
    ASSERT_TRUE(test::waitUntil([&] { return list().topLevelItemCount() == before + 3; }));
    EXPECT_EQ(cell(before, 1), "ship.flt");
    EXPECT_EQ(cell(before, 2), "lines end in CR");
    EXPECT_EQ(cell(before + 1, 1), "ship.sigdb");
    EXPECT_EQ(cell(before + 2, 2), "nowhere.csv: semicolons");
    EXPECT_EQ(list().itemWidget(list().topLevelItem(before + 2), 3), nullptr) << "it is no file";
    EXPECT_EQ(status(), "nowhere.csv: semicolons");

    auto* editor = window->findChild<QDockWidget*>("databaseDock");
    editor->hide();
    pressShow(before + 1);
    EXPECT_TRUE(editor->isVisible());
    runAnalysis("range");
    EXPECT_NE(window->currentPage(), nullptr);
    pressShow(before);
    EXPECT_EQ(window->currentPage(), nullptr) << "the model";
}

TEST_F(MessagesTest, WhatADialogToldIsKeptCopiedAndCleared) {
    EXPECT_FALSE(window->open(folder / "none.smat"));
    ASSERT_EQ(told.size(), 1);
    ASSERT_EQ(list().topLevelItemCount(), 1);
    EXPECT_EQ(cell(0, 2), told.front());
    EXPECT_EQ(cell(0, 1), "This file cannot be opened");
    test::keepClipboard();
    window->findChild<QToolButton*>("copyMessages")->click();
    EXPECT_TRUE(QApplication::clipboard()->text().contains("\terror\tThis file cannot be opened\t" +
                                                           told.front()));
    window->findChild<QToolButton*>("clearMessages")->click();
    EXPECT_EQ(list().topLevelItemCount(), 0);
    EXPECT_FALSE(counter().isVisible());
    told.clear();
}

TEST_F(MessagesTest, ARefusedAnalysisLeadsToTheSettings) {
    openSample();
    window->messages().tellRefusal(people, window.get(), "The analysis cannot be run",
                                   {"Sensor: 0"});
    EXPECT_EQ(list().topLevelItemCount(), 0) << "the dialogs of the test are not followed";
    emit workbench.jobFailed({"Sensor, Width: 0"}, false);
    ASSERT_EQ(list().topLevelItemCount(), 1);
    QString shown;
    onDialog = [&](QDialog& dialog) { shown = dialog.objectName(); };
    pressShow(0);
    EXPECT_EQ(shown, "settingsDialog");
    told.clear();
}

TEST_F(MessagesTest, ResultsReadAgainWithTheirProjectSayNothingNew) {
    openSample();
    workbench.set("sensor.fov", "1");
    runAnalysis("range");
    trigger("saveProject");
    ASSERT_EQ(workbench.resultStore().unsavedCount(), 0);
    const auto file = workbench.project().file;
    window->findChild<QToolButton*>("clearMessages")->click();
    ASSERT_TRUE(opens(file));
    ASSERT_TRUE(test::waitUntil([&] { return !workbench.resultStore().isReading(); }));
    QTest::qWait(20);
    ASSERT_EQ(workbench.results().size(), 1u);
    EXPECT_EQ(list().topLevelItemCount(), 0);
}

} // namespace
} // namespace smat::gui
