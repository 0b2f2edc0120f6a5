#include "gui/analysis/ResultsDock.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/Theme.h"
#include "gui/Workbench.h"

namespace smat::gui {
namespace {

QToolButton* labelled(const QString& iconName, const QString& text, const QString& name,
                      QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setIcon(icon(iconName));
    button->setText(text);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setObjectName(name);
    button->setAutoRaise(true);
    return button;
}

} // namespace

ResultsDock::ResultsDock(Workbench& workbench, QWidget* parent)
    : QDockWidget(tr("Results"), parent), workbench_(workbench) {
    setObjectName("resultsDock");
    setFeatures(DockWidgetMovable | DockWidgetFloatable | DockWidgetClosable);
    auto* body = new QWidget(this);
    body->setMinimumWidth(230);

    jobPanel_ = new QWidget(body);
    jobPanel_->setObjectName("jobPanel");
    jobTitle_ = new QLabel(jobPanel_);
    QFont bold = jobTitle_->font();
    bold.setBold(true);
    jobTitle_->setFont(bold);
    progress_ = new QProgressBar(jobPanel_);
    progress_->setObjectName("jobProgress");
    progress_->setRange(0, 1000);
    progress_->setTextVisible(true);
    jobDetail_ = new QLabel(jobPanel_);
    jobDetail_->setObjectName("jobDetail");
    jobDetail_->setForegroundRole(QPalette::PlaceholderText);
    jobDetail_->setWordWrap(true);
    cancel_ = labelled("cancel", tr("Cancel"), "cancelJob", jobPanel_);
    cancel_->setToolTip(tr("Stop and keep what is done so far (Esc)"));
    cancel_->setShortcut(Qt::Key_Escape);
    auto* jobTop = new QHBoxLayout;
    jobTop->addWidget(jobTitle_, 1);
    jobTop->addWidget(cancel_);
    auto* jobColumn = new QVBoxLayout(jobPanel_);
    jobColumn->setContentsMargins(0, 0, 0, 6);
    jobColumn->addLayout(jobTop);
    jobColumn->addWidget(progress_);
    jobColumn->addWidget(jobDetail_);
    jobPanel_->hide();

    list_ = new QListWidget(body);
    list_->setObjectName("resultList");
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setAlternatingRowColors(true);
    list_->setIconSize(QSize(20, 20));
    list_->setSpacing(1);
    empty_ = new QLabel(tr("No results yet.\nChoose one of the analyses."), list_);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* overEmpty = new QVBoxLayout(list_);
    overEmpty->addWidget(empty_);
    overlay_ = labelled("polar", tr("Overlay"), "overlayResults", body);
    overlay_->setToolTip(tr("Draw the selected results on one plot"));
    remove_ = labelled("remove", tr("Remove"), "removeResult", body);
    remove_->setToolTip(tr("Take the selected results off the list"));

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(overlay_);
    buttons->addWidget(remove_);
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(10, 8, 10, 8);
    column->addWidget(jobPanel_);
    column->addWidget(list_, 1);
    column->addLayout(buttons);
    setWidget(body);

    timer_ = new QTimer(this);
    timer_->setInterval(100);
    connect(timer_, &QTimer::timeout, this, &ResultsDock::refreshElapsed);
    connect(cancel_, &QToolButton::clicked, this, [this] {
        workbench_.cancel();
        cancel_->setEnabled(false);
        refreshElapsed();
    });
    connect(&workbench_, &Workbench::jobStarted, this, &ResultsDock::onJobStarted);
    connect(&workbench_, &Workbench::jobProgressed, this, [this](const Progress& now) {
        progress_->setRange(0, 1000);
        progress_->setValue(static_cast<int>(1000.0 * now.fraction()));
        what_ = QString::fromStdString(now.what);
        refreshElapsed();
    });
    connect(&workbench_, &Workbench::jobEnded, this, [this] {
        timer_->stop();
        jobPanel_->hide();
    });
    connect(&workbench_, &Workbench::resultAdded, this, &ResultsDock::addResult);
    connect(&workbench_, &Workbench::resultRemoved, this, [this](int id) {
        for (int row = list_->count() - 1; row >= 0; --row) {
            if (list_->item(row)->data(Qt::UserRole).toInt() == id)
                delete list_->takeItem(row);
        }
        empty_->setVisible(list_->count() == 0);
    });
    connect(list_, &QListWidget::itemSelectionChanged, this, &ResultsDock::refreshButtons);
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        emit showRequested({item->data(Qt::UserRole).toInt()});
    });
    connect(overlay_, &QToolButton::clicked, this,
            [this] { emit showRequested(selectedResults()); });
    connect(remove_, &QToolButton::clicked, this, [this] {
        for (const int id : selectedResults())
            workbench_.removeResult(id);
    });
    refreshButtons();
}

void ResultsDock::onJobStarted(const QString& title) {
    jobTitle_->setText(title);
    what_.clear();
    progress_->setRange(0, 0);
    cancel_->setEnabled(true);
    jobPanel_->show();
    timer_->start();
    refreshElapsed();
}

void ResultsDock::refreshElapsed() {
    if (!workbench_.isRunning())
        return;
    const QString time = tr("%1 s").arg(workbench_.job()->elapsed_s(), 0, 'f', 1);
    if (workbench_.job()->isCancelled())
        jobDetail_->setText(tr("Cancelling, what is done is kept   %1").arg(time));
    else
        jobDetail_->setText(what_.isEmpty() ? time : what_ + "   " + time);
}

void ResultsDock::addResult(int id) {
    const ResultEntry* entry = workbench_.result(id);
    auto* item = new QListWidgetItem(icon(QString::fromStdString(name(entry->data.kind))),
                                     entry->title, list_);
    item->setData(Qt::UserRole, id);
    QStringList words{QString::fromStdString(entry->data.renderer)};
    for (const auto& figure : entry->data.summary)
        words << QStringLiteral("%1: %2 %3")
                     .arg(QString::fromStdString(figure.label))
                     .arg(figure.value, 0, 'g', 6)
                     .arg(QString::fromStdString(figure.unit));
    for (const auto& warning : entry->data.warnings)
        words << tr("Note: %1").arg(QString::fromStdString(warning));
    item->setToolTip(words.join('\n').trimmed());
    list_->setCurrentItem(item, QItemSelectionModel::ClearAndSelect);
    empty_->hide();
    refreshButtons();
}

QList<int> ResultsDock::selectedResults() const {
    QList<int> ids;
    for (const auto* item : list_->selectedItems())
        ids << item->data(Qt::UserRole).toInt();
    return ids;
}

void ResultsDock::refreshButtons() {
    const auto ids = selectedResults();
    bool sameKind = ids.size() > 1;
    for (const int id : ids) {
        const auto* entry = workbench_.result(id);
        const auto* first = workbench_.result(ids.front());
        sameKind = sameKind && entry && first && entry->data.kind == first->data.kind &&
                   entry->data.kind != AnalysisKind::image;
    }
    overlay_->setEnabled(sameKind);
    remove_->setEnabled(!ids.isEmpty());
}

} // namespace smat::gui
