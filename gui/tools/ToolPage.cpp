#include "gui/tools/ToolPage.h"

#include <utility>

#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/tools/RunFoot.h"
#include "gui/widgets/FoldingSplitter.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/UnsavedNote.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

ToolPage::ToolPage(Workbench& workbench, Dialogs dialogs, const QString& title, QWidget* parent)
    : QWidget(parent), workbench_(workbench), dialogs_(std::move(dialogs)), title_(title) {
    clockTick_.setInterval(200);
    connect(&clockTick_, &QTimer::timeout, this, [this] {
        foot_->progress->setFormat(
            QString("%1  %2 s")
                .arg(doing_)
                .arg(static_cast<double>(clock_.elapsed()) / 1000.0, 0, 'f', 1));
    });
}

void ToolPage::layOut(QWidget* form, int width_px, const QString& whatCancelDoes, QWidget* right) {
    foot_ = new RunFoot(whatCancelDoes, this);
    foot_->progress->setTextVisible(true);
    foot_->progress->setFormat(QString());
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(new FoldingSplitter(RunFoot::below(form, foot_, this), width_px, right, this));
    connect(foot_->run, &QPushButton::clicked, this, &ToolPage::run);
    connect(foot_->cancel, &QPushButton::clicked, this, &ToolPage::cancel);
    connect(&workbench_, &Workbench::projectOpened, this, [this] { reload(); });
    connect(&workbench_, &Workbench::projectChanged, this, [this] { reload(); });
    connect(&workbench_, &Workbench::settingsChanged, this, &ToolPage::refresh);
    connectJobs();
    reload();
}

void ToolPage::refresh() {
    const bool hasProject = workbench_.hasProject();
    const QStringList problems =
        hasProject ? this->problems() : QStringList{tr("Open a project first.")};
    foot_->command->clear();
    if (hasProject) {
        try {
            foot_->command->setText(command());
        } catch (const irsg::InputError&) {
            foot_->command->clear(); // the problems say what is wrong
        }
    }
    foot_->command->setCursorPosition(0);
    foot_->command->setToolTip(foot_->command->text());
    const QString note = hasProject ? unsavedNote(workbench_) : QString();
    foot_->unsaved->setText(note);
    foot_->unsaved->setVisible(!note.isEmpty());
    foot_->problem->setText(problems.join('\n'));
    foot_->problem->setVisible(!problems.isEmpty());
    foot_->run->setEnabled(problems.isEmpty() && !isRunning());
    foot_->cancel->setEnabled(isRunning() && !cancelled_);
    refreshed(problems.isEmpty());
}

void ToolPage::setProgress(int of1000, const QString& text) {
    foot_->progress->setValue(of1000);
    foot_->progress->setFormat(text);
}

void ToolPage::run() {
    if (isRunning())
        return;
    const QString doing = workbench_.isRunning() ? tr("queued") : tr("starting");
    try {
        number_ = start();
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, title_, sentencesOf(error));
        refresh();
        return;
    }
    cancelled_ = false;
    doing_ = doing;
    setProgress(0, doing_);
    clock_.start();
    clockTick_.start();
    refresh();
}

bool ToolPage::isRunning() const {
    return number_ != 0 && workbench_.jobs().holds(number_);
}

void ToolPage::cancel() {
    if (!isRunning())
        return;
    cancelled_ = true;
    foot_->cancel->setEnabled(false);
    workbench_.jobs().cancel(number_);
}

void ToolPage::connectJobs() {
    const JobQueue& jobs = workbench_.jobs();
    connect(&jobs, &JobQueue::progressed, this, [this](int number, const Progress& progress) {
        if (number != number_ || cancelled_)
            return;
        foot_->progress->setValue(static_cast<int>(1000.0 * progress.fraction()));
        doing_ = progressText(progress);
    });
    connect(&jobs, &JobQueue::ended, this, [this](int number) {
        if (number == number_)
            rest();
    });
    connect(&jobs, &JobQueue::waitingChanged, this, [this] {
        if (clockTick_.isActive() && !isRunning())
            rest();
        else
            refresh();
    });
    connect(&jobs, &JobQueue::finished, this, [this](int number, const JobResult& result) {
        if (number == number_)
            showResult(result);
    });
    connect(&jobs, &JobQueue::failed, this, [this](int number) {
        if (number == number_)
            foot_->progress->setFormat(QString());
    });
}

void ToolPage::rest() {
    clockTick_.stop();
    setProgress(0, cancelled_ ? cancelText() : QString());
    refresh();
    emit ended();
}

} // namespace smat::gui

#include "moc_ToolPage.cpp"
