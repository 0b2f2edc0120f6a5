#include <set>

#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QStatusBar>
#include <QTabWidget>
#include <QTreeWidget>

#include "gui/CommandPalette.h"
#include "gui/widgets/Memory.h"
#include "gui/workbench/PageTabs.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

/// Chooses every entry of the menus, as somebody does who looks what a new program can do.
class EveryActionTest : public test::WindowFixture {
  protected:
    void SetUp() override {
        WindowFixture::SetUp();
        // Files of other tests would be opened again, and saved.
        memory().remove("recentFiles");
        onDialog = [this](QDialog&) { ++noticed; };
        accept = false;
        people.openFile = [this](QWidget*, const QString&, const QStringList&) {
            ++noticed;
            return chosen;
        };
        people.saveFile = [this](QWidget*, const QString&, const QStringList&, const QString&) {
            ++noticed;
            return QString();
        };
        people.tell = [this](QWidget*, const QString&, const QStringList& sentences) {
            ++noticed;
            told += sentences;
        };
        people.ask = [this](QWidget*, const QString&, const QString&, const QStringList&) {
            ++noticed;
            return -1;
        };
        makeWindow();
    }

    static void collect(const QMenu& menu, const QString& path,
                        std::vector<QPointer<QAction>>& entries, std::vector<QString>& paths) {
        for (QAction* action : menu.actions()) {
            const QString name = path + " > " + QString(action->text()).remove('&');
            // Samples are opened where they lie, and what comes later would change them.
            if (action->isSeparator() || name.startsWith("File > Samples")) {
                continue;
            }
            if (action->menu()) {
                emit action->menu()->aboutToShow();
                collect(*action->menu(), name, entries, paths);
                continue;
            }
            entries.push_back(action);
            paths.push_back(path + " > " + action->property("listedAs").toString());
            if (!action->property("listedAs").isValid()) {
                paths.back() = name;
            }
        }
    }

    /// All that a person can see of the window and its clipboard, in short.
    std::vector<QByteArray> sight() {
        std::vector<QByteArray> result;
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (top->isVisible()) {
                const QImage picture = top->grab().toImage().convertToFormat(QImage::Format_RGB32);
                result.emplace_back(reinterpret_cast<const char*>(picture.constBits()),
                                    picture.sizeInBytes());
            }
        }
        result.push_back(QApplication::clipboard()->text().toUtf8());
        result.push_back(QByteArray::number(workbench.undoStack().index()));
        for (const auto* action : window->findChildren<QAction*>()) {
            if (action->isChecked()) {
                result.push_back(action->objectName().toUtf8() + action->text().toUtf8());
            }
        }
        std::ranges::sort(result);
        return result;
    }

    /// Chooses what can be chosen, one after another; entries that did nothing at all.
    QStringList chooseAll() {
        QStringList dead;
        std::vector<QPointer<QAction>> entries;
        std::vector<QString> paths;
        for (const QAction* menu : window->menuBar()->actions()) {
            collect(*menu->menu(), QString(menu->text()).remove('&'), entries, paths);
        }
        // The page that is shown stays for all, so it is closed last.
        auto* tabs = window->findChild<PageTabs*>("tabs");
        const QPointer<QWidget> page = tabs->currentWidget();
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i]->objectName() != "closeResult" && entries[i]->objectName() != "quit") {
                order.push_back(i);
            }
        }
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i]->objectName() == "closeResult") {
                order.push_back(i);
            }
        }
        for (const std::size_t i : order) {
            if (page && tabs->isBeside(page)) {
                tabs->moveAcross(page);
            }
            if (page) {
                tabs->setCurrentWidget(page);
            }
            if (!entries[i] || !entries[i]->isEnabled()) {
                continue;
            }
            chosenEntries.insert(paths[i]);
            QApplication::clipboard()->clear();
            noticed = 0;
            window->statusBar()->clearMessage();
            const auto before = sight();
            entries[i]->trigger();
            QTest::qWait(30);
            // One of several kinds that is chosen already may stay as it is.
            const bool isChosen =
                entries[i] && entries[i]->actionGroup() && entries[i]->isChecked();
            if (noticed == 0 && !workbench.isRunning() && !isChosen && sight() == before) {
                dead << paths[i];
            }
            EXPECT_TRUE(test::waitUntil([this] { return !workbench.isRunning(); }))
                << paths[i].toStdString();
            closeOthers();
        }
        seen.insert(paths.begin(), paths.end());
        return dead;
    }
    void closeOthers() {
        for (QWidget* top : QApplication::topLevelWidgets()) {
            if (top != window.get() && top->isVisible()) {
                top->close();
            }
        }
        QTest::qWait(10);
    }

    int noticed = 0;
    std::set<QString> seen, chosenEntries;
};

