#include "gui/CommandPalette.h"

#include <algorithm>

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace smat::gui {
namespace {

QString plain(QString text) {
    return text.remove('&');
}

} // namespace

CommandPalette::CommandPalette(const QMenuBar& menus, QWidget* parent) : QDialog(parent) {
    setObjectName("commandPalette");
    setWindowTitle(tr("Find a command"));
    for (const QAction* entry : menus.actions())
        if (entry->menu() != nullptr && entry->isVisible())
            collect(*entry->menu(), plain(entry->text()));

    words_ = new QLineEdit(this);
    words_->setObjectName("paletteWords");
    words_->setPlaceholderText(tr("Words of a command, such as sun or save"));
    words_->setClearButtonEnabled(true);
    words_->installEventFilter(this);
    list_ = new QTreeWidget(this);
    list_->setObjectName("paletteList");
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFocusPolicy(Qt::NoFocus);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 14, 14, 14);
    column->setSpacing(8);
    column->addWidget(words_);
    column->addWidget(list_, 1);
    connect(words_, &QLineEdit::textChanged, this, &CommandPalette::refresh);
    connect(words_, &QLineEdit::returnPressed, this, [this] {
        if (chosen() != nullptr)
            accept();
    });
    connect(list_, &QTreeWidget::itemClicked, this, &QDialog::accept);
    constexpr int usualWidth_px = 520, usualHeight_px = 420;
    resize(usualWidth_px, usualHeight_px);
    refresh();
}

void CommandPalette::collect(const QMenu& menu, const QString& path) {
    // Menus of files and analyses are made when they are opened.
    emit const_cast<QMenu&>(menu).aboutToShow();
    for (QAction* action : menu.actions()) {
        const QString name = path + " → " + plain(action->text());
        if (action->menu() != nullptr)
            collect(*action->menu(), name);
        else if (!action->isSeparator() && action->isEnabled() && action->isVisible())
            commands_.push_back({action, name});
    }
}

void CommandPalette::refresh() {
    const QStringList wanted = words_->text().split(' ', Qt::SkipEmptyParts);
    list_->clear();
    QPixmap nothing(list_->iconSize().isValid() ? list_->iconSize() : QSize(16, 16));
    nothing.fill(Qt::transparent);
    for (qsizetype i = 0; i < commands_.size(); ++i) {
        const Command& command = commands_[i];
        const bool fits = std::all_of(wanted.begin(), wanted.end(), [&](const QString& word) {
            return command.path.contains(word, Qt::CaseInsensitive);
        });
        if (!fits || command.action == nullptr)
            continue;
        auto* row = new QTreeWidgetItem(
            list_, {command.path, command.action->shortcut().toString(QKeySequence::NativeText)});
        // All names begin in one line.
        const QIcon picture = command.action->icon();
        row->setIcon(0, picture.isNull() ? QIcon(nothing) : picture);
        row->setData(0, Qt::UserRole, i);
        row->setForeground(1, palette().color(QPalette::PlaceholderText));
    }
    list_->setCurrentItem(list_->topLevelItem(0));
}

QAction* CommandPalette::chosen() const {
    const auto* row = list_->currentItem();
    return row == nullptr ? nullptr
                          : commands_[row->data(0, Qt::UserRole).toLongLong()].action.data();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == words_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int rows = list_->topLevelItemCount();
        const int now = list_->indexOfTopLevelItem(list_->currentItem());
        const int page =
            std::max(1, list_->viewport()->height() / std::max(1, list_->sizeHintForRow(0)));
        const int step = key == Qt::Key_Down       ? 1
                         : key == Qt::Key_Up       ? -1
                         : key == Qt::Key_PageDown ? page
                         : key == Qt::Key_PageUp   ? -page
                                                   : 0;
        if (step != 0 && rows > 0) {
            list_->setCurrentItem(list_->topLevelItem(std::clamp(now + step, 0, rows - 1)));
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

} // namespace smat::gui

#include "moc_CommandPalette.cpp"
