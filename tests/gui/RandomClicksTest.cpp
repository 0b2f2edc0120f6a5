// Random clicks and keys over the whole window: no crash, no hang, bounded memory.
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <thread>
#include <utility>

#include <QApplication>
#include <QDockWidget>
#include <QDrag>
#include <QMenu>
#include <QMouseEvent>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include "gui/workbench/PageTabs.h"
#include "tests/gui/ProcessCounts.h"
#include "tests/gui/WindowFixture.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double secondsOr(const char* variable, double otherwise) {
    const char* text = std::getenv(variable);
    return text == nullptr ? otherwise : std::atof(text);
}

/// Ends the program where the window does not answer for a minute, with the act that it is at.
class Watchdog {
  public:
    Watchdog() : thread_([this] { watch(); }) {}
    ~Watchdog() {
        isOver_ = true;
        thread_.join();
    }
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;
    void step(const QString& act) {
        act_ = act;
        ++steps_;
    }
    const QString& act() const { return act_; }

  private:
    void watch() {
        long last = -1;
        auto since = Clock::now();
        while (!isOver_) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            if (const long now = steps_; now != last) {
                last = now;
                since = Clock::now();
            } else if (Clock::now() - since > std::chrono::minutes(1)) {
                std::fprintf(stderr, "no answer for a minute after: %s\n", qPrintable(act_));
                std::abort();
            }
        }
    }
    std::atomic<bool> isOver_ = false;
    std::atomic<long> steps_ = 0;
    QString act_;
    std::thread thread_;
};

