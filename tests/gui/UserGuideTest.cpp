#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QTreeWidget>

#include "gui/scenario/ScenarioPage.h"
#include "tests/gui/WindowFixture.h"
#include "tests/guide/GuideWalk.h"

namespace smat::gui {
namespace {

/// Words of the program that a page of the documentation quotes: *View → Wireframe*, *Run*.
struct Quotation {
    QString page, words;
    QString keys; ///< those named in brackets behind, or none
};

QString plain(QString text) {
    return text.remove('&');
}
/// As a sentence may write it: in small letters, without the dots of an entry that asks.
QString folded(const QString& text) {
    return plain(text).remove(QChar(0x2026)).simplified().toLower();
}

QList<Quotation> quotationsIn(const QString& folder) {
    QList<Quotation> found;
    const QDir pages(QString(SMAT_SOURCE_DIR) + "/" + folder);
    for (const QString& name : pages.entryList({"*.md"}, QDir::Files)) {
        QFile file(pages.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        QString text = QString::fromUtf8(file.readAll());
        using Options = QRegularExpression;
        text.remove(QRegularExpression("```.*?```", Options::DotMatchesEverythingOption));
        text.remove(QRegularExpression("`[^`]*`"));
        text.remove(QRegularExpression("\\*\\*.*?\\*\\*", Options::DotMatchesEverythingOption));
        const QRegularExpression quoted(
            R"(\*([^*]+)\*(?:\s+\(((?:Ctrl|Alt|Shift|F\d|Esc)[^)]*)\))?)");
        for (auto it = quoted.globalMatch(text); it.hasNext();) {
            const auto match = it.next();
            found.push_back({name, match.captured(1).simplified(), match.captured(2)});
        }
    }
    return found;
}

class UserGuideTest : public test::WindowFixture {
  protected:
    void openEverything() {
        openSample();
        onDialog = [this](QDialog& dialog) { collect(dialog); };
        for (const char* analysis : {"polar", "range", "image"}) {
            runAnalysis(analysis);
        }
        accept = false;
        for (const char* name : {"newProject",       "projectProperties",
                                 "firstSignature",   "convertModel",
                                 "preferences",      "options",
                                 "analysisSettings", "compareImages",
                                 "radiativeOutput",  "temperatureProfile",
                                 "hotGas",           "newAir",
                                 "projectAir",       "importAir",
                                 "detectionRange",   "sensorChain",
                                 "monteCarlo",       "frontier",
                                 "menuLibrary",      "showShortcuts",
                                 "findCommand",      "selfTest",
                                 "showAbout",        "keepState"}) {
            trigger(name);
        }
        auto* tabs = window->findChild<QTabWidget*>("tabs");
        chosen = SMAT_SOURCE_DIR "/samples/flyby/flyby.json";
        trigger("openProject");
        chosen.clear();
        auto* scenario = dynamic_cast<ScenarioPage*>(tabs->currentWidget());
        ASSERT_NE(scenario, nullptr);
        EXPECT_TRUE(test::waitUntil([&] { return !scenario->isBusy(); }));
        collect(*scenario);
        scenario->findChild<QToolButton*>("runScenario")->click();
        auto* index = window->findChild<QComboBox*>("paintTemperature");
        emit index->activated(index->count() - 1);
        emit tabs->tabBar()->customContextMenuRequested(tabs->tabBar()->tabRect(1).center());
        collect(*window);
        if (auto* menu = window->findChild<QMenu*>("tabMenu")) {
            menu->close();
        }
    }
    void know(const QString& text) { words_.insert(folded(text)); }
    void collect(QWidget& within) {
        for (const auto* action : within.findChildren<QAction*>()) {
            know(action->text());
        }
        for (const auto* button : within.findChildren<QAbstractButton*>()) {
            know(button->text());
        }
        for (const auto* line : within.findChildren<QLineEdit*>()) {
            know(line->placeholderText());
        }
        for (const auto* label : within.findChildren<QLabel*>()) {
            know(label->text());
        }
        for (const auto* group : within.findChildren<QGroupBox*>()) {
            know(group->title());
        }
        for (const auto* dock : within.findChildren<QDockWidget*>()) {
            know(dock->windowTitle());
        }
        for (const auto* tabs : within.findChildren<QTabBar*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                know(tabs->tabText(i));
            }
        }
        for (const auto* tree : within.findChildren<QTreeWidget*>()) {
            for (int i = 0; i < tree->columnCount(); ++i) {
                know(tree->headerItem()->text(i));
            }
        }
        for (const auto* box : within.findChildren<QComboBox*>()) {
            for (int i = 0; i < box->count(); ++i) {
                know(box->itemText(i));
            }
        }
    }
    bool isKnown(const QString& words) const { return words_.contains(folded(words)); }

    /// The entry that a path through the menus leads to, every word as it stands there.
    const QAction* entryOf(const QStringList& path) const {
        QList<QAction*> entries = window->menuBar()->actions();
        const QAction* found = nullptr;
        for (const QString& step : path) {
            found = nullptr;
            for (const QAction* entry : entries) {
                if (plain(entry->text()) == step) {
                    found = entry;
                }
            }
            if (found == nullptr) {
                return nullptr;
            }
            entries = found->menu() != nullptr ? found->menu()->actions() : QList<QAction*>();
        }
        return found;
    }

    std::set<QString> words_;
};

TEST_F(UserGuideTest, EveryQuotedMenuEntryIsThereUnderThatNameAndKey) {
    openSample();
    int paths = 0;
    for (const char* folder : {"docs/user-guide", "docs"}) {
        for (const Quotation& one : quotationsIn(folder)) {
            const QStringList path = one.words.split(" → ");
            if (path.size() < 2) {
                continue;
            }
            ++paths;
            const QAction* entry = entryOf(path);
            ASSERT_NE(entry, nullptr) << one.page.toStdString() << ": " << one.words.toStdString();
            if (!one.keys.isEmpty()) {
                EXPECT_TRUE(entry->shortcuts().contains(QKeySequence(one.keys)))
                    << one.page.toStdString() << ": " << one.words.toStdString() << " has "
                    << QKeySequence::listToString(entry->shortcuts()).toStdString() << ", not "
                    << one.keys.toStdString();
            }
        }
    }
    EXPECT_GT(paths, 15);
}

/// What a chapter says is done step by step by a test (tests/guide/GuideWalk.h).
TEST(UserGuide, EverySectionOfEveryChapterIsWalkedByATest) {
    QStringList walked;
    const QDir tests(QString(SMAT_SOURCE_DIR) + "/tests/guide");
    for (const QString& name : tests.entryList({"*Test.cpp"}, QDir::Files)) {
        QFile file(tests.filePath(name));
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(file.readAll());
        const QRegularExpression walk(R"rx(GuideWalk walk\("([^"]+)"(?:, "([^"]*)")?\))rx");
        for (auto it = walk.globalMatch(text); it.hasNext();) {
            const auto match = it.next();
            walked << (match.hasCaptured(2) ? match.captured(1) + ": " + match.captured(2)
                                            : match.captured(1));
        }
    }
    const QDir pages(QString(SMAT_SOURCE_DIR) + "/docs/user-guide");
    int chapters = 0;
    for (const QString& name : pages.entryList({"*.md"}, QDir::Files)) {
        const QString chapter = name.chopped(3);
        if (chapter == "README") {
            continue; // the table of contents
        }
        ++chapters;
        for (const QString& section : test::sectionsOf(pages.filePath(name))) {
            EXPECT_TRUE(walked.contains(chapter) || walked.contains(chapter + ": " + section))
                << "no test of tests/guide walks " << name.toStdString() << ", "
                << section.toStdString();
        }
    }
    EXPECT_EQ(chapters, 12);
}

TEST_F(UserGuideTest, KeysInTablesAreThoseOfTheEntriesTheyStandBeside) {
    openSample();
    // A row begins with an entry of a menu and names its keys.
    const QRegularExpression row(
        R"(^\| ([^|]+) \| ((?:Ctrl|Alt|Shift|F\d|Delete|Return)[^| ]*) \|)",
        QRegularExpression::MultilineOption);
    int rows = 0;
    for (const char* folder : {"docs/user-guide", "docs"}) {
        const QDir pages(QString(SMAT_SOURCE_DIR) + "/" + folder);
        for (const QString& name : pages.entryList({"*.md"}, QDir::Files)) {
            QFile file(pages.filePath(name));
            ASSERT_TRUE(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            for (auto it = row.globalMatch(text); it.hasNext();) {
                const auto match = it.next();
                ++rows;
                bool isRight = false;
                for (const auto* action : window->findChildren<QAction*>()) {
                    isRight |= folded(action->text()) == folded(match.captured(1)) &&
                               action->shortcuts().contains(QKeySequence(match.captured(2)));
                }
                EXPECT_TRUE(isRight)
                    << name.toStdString() << ": " << match.captured(0).toStdString();
            }
        }
    }
    EXPECT_GE(rows, 9);
}

TEST_F(UserGuideTest, EveryQuotedWordStandsSomewhereInTheWindowsAndDialogs) {
    openEverything();
    QStringList unknown;
    int count = 0;
    for (const Quotation& one : quotationsIn("docs/user-guide")) {
        if (one.words.contains(" → ")) {
            continue;
        }
        ++count;
        if (!isKnown(one.words)) {
            unknown << one.page + ": " + one.words;
        }
    }
    EXPECT_TRUE(unknown.isEmpty()) << unknown.join('\n').toStdString();
    EXPECT_GT(count, 30);
    EXPECT_FALSE(isKnown("Axes of the view")); // it is called View axes
}

} // namespace
} // namespace smat::gui
