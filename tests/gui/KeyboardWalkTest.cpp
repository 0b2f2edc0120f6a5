#include <fstream>
#include <regex>
#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>

#include "gui/analysis/ResultsDock.h"
#include "gui/database/DatabaseDock.h"
#include "gui/scenario/ScenarioPage.h"
#include "gui/workbench/PageTabs.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

QString nameOf(const QWidget* widget) {
    if (widget == nullptr) {
        return "nothing";
    }
    QString path;
    for (; widget != nullptr && !widget->isWindow(); widget = widget->parentWidget()) {
        if (!widget->objectName().isEmpty() && !widget->objectName().startsWith("qt_")) {
            path = widget->objectName() + (path.isEmpty() ? "" : "/" + path);
        } else if (path.isEmpty()) {
            path = widget->metaObject()->className();
        }
    }
    return path;
}

/// Goes through a window with Tab and back with Shift+Tab, as somebody does who has no mouse.
class Walker {
  public:
    explicit Walker(QWidget& top) : top_(top) {}

    /// What is wrong, a sentence each.
    QStringList walk() {
        problems_.clear();
        const auto wanted = fields();
        if (wanted.empty()) {
            return {};
        }
        const auto forth = goRound(Qt::Key_Tab), back = goRound(Qt::Key_Backtab);
        for (QWidget* field : wanted) {
            if (!reached(field, forth)) {
                problems_ << nameOf(field) + " is not reached by Tab";
            }
            if (!reached(field, back)) {
                problems_ << nameOf(field) + " is not reached by Shift+Tab";
            }
        }
        for (std::size_t i = 1; i < forth.size(); ++i) {
            checkOrder(forth[i - 1], forth[i]);
        }
        return problems_;
    }

  private:
    static bool isField(const QWidget* widget) {
        return widget->isVisible() && widget->isEnabled() && widget->focusProxy() == nullptr &&
               (widget->focusPolicy() & Qt::TabFocus) != 0;
    }
    /// Whether any of it lies inside of all that it lies in.
    static bool isSeen(const QWidget* widget) {
        QRect part = widget->rect();
        for (; !widget->isWindow() && !part.isEmpty(); widget = widget->parentWidget()) {
            part = part.translated(widget->pos()) & widget->parentWidget()->rect();
        }
        return !part.isEmpty();
    }
    std::vector<QWidget*> fields() const {
        std::vector<QWidget*> all;
        for (QWidget* widget : top_.findChildren<QWidget*>()) {
            if (widget->window() == &top_ && isField(widget)) {
                all.push_back(widget);
            }
        }
        return all;
    }
    /// Of buttons that exclude each other the arrows reach those beside the one that has the focus.
    static bool reached(QWidget* field, const std::vector<QWidget*>& way) {
        if (std::ranges::find(way, field) != way.end()) {
            return true;
        }
        const auto* button = qobject_cast<QAbstractButton*>(field);
        return button != nullptr && std::ranges::any_of(way, [&](const QWidget* one) {
                   const auto* other = qobject_cast<const QAbstractButton*>(one);
                   if (other == nullptr) {
                       return false;
                   }
                   return button->group() != nullptr
                              ? button->group() == other->group() && button->group()->exclusive()
                              : button->autoExclusive() && other->autoExclusive() &&
                                    other->parent() == button->parent();
               });
    }
    /// The fields in the order of the key, until the first comes again.
    std::vector<QWidget*> goRound(Qt::Key key) {
        constexpr std::size_t most = 400;
        QWidget* start = first();
        start->setFocus(Qt::TabFocusReason);
        std::vector<QWidget*> way{start};
        while (way.size() < most) {
            QTest::keyClick(way.back(), key);
            QWidget* next = QApplication::focusWidget();
            if (next == way.back() && fields().size() == 1) {
                return way;
            }
            if (next == way.back()) {
                // The links of a text are stops of their own.
                if (++stays_ < most && next->inherits("QTextBrowser")) {
                    continue;
                }
                problems_ << nameOf(next) + " keeps the focus";
                return way;
            }
            stays_ = 0;
            if (next == nullptr || next->window() != &top_) {
                problems_ << "after " + nameOf(way.back()) + " the keys go to " + nameOf(next);
                return way;
            }
            if (!isSeen(next)) {
                problems_ << nameOf(next) + " has the focus and is not seen";
            }
            if (std::ranges::find(way, next) != way.end()) {
                if (next != start) {
                    problems_ << "from " + nameOf(way.back()) + " the way leads back to " +
                                     nameOf(next) + ", not to its beginning";
                }
                return way;
            }
            way.push_back(next);
        }
        problems_ << "the way has no end";
        return way;
    }
    QWidget* first() const {
        const auto all = fields();
        // A question begins at its usual answer.
        const auto isButton = [](const QWidget* one) { return one->inherits("QPushButton"); };
        if (std::ranges::all_of(all, isButton) && top_.focusWidget() != nullptr) {
            return top_.focusWidget();
        }
        for (QWidget* next = top_.nextInFocusChain(); next != &top_;
             next = next->nextInFocusChain()) {
            if (std::ranges::find(all, next) != all.end()) {
                return next;
            }
        }
        return all.front();
    }
    QRect placeOf(QWidget* widget) const {
        return {widget->mapTo(&top_, QPoint(0, 0)), widget->size()};
    }
    /// What scrolls lies elsewhere once another field of it has the focus.
    static const QWidget* panelOf(const QWidget* widget) {
        for (widget = widget->parentWidget(); widget != nullptr && !widget->isWindow();
             widget = widget->parentWidget()) {
            if (widget->inherits("QAbstractScrollArea") || widget->inherits("QDockWidget") ||
                widget->inherits("QTabWidget")) {
                return widget;
            }
        }
        return nullptr;
    }
    /// One reads down and to the right: no step within a panel goes straight up or to the left.
    void checkOrder(QWidget* from, QWidget* to) {
        if (panelOf(from) != panelOf(to)) {
            return;
        }
        const QRect a = placeOf(from), b = placeOf(to);
        const auto overlap = [](int low1, int high1, int low2, int high2) {
            return std::min(high1, high2) - std::max(low1, low2);
        };
        const bool sameColumn = overlap(a.left(), a.right(), b.left(), b.right()) > 0;
        const bool sameRow = overlap(a.top(), a.bottom(), b.top(), b.bottom()) >
                             std::min(a.height(), b.height()) / 2;
        if ((sameColumn && b.bottom() <= a.top()) || (sameRow && b.right() <= a.left())) {
            problems_ << "from " + nameOf(from) + " one goes back to " + nameOf(to);
        }
    }

