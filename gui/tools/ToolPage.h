#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/support/Progress.h"

namespace smat::gui {

class RunFoot;
class Workbench;
struct JobResult;

/// A page of a tool that runs as a job in the line: a form above its foot (RunFoot), beside what
/// came out. A cancel keeps what there is; the run is a result like any other, and goes on where
/// the page is closed. Shows the command that does the same.
class ToolPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    /// Or waits in line.
    bool isRunning() const;

    QStringList exportFilters() const override { return content().exportFilters(); }
    void exportTo(const std::filesystem::path& file) const override { content().exportTo(file); }

  public slots:
    void run();
    /// Answered within a moment: a rendering under way ends by itself, and what was done until then
    /// is shown when it has, unless the next run has begun.
    void cancel();

  signals:
    /// After every run, whatever came of it.
    void ended();

  protected:
    ToolPage(Workbench& workbench, Dialogs dialogs, const QString& title, QWidget* parent);

    /// Lays `form`, so wide, above the foot and beside `right`; then refreshes. Once, in the
    /// constructor of the page.
    void layOut(QWidget* form, int width_px, const QString& whatCancelDoes, QWidget* right);
    /// Shows what is wrong with the form, the command and what can be done now.
    void refresh();
    /// What stands in the bar of progress.
    void setProgress(int of1000, const QString& text);

    Workbench& workbench_;
    Dialogs dialogs_;

  private:
    /// Of a form whose project is open; empty where nothing is wrong.
    virtual QStringList problems() const = 0;
    /// Throws irsg::InputError for fields that say nothing usable.
    virtual QString command() const = 0;
    /// Puts what is asked for in the line; the number of the job. Throws irsg::InputError.
    virtual int start() = 0;
    /// What is being done, for the bar of progress.
    virtual QString progressText(const Progress& progress) const = 0;
    /// After a cancel, until what was done is shown.
    virtual QString cancelText() const = 0;
    virtual void showResult(const JobResult& result) = 0;
    virtual const Exportable& content() const = 0;
    /// Another project, or another state of its file.
    virtual void reload() { refresh(); }
    /// The end of a refresh. `isUsable`: the form can be run.
    virtual void refreshed(bool isUsable) = 0;

    void connectJobs();
    void rest();

    QString title_;
    RunFoot* foot_ = nullptr;
    bool cancelled_ = false;
    int number_ = 0; ///< of the job that is heard of
    QTimer clockTick_;
    QElapsedTimer clock_;
    QString doing_;
};

} // namespace smat::gui
