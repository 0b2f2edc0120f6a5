#pragma once

#include <sstream>

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>
#include <QWheelEvent>

#include "gui/analysis/ResultPage.h"
#include "gui/view/SceneView.h"
#include "tests/cli/Program.h"
#include "tests/gui/DatabaseFixture.h"
#include "tests/guide/GuideWalk.h"

namespace smat::gui::test {

/// The window of somebody who reads the guide.
class GuideFixture : public DatabaseFixture {
  protected:
    /// A fatal failure where it is not there.
    template <typename Widget>
    Widget* get(const QString& name, QWidget* within = nullptr) {
        auto* found = (within != nullptr ? within : window.get())->findChild<Widget*>(name);
        if (found == nullptr) {
            throw std::runtime_error("no " + name.toStdString());
        }
        return found;
    }
    QTabWidget* tabs() { return get<QTabWidget>("tabs"); }
    template <typename Page>
    Page* page() {
        return dynamic_cast<Page*>(tabs()->currentWidget());
    }
    void act(const char* name) {
        get<QAction>(name)->trigger();
        QTest::qWait(20);
    }
    static void choose(QComboBox* box, int index) {
        box->setCurrentIndex(index);
        emit box->activated(index);
    }
    static void write(QLineEdit* field, const QString& text) {
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    static void wheel(QWidget* to, const QPointF& at, int steps,
                      Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QWheelEvent event(at, to->mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(to, &event);
        QTest::qWait(10);
    }
    static void mouse(QWidget* to, QEvent::Type type, const QPointF& at, Qt::MouseButton button,
                      Qt::MouseButtons held, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QMouseEvent event(type, at, to->mapToGlobal(at), button, held, modifiers);
        QCoreApplication::sendEvent(to, &event);
    }
    static void drag(QWidget* to, Qt::MouseButton button, const QPointF& from, const QPointF& by,
                     Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        mouse(to, QEvent::MouseButtonPress, from, button, button, modifiers);
        mouse(to, QEvent::MouseMove, from + by / 2, Qt::NoButton, button, modifiers);
        mouse(to, QEvent::MouseMove, from + by, Qt::NoButton, button, modifiers);
        mouse(to, QEvent::MouseButtonRelease, from + by, button, Qt::NoButton, modifiers);
        QTest::qWait(10);
    }
    /// Of all pixels of the infrared picture, once it shows what there is.
    static double sumOfPicture(SceneView& view) {
        EXPECT_TRUE(
            waitUntil([&] { return view.shownPicture() != nullptr && view.isUpToDate(); }, 20.0));
        double all = 0.0;
        for (const float value : view.shownPicture()->image->primary().values) {
            all += static_cast<double>(value);
        }
        return all;
    }
    void selectResults(const QList<int>& rows) {
        auto* list = get<QListWidget>("resultList");
        list->clearSelection();
        for (const int row : rows) {
            list->item(row)->setSelected(true);
        }
    }
    bool settled() {
        const bool done = waitUntil([this] { return !workbench.isRunning(); }, 60.0);
        QTest::qWait(20);
        return done;
    }
    QString path(const char* name) const {
        return QString::fromStdString((folder / name).string());
    }
    std::string said() const { return told.join('\n').toStdString(); }
    /// What a terminal answers to words that begin with the program, in the folder of the test.
    smat::test::Ran terminal(const std::string& line, int exitCode = 0) {
        std::istringstream words(line);
        std::vector<std::string> arguments;
        for (std::string word; words >> word;) {
            arguments.push_back(word);
        }
        EXPECT_EQ(arguments.front(), "smat-batch");
        arguments.erase(arguments.begin());
        const auto ran = smat::test::smatBatch(arguments, folder);
        EXPECT_EQ(ran.exitCode, exitCode) << line << "\n" << ran.out << ran.err;
        return ran;
    }
};

} // namespace smat::gui::test