    QWidget& top_;
    QStringList problems_;
    std::size_t stays_ = 0;
};

/// Everything of the window that there is a class of, and that a person can get to.
class KeyboardWalkTest : public test::WindowFixture {
  protected:
    KeyboardWalkTest() {
        onDialog = [this](QDialog& dialog) { walkDialog(dialog); };
        accept = false;
        window->resize(1600, 1000);
        window->activateWindow();
    }
    void walk(QWidget& top, const QString& what) {
        QTest::qWait(20);
        top.activateWindow();
        QTest::qWait(20);
        ++walks;
        for (const QString& problem : Walker(top).walk()) {
            problems << what + ": " + problem;
        }
    }
    void walkDialog(QDialog& dialog) {
        const QString name = QString(dialog.metaObject()->className()).section("::", -1);
        walkedDialogs.insert(name);
        // Pages beside a list, and tabs.
        auto* list = dialog.findChild<QListWidget*>("pageList");
        for (int row = 0; list != nullptr && row < list->count(); ++row) {
            list->setCurrentRow(row);
            walk(dialog, name + ", " + list->item(row)->text());
        }
        for (auto* tabs : dialog.findChildren<QTabWidget*>()) {
            for (int i = 1; i < tabs->count(); ++i) {
                tabs->setCurrentIndex(i);
                walk(dialog, name + ", " + tabs->tabText(i));
            }
            tabs->setCurrentIndex(0);
        }
        if (list == nullptr) {
            walk(dialog, name);
        }
    }
    static void collect(const QMenu& menu, std::vector<QPointer<QAction>>& entries) {
        for (QAction* action : menu.actions()) {
            if (action->menu() != nullptr && action->menu()->objectName() != "samples" &&
                action->menu()->objectName() != "recentFiles") {
                collect(*action->menu(), entries);
            } else if (action->menu() == nullptr && !action->isSeparator()) {
                entries.push_back(action);
            }
        }
    }
    /// Those that commands of a selection, and files, lead to.
    void walkOtherDialogs() {
        auto& editor = window->databaseEditor();
        editor.raise();
        editor.select({EntryKind::material, workbench.database().value().materials.begin()->first});
        QTest::qWait(20);
        for (const char* name : {"renumberEntry", "removeEntry"}) {
            editor.tabs()->currentWidget()->findChild<QToolButton*>(name)->click();
        }
        chosen = QString::fromStdString((folder / "spectrum.csv").string());
        std::ofstream(chosen.toStdString()) << "wavelength [um],radiance [W m-2 sr-1 um-1]\n"
                                               "3,1\n4,2\n5,1\n";
        window->findChild<QAction*>("menuImportSpectrum")->trigger();
        std::ofstream(chosen.toStdString()) << "um,emissivity\n3,0.9\n5,0.8\n";
        window->findChild<QAction*>("menuImportMaterial")->trigger();
        chosen.clear();
        trigger("hotGas");
        tabs().currentWidget()->findChild<QPushButton*>("addToDatabase")->click();
        auto* results = window->findChild<ResultsDock*>();
        results->raise();
        auto* list = results->findChild<QListWidget*>("resultList");
        list->setCurrentRow(0);
        for (const char* name : {"annotateResultAction", "showCommandLineAction"}) {
            window->findChild<QAction*>(name)->trigger();
        }
        for (int i = 0; i < tabs().count(); ++i) {
            tabs().setCurrentIndex(i);
            for (auto* limits : tabs().widget(i)->findChildren<QAction*>("axisLimits")) {
                limits->trigger();
            }
        }
        chosen = SMAT_SOURCE_DIR "/samples/flyby/flyby.json";
        window->findChild<QAction*>("openProject")->trigger();
        chosen.clear();
        auto* scenario = dynamic_cast<ScenarioPage*>(tabs().currentWidget());
        ASSERT_NE(scenario, nullptr);
        EXPECT_TRUE(test::waitUntil([&] { return !scenario->isBusy(); }));
        walk(*window, "page of a scenario");
        auto* panels = scenario->findChild<QTabWidget*>("scenarioPanels");
        panels->setCurrentIndex(panels->count() - 1);
        auto* parts = scenario->findChild<QComboBox*>("editedPart");
        for (int part = 0; part < parts->count(); ++part) {
            parts->setCurrentIndex(part);
            emit parts->activated(part);
            walk(*window, "page of a scenario, " + parts->currentText());
        }
        scenario->findChild<QToolButton*>("runScenario")->click();
        auto* index = window->findChild<QComboBox*>("paintTemperature");
        emit index->activated(index->count() - 1);
        workbench.set("camera.azimuth", "1");
        answer = 1;
        trigger("newProject");
    }
    QTabWidget& tabs() { return *window->findChild<QTabWidget*>("tabs"); }

