#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace smat::gui {

/// Models that somebody waits for, as the status bar tells it: which, for how long, and a way out.
class ModelWait : public QObject {
    Q_OBJECT

  public:
    explicit ModelWait(QObject* parent = nullptr);

    virtual bool isBusy() const = 0;
    /// Nothing more is heard of what is being read but `cancelled`.
    void cancel();

  signals:
    /// "Reading ship.flt, 2.4 s", again and again; empty when there is nothing to wait for any
    /// more. What is read within a moment is not told of.
    void waiting(const QString& words);
    /// With the names of the files.
    void cancelled(const QString& names);

  protected:
    void beginWaiting(const QString& names);
    void endWaiting();
    virtual void letGo() = 0;

  private:
    void tell();

    QTimer tick_;
    QElapsedTimer clock_;
    QString names_;
};

} // namespace smat::gui