TEST_F(EveryActionTest, ThePaletteFindsACommandByItsWordsAndDoesIt) {
    openSample();
    auto* wireframe = window->findChild<QAction*>("wireframe");
    ASSERT_FALSE(wireframe->isChecked());
    accept = true;
    onDialog = [](QDialog& dialog) {
        auto* list = dialog.findChild<QTreeWidget*>("paletteList");
        auto* words = dialog.findChild<QLineEdit*>("paletteWords");
        EXPECT_GT(list->topLevelItemCount(), 30);
        test::keepScreenshot(dialog, "command-palette");
        QTest::keyClicks(words, "no such command");
        EXPECT_EQ(dynamic_cast<CommandPalette&>(dialog).chosen(), nullptr);
        words->clear();
        QTest::keyClicks(words, "WIRE view");
        ASSERT_EQ(list->topLevelItemCount(), 1);
        EXPECT_EQ(list->topLevelItem(0)->text(0).toStdString(), "View → Wireframe");
        EXPECT_EQ(list->topLevelItem(0)->text(1).toStdString(), "Ctrl+Shift+W");
    };
    window->findChild<QAction*>("findCommand")->trigger();
    EXPECT_TRUE(wireframe->isChecked());

    // Arrows go through what fits; what is left with Escape does nothing.
    onDialog = [](QDialog& dialog) {
        auto* words = dialog.findChild<QLineEdit*>("paletteWords");
        QTest::keyClicks(words, "axes");
        const QAction* first = dynamic_cast<CommandPalette&>(dialog).chosen();
        QTest::keyClick(words, Qt::Key_Down);
        EXPECT_NE(dynamic_cast<CommandPalette&>(dialog).chosen(), first);
    };
    accept = false;
    auto* axes = window->findChild<QAction*>("modelAxes");
    const bool before = axes->isChecked();
    window->findChild<QAction*>("findCommand")->trigger();
    EXPECT_EQ(axes->isChecked(), before);
    accept = true;
    window->findChild<QAction*>("findCommand")->trigger();
    EXPECT_NE(axes->isChecked(), before);
}

TEST_F(EveryActionTest, NoEntryOfTheMenusIsDead) {
    test::keepClipboard();
    const QStringList empty = chooseAll();
    EXPECT_TRUE(empty.isEmpty()) << "without a project:\n" << empty.join('\n').toStdString();

    // What shows or saves a state has nothing to do where it is that state already.
    openSample();
    chosen.clear();
    QStringList dead = chooseAll();
    accept = true;
    for (const char* analysis : {"polar", "image"}) {
        runAnalysis(analysis);
    }
    accept = false;
    workbench.target().saveAs(folder / "ship.sigdb"); // the sample stays as it is
    workbench.database().edit("name it", [](auto& database) { database.title = "another"; });
    const QStringList ran = chooseAll();
    dead.removeIf([&](const QString& path) { return !ran.contains(path); });
    EXPECT_TRUE(dead.isEmpty()) << dead.join('\n').toStdString();

    // These have something to do where there are several models (SeveralModelsTest and
    // PlacedModelsTest do it).
    const QStringList ofSeveral{
        "Edit > Make the chosen model the target", "Edit > Remove the chosen model from the scene",
        "View > Fit the chosen model in the view", "View > Show the whole scene"};
    QStringList never;
    for (const QString& path : seen) {
        if (!chosenEntries.contains(path) && path != "File > Quit" && !ofSeveral.contains(path) &&
            path != "File > Open recent > No files yet") {
            never << path;
        }
    }
    EXPECT_TRUE(never.isEmpty()) << never.join('\n').toStdString();
}

} // namespace
} // namespace smat::gui