    int walks = 0;
    QStringList problems;
    std::set<QString> walkedDialogs;
};

/// The classes of a kind that the window's sources declare.
std::set<QString> declared(const std::string& base) {
    std::set<QString> names;
    const std::regex declaration("class (\\w+) : public " + base + "\\b");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(SMAT_SOURCE_DIR) / "gui")) {
        if (entry.path().extension() != ".h") {
            continue;
        }
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::smatch match;
            if (std::regex_search(line, match, declaration)) {
                names.insert(QString::fromStdString(match[1]));
            }
        }
    }
    return names;
}

TEST_F(KeyboardWalkTest, EveryPageDialogAndDockIsWalkedByTab) {
    walk(*window, "start page");
    openSample();
    for (auto* dock : window->findChildren<QDockWidget*>()) {
        dock->show();
        dock->raise();
        walk(*window, dock->objectName());
    }
    accept = true;
    for (const char* word : {"image", "polar", "range"}) {
        runAnalysis(word);
    }
    accept = false;

    // All that menus lead to: dialogs are walked as they open, pages afterwards.
    std::vector<QPointer<QAction>> entries;
    for (const QAction* menu : window->menuBar()->actions()) {
        collect(*menu->menu(), entries);
    }
    for (const auto* menu : window->findChildren<QMenu*>()) {
        if (menu->parent() != window->menuBar() && menu->objectName() != "samples" &&
            menu->objectName() != "recentFiles") {
            collect(*menu, entries);
        }
    }
    chosen.clear();
    for (const auto& entry : entries) {
        // Renaming opens a field in a row of the tree, which is left by Enter or Escape; a kept
        // state would halve the room of all pages.
        const std::set<QString> never{"quit", "closeResult", "collapseDocks", "renameModel",
                                      "keepState"};
        if (entry && entry->isEnabled() && !never.contains(entry->objectName()) &&
            !entry->isCheckable()) {
            entry->trigger();
            QTest::qWait(5);
        }
    }
    // Those that stand beside others are walked with all the room.
    auto& pages = *window->findChild<PageTabs*>("tabs");
    while (pages.beside()->count() > 0) {
        pages.moveAcross(pages.beside()->widget(0));
    }
    QTest::qWait(20);
    for (int i = 0; i < tabs().count(); ++i) {
        tabs().setCurrentIndex(i);
        QTest::qWait(20); // bars take as many rows as their new width asks for
        walk(*window, "page " + tabs().tabText(i));
    }
    auto& editor = window->databaseEditor();
    tabs().setCurrentIndex(0);
    editor.raise();
    for (int i = 0; i < editor.tabs()->count(); ++i) {
        editor.tabs()->setCurrentIndex(i);
        walk(*window, "editor, " + editor.tabs()->tabText(i));
        for (auto* inner : editor.tabs()->currentWidget()->findChildren<QTabWidget*>()) {
            for (int k = 1; k < inner->count(); ++k) {
                if (inner->isTabVisible(k)) {
                    inner->setCurrentIndex(k);
                    walk(*window, "editor, " + inner->tabText(k));
                }
            }
        }
    }

    walkOtherDialogs();
    problems.removeDuplicates();
    EXPECT_TRUE(problems.isEmpty()) << problems.join('\n').toStdString();
    RecordProperty("walks", walks);
    for (const QString& name : declared("QDialog")) {
        // What others are made of is seen in them.
        std::set<QString> shown = declared(name.toStdString());
        if (shown.empty()) {
            shown.insert(name);
        }
        for (const QString& one : shown) {
            EXPECT_TRUE(walkedDialogs.contains(one)) << one.toStdString() << " was not walked";
        }
    }
}

} // namespace
} // namespace smat::gui
