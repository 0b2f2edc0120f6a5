#include "gui/MessagesDock.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/MessageLog.h"

namespace smat::gui {
namespace {

enum MessageColumn { timeColumn, sourceColumn, sentenceColumn, placeColumn };

QIcon iconOf(MessageKind kind) {
    return icon(kind == MessageKind::remark    ? "info"
                : kind == MessageKind::warning ? "warning"
                                               : "error");
}

QString wordOf(MessageKind kind) {
    return kind == MessageKind::remark    ? MessagesDock::tr("remark")
           : kind == MessageKind::warning ? MessagesDock::tr("warning")
                                          : MessagesDock::tr("error");
}

} // namespace

MessagesDock::MessagesDock(MessageLog& log, QWidget* parent)
    : QDockWidget(tr("Messages"), parent), log_(log) {
    setObjectName("messagesDock");
    auto* body = new QWidget(this);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(6, 6, 6, 6);
    column->setSpacing(4);
    makeList();
    clear_ = textButton(tr("Clear"), "clearMessages", tr("Remove all messages from the list"));
    copy_ = textButton(tr("Copy"), "copyMessages",
                       tr("Copy the chosen messages, or all if none is chosen (Ctrl+C)"));
    auto* row = new QHBoxLayout;
    row->addStretch(1);
    row->addWidget(copy_);
    row->addWidget(clear_);
    column->addWidget(list_, 1);
    column->addLayout(row);
    setWidget(body);

    counter_ = new QToolButton(this);
    counter_->setObjectName("messageCount");
    counter_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    counter_->setAutoRaise(true);
    counter_->setIcon(icon("info"));
    // No higher than the words beside it in the status bar, which stays as it is.
    counter_->setIconSize(QSize(14, 14));
    counter_->setFixedHeight(fontMetrics().height() + 2);

    connect(counter_, &QToolButton::clicked, this, [this] {
        show();
        raise();
        list_->setFocus();
    });
    connect(clear_, &QToolButton::clicked, &log_, &MessageLog::clear);
    connect(copy_, &QToolButton::clicked, this, &MessagesDock::copy);
    connect(&log_, &MessageLog::added, this, &MessagesDock::append);
    connect(&log_, &MessageLog::repeated, this, [this] {
        fill(*list_->topLevelItem(list_->topLevelItemCount() - 1), log_.messages().back());
        noteNew();
    });
    connect(&log_, &MessageLog::dropped, this, [this] { delete list_->topLevelItem(0); });
    connect(&log_, &MessageLog::cleared, this, [this] {
        list_->clear();
        unseen_ = 0;
        refresh();
    });
    connect(this, &QDockWidget::visibilityChanged, this, [this](bool isVisible) {
        if (isVisible)
            unseen_ = 0;
        refresh();
    });
    refresh();
}

MessagesDock::~MessagesDock() {
    disconnect(this, &QDockWidget::visibilityChanged, this, nullptr); // the log may be gone
}

void MessagesDock::makeList() {
    list_ = new QTreeWidget(this);
    list_->setObjectName("messages");
    list_->setHeaderLabels({tr("Time"), tr("Source"), tr("Message"), tr("Place")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setMinimumHeight(60);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(sentenceColumn, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(placeColumn, QHeaderView::ResizeToContents);
    list_->setColumnWidth(timeColumn, 92);
    list_->setColumnWidth(sourceColumn, 120);
    connect(list_, &QTreeWidget::itemActivated, this, &MessagesDock::goThere);
    auto* keys = new QShortcut(QKeySequence::Copy, list_);
    keys->setContext(Qt::WidgetShortcut);
    connect(keys, &QShortcut::activated, this, &MessagesDock::copy);
}

void MessagesDock::append() {
    const bool follows = list_->selectedItems().isEmpty();
    auto* item = new QTreeWidgetItem(list_);
    const Message& message = log_.messages().back();
    fill(*item, message);
    if (message.goThere) {
        auto* button = textButton(tr("Show"), "showPlace", tr("Show what this is about"));
        button->setAutoRaise(true);
        connect(button, &QToolButton::clicked, this, [this, item] { goThere(item); });
        list_->setItemWidget(item, placeColumn, button);
    }
    if (follows)
        list_->scrollToItem(item);
    noteNew();
}

void MessagesDock::fill(QTreeWidgetItem& item, const Message& message) {
    item.setIcon(timeColumn, iconOf(message.kind));
    item.setText(timeColumn, message.time.toString("HH:mm:ss"));
    item.setText(sourceColumn, message.source);
    item.setText(sentenceColumn, message.count > 1
                                     ? tr("%1 (%2 times)").arg(message.sentence).arg(message.count)
                                     : message.sentence);
    item.setToolTip(timeColumn, message.time.toString(Qt::ISODate) + ", " + wordOf(message.kind));
    item.setToolTip(sourceColumn, message.source);
    item.setToolTip(sentenceColumn, message.sentence);
}

void MessagesDock::goThere(QTreeWidgetItem* item) {
    const int row = list_->indexOfTopLevelItem(item);
    if (row < 0)
        return;
    // A copy: what is shown may say something, and let the oldest go.
    const std::function<void()> act = log_.messages().at(static_cast<std::size_t>(row)).goThere;
    if (act)
        act();
}

void MessagesDock::copy() const {
    QStringList lines;
    const bool isAnyChosen = !list_->selectedItems().isEmpty();
    for (int row = 0; row < list_->topLevelItemCount(); ++row) {
        if (isAnyChosen && !list_->topLevelItem(row)->isSelected())
            continue;
        const Message& message = log_.messages().at(static_cast<std::size_t>(row));
        lines << QStringList{message.time.toString(Qt::ISODate), wordOf(message.kind),
                             message.source, message.sentence}
                     .join('\t');
    }
    QApplication::clipboard()->setText(lines.join('\n'));
}

void MessagesDock::noteNew() {
    if (!isVisible())
        ++unseen_;
    refresh();
}

void MessagesDock::refresh() {
    const bool isAny = !log_.messages().empty();
    clear_->setEnabled(isAny);
    copy_->setEnabled(isAny);
    counter_->setVisible(unseen_ > 0);
    counter_->setText(QString::number(unseen_));
    counter_->setToolTip(unseen_ == 1 ? tr("One new message: show the panel")
                                      : tr("%1 new messages: show the panel").arg(unseen_));
    if (unseen_ > 0)
        counter_->setIcon(iconOf(log_.messages().back().kind));
}

} // namespace smat::gui

#include "moc_MessagesDock.cpp"
