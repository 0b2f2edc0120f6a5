#pragma once

#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

#include "gui/widgets/LatestTask.h"

namespace smat::gui {

/// Work in a thread of the pool, one answer at a time. What was asked before a cancel or before the
/// next start gives no answer any more: it ends by itself, and nothing waits for it, not even the
/// end of this object.
class Calculation : public QObject {
    Q_OBJECT

  public:
    /// Runs in a thread, owns what it uses and touches nothing of the window's; what it returns is
    /// called in the window's thread and takes the answer there. Throws irsg::InputError to refuse.
    using Work = std::function<std::function<void()>()>;

    using QObject::QObject;

    void start(Work work);
    void cancel();
    bool isRunning() const { return running_; }
    /// Since the last start, in seconds.
    double elapsed_s() const;

  signals:
    void started();
    /// After the answer, the refusal, or the cancel.
    void ended();
    void refused(const QStringList& sentences);

  private:
    void refuse(const std::exception_ptr& thrown);

    QElapsedTimer clock_;
    bool running_ = false;
    LatestTask task_;
};

} // namespace smat::gui
