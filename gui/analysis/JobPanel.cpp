#include "gui/analysis/JobPanel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/Theme.h"
#include "gui/Workbench.h"
#include "gui/analysis/ResultStore.h"

namespace smat::gui {

JobPanel::JobPanel(Workbench& workbench, QWidget* parent) : QWidget(parent), workbench_(workbench) {
    setObjectName("jobPanel");
    title_ = new QLabel(this);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    bar_ = new QProgressBar(this);
    bar_->setObjectName("jobProgress");
    const auto faint = [this](const char* name) {
        auto* label = new QLabel(this);
        label->setObjectName(name);
        label->setForegroundRole(QPalette::PlaceholderText);
        label->setWordWrap(true);
        return label;
    };
    what_ = faint("jobDetail");
    times_ = faint("jobTimes");
    cancel_ = new QToolButton(this);
    cancel_->setObjectName("cancelJob");
    cancel_->setIcon(icon("cancel"));
    cancel_->setText(tr("Cancel"));
    cancel_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    cancel_->setAutoRaise(true);
    cancel_->setToolTip(tr("Stop and keep what is done so far (Esc)"));
    cancel_->setShortcut(Qt::Key_Escape);

    auto* top = new QHBoxLayout;
    top->addWidget(title_, 1);
    top->addWidget(cancel_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 6);
    column->setSpacing(4);
    column->addLayout(top);
    column->addWidget(bar_);
    column->addWidget(what_);
    column->addWidget(times_);
    hide();

    timer_ = new QTimer(this);
    timer_->setInterval(100);
    connect(timer_, &QTimer::timeout, this, &JobPanel::refresh);
    connect(cancel_, &QToolButton::clicked, this, [this] {
        workbench_.cancel();
        cancel_->setEnabled(false);
        refresh();
    });
    connect(&workbench_, &Workbench::jobStarted, this, &JobPanel::onStarted);
    connect(&workbench_, &Workbench::jobProgressed, this, &JobPanel::onProgressed);
    connect(&workbench_, &Workbench::jobEnded, this, [this] {
        timer_->stop();
        hide();
    });
}

void JobPanel::onStarted(const QString& title) {
    title_->setText(title);
    case_.clear();
    remaining_s_ = -1.0;
    bar_->setRange(0, 0);
    cancel_->setEnabled(true);
    show();
    timer_->start();
    refresh();
}

void JobPanel::onProgressed(const Progress& now) {
    // One case has no half: its bar only says that something is going on.
    if (now.total > 1) {
        bar_->setRange(0, 1000);
        bar_->setValue(static_cast<int>(1000.0 * now.fraction()));
        case_ =
            tr("%1 of %2   %3").arg(now.done).arg(now.total).arg(QString::fromStdString(now.what));
    } else {
        case_ = QString::fromStdString(now.what);
    }
    if (const auto remaining = now.remaining_s()) {
        remaining_s_ = *remaining;
        remainingSaidAt_s_ = workbench_.isRunning() ? workbench_.job()->elapsed_s() : 0.0;
    }
    refresh();
}

void JobPanel::refresh() {
    if (!workbench_.isRunning())
        return;
    const AnalysisJob& job = *workbench_.job();
    const double elapsed_s = job.elapsed_s();
    QString times = tr("%1 elapsed").arg(durationText(elapsed_s));
    if (remaining_s_ >= 0.0 && !job.isCancelled()) {
        const double left_s = std::max(0.0, remaining_s_ - (elapsed_s - remainingSaidAt_s_));
        times += tr(", about %1 left").arg(durationText(std::ceil(left_s)));
    }
    times_->setText(times);
    what_->setText(job.isCancelled() ? tr("Cancelling, what is done is kept") : case_);
    what_->setVisible(!what_->text().isEmpty());
}

} // namespace smat::gui
