#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

#include "gui/view/InfraredRequest.h"
#include "smatcore/support/CurrentStage.h"

namespace smat::gui {

/// Draws infrared pictures in a thread of its own, the latest request first and those in between
/// never. Its signals arrive in the thread that made it. The thread starts with the first request;
/// destroying the display waits for the picture under way.
class InfraredDisplay : public QObject {
    Q_OBJECT

  public:
    explicit InfraredDisplay(QObject* parent = nullptr);
    ~InfraredDisplay() override;

    /// Returns at once.
    void ask(InfraredRequest request);
    /// Forgets a request that is not begun yet.
    void forget();
    bool isBusy() const { return asked_ != answered_; }
    /// How long it has been busy without an answer, s; 0 while it is idle.
    double waiting_s() const;
    /// What the picture under way is at, with its share; empty between stages.
    QString stage() const { return QString::fromStdString(stage_.text()); }

  signals:
    void drawn(const smat::gui::InfraredPicture& picture);
    /// One sentence for each diagnostic.
    void failed(const QStringList& sentences, bool ourFault);
    /// After every request that was begun, before its signal above.
    void answered(long number);

  private:
    void work(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<InfraredRequest> next_;
    long nextNumber_ = 0;

    long asked_ = 0, answered_ = 0;
    QElapsedTimer waiting_;
    CurrentStage stage_;
    std::jthread thread_; ///< last: stops before the rest goes
};

} // namespace smat::gui