class RandomClicks : public test::WindowFixture {
  protected:
    RandomClicks() {
        // Clicks write beside models: the program's samples are a copy.
        for (const char* part : {"resources", "docs", "shaders"}) {
            fs::create_directory_symlink(fs::path(SMAT_SOURCE_DIR) / part, data_ / part);
        }
        fs::copy(fs::path(SMAT_SOURCE_DIR) / "samples", data_ / "samples",
                 fs::copy_options::recursive);
        qputenv("SMAT_DATA", data_.string().c_str());
        makeWindow();
        // Dialogs are clicked in, too, then they are left by one answer or the other.
        onDialog = [this](QDialog& dialog) {
            if (depth_ > 2) {
                return;
            }
            ++depth_;
            closePopups();
            for (int i = 0; i < 6 && dialog.isVisible(); ++i) {
                act(dialog);
            }
            --depth_;
            accept = number(2) == 0;
            answer = number(3) - 1;
        };
    }
    ~RandomClicks() override { qunsetenv("SMAT_DATA"); }
    void SetUp() override {
        WindowFixture::SetUp();
        // The menu of a button, and a dialog of its own, hold the click that opened them.
        QObject::connect(&closer_, &QTimer::timeout, &closer_, [this] {
            if (std::exchange(lastAct_, acts_) != acts_) {
                return;
            }
            QDrag::cancel(); // it waits for a button of the desktop to be let go
            for (QWidget* holding :
                 {QApplication::activePopupWidget(), QApplication::activeModalWidget()}) {
                if (holding != nullptr) {
                    holding->close();
                    return;
                }
            }
        });
        closer_.start(150);
    }
    int number(int below) {
        return std::uniform_int_distribution<int>(0, std::max(below, 1) - 1)(random_);
    }
    /// One click, drag, turn of the wheel or key somewhere in a window.
    void act(QWidget& in) {
        QWidget* popup = QApplication::activePopupWidget();
        QWidget& root = popup != nullptr && number(4) > 0 ? *popup : in;
        if (popup != nullptr && &root != popup) {
            popup->close();
        }
        ++acts_;
        const QPoint where(number(root.width()), number(root.height()));
        QPointer<QWidget> target = root.childAt(where);
        if (target == nullptr) {
            target = &root;
        }
        const QPoint at = target->mapFrom(&root, where);
        // Quitting is no act of a session, and a dialog of the desktop cannot be clicked.
        if (auto* menu = qobject_cast<QMenu*>(target.data())) {
            const QAction* action = menu->actionAt(at);
            if (action != nullptr && isLeftOut(*action)) {
                return;
            }
        }
        const int kind = number(10);
        dog_.step(QStringLiteral("%1 on %2 %3")
                      .arg(kind)
                      .arg(target->metaObject()->className(), target->objectName()));
        const auto modifiers = number(8) == 0   ? Qt::ShiftModifier
                               : number(8) == 0 ? Qt::ControlModifier
                                                : Qt::NoModifier;
        if (kind < 5) {
            const auto button = number(6) == 0 ? Qt::RightButton : Qt::LeftButton;
            QTest::mousePress(target, button, modifiers, at);
            if (target != nullptr && number(3) == 0) {
                QTest::mouseMove(target, at + QPoint(number(120) - 60, number(120) - 60));
            }
            if (target != nullptr) {
                QTest::mouseRelease(target, button, modifiers, at);
            }
        } else if (kind == 5) {
            QTest::mousePress(target, Qt::LeftButton, modifiers, at);
            if (target != nullptr) {
                QTest::mouseRelease(target, Qt::LeftButton, modifiers, at);
            }
            if (target != nullptr) { // else the second click falls on what lies below
                QMouseEvent second(QEvent::MouseButtonDblClick, at, target->mapToGlobal(at),
                                   Qt::LeftButton, Qt::LeftButton, modifiers);
                QApplication::sendEvent(target, &second);
            }
            if (target != nullptr) {
                QTest::mouseRelease(target, Qt::LeftButton, modifiers, at);
            }
        } else if (kind == 6) {
            QWheelEvent wheel(at, target->mapToGlobal(at), {}, {0, number(2) ? 120 : -120},
                              Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            QApplication::sendEvent(target, &wheel);
        } else {
            static constexpr std::array keys{
                Qt::Key_Tab,   Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Escape, Qt::Key_Space,
                Qt::Key_Up,    Qt::Key_Down,    Qt::Key_Left,   Qt::Key_Right,  Qt::Key_PageUp,
                Qt::Key_Home,  Qt::Key_End,     Qt::Key_Delete, Qt::Key_F2,     Qt::Key_F6,
                Qt::Key_1,     Qt::Key_2,       Qt::Key_5,      Qt::Key_Comma,  Qt::Key_E,
                Qt::Key_M,     Qt::Key_P,       Qt::Key_G,      Qt::Key_I,      Qt::Key_H,
                Qt::Key_Minus, Qt::Key_Z,       Qt::Key_Y,      Qt::Key_Period, Qt::Key_Backspace};
            // No window manager gives a dialog the focus here; its keys are not for the window
            // below.
            QWidget* focus = QApplication::focusWidget();
            const bool isHere = focus != nullptr && (depth_ == 0 || root.isAncestorOf(focus));
            QTest::keyClick(isHere ? focus : &root,
                            keys[static_cast<std::size_t>(number(keys.size()))], modifiers);
        }
        QApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    /// Of the pictures among the results, which stay until somebody removes them.
    double results_MB() const {
        double sum = 0.0;
        for (const ResultEntry& entry : workbench.results()) {
            sum += 4e-6 * entry.data->image.width() * entry.data->image.height() *
                   static_cast<double>(entry.data->image.channels.size());
        }
        return sum;
    }
    static bool isLeftOut(const QAction& action) { return action.objectName() == "quit"; }

    void openCopy() {
        const fs::path file = test::writeSampleProject(folder);
        Project project = loadProject(file);
        project.models.front().file = data_ / "samples/ship/ship.flt";
        project.models.front().database = data_ / "samples/ship/ship.sigdb";
        saveProject(project, file);
        ASSERT_TRUE(opens(file));
        ASSERT_TRUE(told.isEmpty()) << told.join('\n').toStdString();
    }
    void closePopups() {
        while (QWidget* popup = QApplication::activePopupWidget()) {
            popup->close();
        }
    }
    void go(unsigned seed, double duration_s) {
        random_.seed(seed);
        std::printf("seed %u, %.0f s\n", seed, duration_s);
        std::fflush(stdout);
        openCopy();
        chosen = QString::fromStdString((folder / "written.smat").string());
        const auto end = Clock::now() + std::chrono::duration<double>(duration_s);
        long acts = 0;
        double first_MB = 0.0;
        for (; Clock::now() < end; ++acts) {
            if (!window->isVisible()) {
                window->show();
            }
            act(*window);
            if (acts % 500 == 0) {
                told.clear();
                asked.clear();
                if (acts == 2000) {
                    first_MB = 1e-3 * smat::test::allocated_kB();
                }
            }
        }
        closePopups();
        const double now_MB = 1e-3 * smat::test::allocated_kB();
        std::printf("%ld acts, %.0f MB after 2000 of them, %.0f MB at the end, %.0f MB of %zu "
                    "results, %zu pages\n",
                    acts, first_MB, now_MB, results_MB(), workbench.results().size(),
                    window->findChild<PageTabs*>("tabs")->pages().size());
        EXPECT_GT(acts, 20);
        if (first_MB > 0.0) {
            EXPECT_LT(now_MB, first_MB + 1500.0);
        }
        workbench.jobs().cancelAll();
        ASSERT_TRUE(test::waitUntil([&] { return !workbench.isRunning(); }));
    }

  private:
    const fs::path data_ = test::freshFolder("clicked-data");
    std::mt19937 random_;
    Watchdog dog_;
    int depth_ = 0;
    QTimer closer_;
    long acts_ = 0, lastAct_ = -1;
};

/// A search, not a check of every build: SMAT_CLICKS_S=600 SMAT_CLICKS_SEED=7.
TEST_F(RandomClicks, LeaveTheWindowAlive) {
    const double duration_s = secondsOr("SMAT_CLICKS_S", 0.0);
    if (!(duration_s > 0.0)) {
        GTEST_SKIP() << "SMAT_CLICKS_S, the seconds to click for, is not set";
    }
    go(static_cast<unsigned>(secondsOr("SMAT_CLICKS_SEED", 1.0)), duration_s);
}

} // namespace
} // namespace smat::gui
