#pragma once

#include <functional>

#include <QObject>

#include "gui/widgets/Dialogs.h"
#include "gui/workbench/MessageLog.h"

namespace smat::gui {

class Workbench;

/// Brings every warning and remark of the window into one log: remarks of readers in whatever
/// thread, warnings of results, and what dialogs tell.
class WindowMessages : public QObject {
    Q_OBJECT

  public:
    /// Where the window shows things.
    struct Places {
        std::function<void(int id)> result;
        std::function<void(std::size_t model)> model;
        std::function<void(std::size_t model)> database;
        std::function<void()> atmosphere, settings;
    };

    explicit WindowMessages(Workbench& workbench, QObject* parent = nullptr);
    ~WindowMessages() override;

    MessageLog& log() { return log_; }
    void setPlaces(Places places) { places_ = std::move(places); }
    /// Lets the log keep what these dialogs tell.
    void follow(Dialogs& dialogs);
    /// A sentence about a file ("heron.ac, line 3: ...") or about nothing in particular.
    void remark(const QString& sentence);
    /// Tells of a run that was refused, with the settings as its place.
    void tellRefusal(const Dialogs& dialogs, QWidget* parent, const QString& title,
                     const QStringList& sentences);

  private:
    void takeWarnings(int id);
    std::function<void()> placeOf(const QString& file) const;

    Workbench& workbench_;
    MessageLog log_;
    Places places_;
    std::function<void()> placeOfTold_; ///< of what is told now
};

} // namespace smat::gui
