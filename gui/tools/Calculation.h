#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

#include <QObject>
#include <QStringList>

namespace smat::gui {

/// Work in threads of its own, one answer at a time. What was asked before a cancel or before the
/// next start gives no answer any more: it ends by itself. Destroying it waits for what still
/// works.
class Calculation : public QObject {
    Q_OBJECT

  public:
    /// Runs in a thread and touches nothing of the window's; what it returns is called in the
    /// window's thread and takes the answer there. Throws irsg::InputError to refuse.
    using Work = std::function<std::function<void()>()>;

    using QObject::QObject;
    ~Calculation() override;

    void start(Work work);
    void cancel();
    bool isRunning() const { return running_; }

  signals:
    void started();
    /// After the answer, the refusal, or the cancel.
    void ended();
    void refused(const QStringList& sentences);

  private:
    void answer(int number, const std::function<void()>& take, const QStringList& sentences);

    struct Worker {
        std::shared_ptr<std::atomic<bool>> done;
        std::jthread thread;
    };
    std::vector<Worker> workers_;
    int number_ = 0; ///< of what is wanted now
    bool running_ = false;
};

} // namespace smat::gui
