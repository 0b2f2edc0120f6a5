#include "gui/analysis/JobBar.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>

#include "gui/analysis/ResultStore.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"

namespace smat::gui {

namespace {

/// Of the width of the window at most what a stage may take, and no more than this.
constexpr int stageShare = 4, widestStage_px = 360;

} // namespace

JobBar::JobBar(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
    setObjectName("jobBar");
    title_ = new QLabel(this);
    title_->setObjectName("jobTitle");
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    bar_ = new QProgressBar(this);
    bar_->setObjectName("jobProgress");
    bar_->setTextVisible(false);
    bar_->setFixedSize(110, 12);
    const auto faint = [this](const char* name) {
        auto* label = new QLabel(this);
        label->setObjectName(name);
        label->setForegroundRole(QPalette::PlaceholderText);
        return label;
    };
    what_ = faint("jobDetail");
    stage_ = faint("jobStage");
    times_ = faint("jobTimes");
    const auto button = [this](const char* name) {
        auto* tool = new QToolButton(this);
        tool->setObjectName(name);
        tool->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        tool->setAutoRaise(true);
        return tool;
    };
    cancel_ = button("cancelJob");
    cancel_->setIcon(icon("cancel"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolTip(tr("Stop and keep what is done so far (Esc)"));
    cancel_->setShortcut(Qt::Key_Escape);
    line_ = menuButton({}, "waitingJobs", tr("Queue: choose an entry to remove it"));
    line_->setAutoRaise(true);
    waiting_ = line_->menu();
    waiting_->setObjectName("waitingMenu");

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 0, 0);
    row->setSpacing(8);
    for (QWidget* widget :
         {static_cast<QWidget*>(title_), static_cast<QWidget*>(bar_), static_cast<QWidget*>(what_),
          static_cast<QWidget*>(stage_), static_cast<QWidget*>(times_),
          static_cast<QWidget*>(cancel_), static_cast<QWidget*>(line_)})
        row->addWidget(widget);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    times_->setMinimumWidth(
        fontMetrics().horizontalAdvance(tr("99.9 s elapsed, about 999 s left")));
    hide();

    timer_ = new QTimer(this);
    timer_->setInterval(100);
    connect(timer_, &QTimer::timeout, this, &JobBar::refresh);
    connect(cancel_, &QToolButton::clicked, this, [this] {
        workbench_.cancel();
        cancel_->setEnabled(false);
        refresh();
    });
    connect(waiting_, &QMenu::aboutToShow, this, &JobBar::fillLine);
    connect(&workbench_.jobs(), &JobQueue::waitingChanged, this, &JobBar::refreshLine);
    connect(&workbench_, &Workbench::jobStarted, this, &JobBar::onStarted);
    connect(&workbench_, &Workbench::jobProgressed, this, &JobBar::onProgressed);
    connect(&workbench_, &Workbench::jobEnded, this, [this] {
        timer_->stop();
        hide();
    });
}

void JobBar::refreshLine() {
    const std::size_t count = workbench_.jobs().waiting().size();
    line_->setVisible(count > 0);
    line_->setText(tr("%1 waiting").arg(count));
}

void JobBar::fillLine() {
    waiting_->clear();
    for (const auto& one : workbench_.jobs().waiting())
        waiting_->addAction(icon("cancel"), AnalysisJob::titleOf(one.order), this,
                            [this, number = one.number] { workbench_.jobs().cancel(number); });
}

void JobBar::onStarted(const QString& title) {
    title_->setText(title);
    case_.clear();
    remaining_s_ = -1.0;
    bar_->setRange(0, 0); // busy, until it says how far it is
    cancel_->setEnabled(true);
    show();
    timer_->start();
    refreshLine();
    refresh();
}

void JobBar::onProgressed(const Progress& now) {
    // One case has no half: its bar only says that something is going on.
    case_.clear();
    if (now.total > 1) {
        bar_->setRange(0, 1000);
        bar_->setValue(static_cast<int>(1000.0 * now.fraction()));
        case_ = tr("%1 of %2").arg(now.done).arg(now.total);
    }
    setToolTip(QString::fromStdString(now.what));
    if (const auto remaining = now.remaining_s()) {
        remaining_s_ = *remaining;
        remainingSaidAt_s_ = workbench_.job() != nullptr ? workbench_.job()->elapsed_s() : 0.0;
    }
    refresh();
}

void JobBar::refresh() {
    if (workbench_.job() == nullptr)
        return;
    const AnalysisJob& job = *workbench_.job();
    const double elapsed_s = job.elapsed_s();
    QString times = tr("%1 elapsed").arg(durationText(elapsed_s));
    if (remaining_s_ >= 0.0 && !job.isCancelled()) {
        const double left_s = std::max(0.0, remaining_s_ - (elapsed_s - remainingSaidAt_s_));
        times += tr(", about %1 left").arg(durationText(std::ceil(left_s)));
    }
    times_->setText(times);
    what_->setText(job.isCancelled() ? tr("Cancelling; finished cases are kept") : case_);
    what_->setVisible(!what_->text().isEmpty());
    const QString stage = job.isCancelled() ? QString() : job.stage();
    const int room_px = std::min(window()->width() / stageShare, widestStage_px);
    stage_->setText(stage_->fontMetrics().elidedText(stage, Qt::ElideRight, room_px));
    stage_->setToolTip(stage);
    stage_->setVisible(!stage.isEmpty());
}

} // namespace smat::gui

#include "moc_JobBar.cpp"
