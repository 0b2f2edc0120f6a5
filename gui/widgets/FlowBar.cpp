#include "gui/widgets/FlowBar.h"

#include <algorithm>

#include <QEvent>

namespace smat::gui {

QSize WrappingRow::minimumSize() const {
    QSize least;
    for (int i = 0; i < count(); ++i)
        if (!itemAt(i)->isEmpty())
            least = least.expandedTo(itemAt(i)->minimumSize());
    return least;
}

int WrappingRow::place(int width, QList<std::pair<QLayoutItem*, QRect>>* places) const {
    QPoint at(0, 0);
    int row_px = 0;
    for (int i = 0; i < count(); ++i) {
        QLayoutItem* item = itemAt(i);
        const bool isBlank = item->spacerItem() != nullptr;
        if (isBlank && at.x() > 0)
            at.rx() += item->sizeHint().width();
        if (isBlank || item->isEmpty())
            continue;
        const int item_px =
            std::clamp(item->sizeHint().width(), 0, std::max(width, item->minimumSize().width()));
        if (at.x() > 0 && at.x() + item_px > width) {
            at = {0, at.y() + row_px + spacing()};
            row_px = 0;
        }
        const QSize size(item_px, item->sizeHint().height());
        if (places != nullptr)
            places->emplace_back(item, QRect(at, size));
        at.rx() += item_px + spacing();
        row_px = std::max(row_px, size.height());
    }
    return at.y() + row_px;
}

int WrappingRow::heightForWidth(int width) const {
    return width >= sizeHint().width() ? sizeHint().height() : place(width, nullptr);
}

void WrappingRow::setGeometry(const QRect& room) {
    QHBoxLayout::setGeometry(room);
    if (room.width() >= sizeHint().width())
        return;
    QList<std::pair<QLayoutItem*, QRect>> places;
    place(room.width(), &places);
    for (const auto& [item, at] : places)
        item->setGeometry(at.translated(room.topLeft()));
}

FlowBar::FlowBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    both_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
    both_->setContentsMargins(0, 0, 0, 0);
    first_ = new WrappingRow;
    second_ = new WrappingRow;
    both_->addLayout(first_);
    both_->addStretch(1);
    both_->addLayout(second_);
    both_->setAlignment(first_, Qt::AlignLeft); // rows take the height that they need
    both_->setAlignment(second_, Qt::AlignRight);
}

QSize FlowBar::minimumSizeHint() const {
    const QMargins around = both_->contentsMargins();
    return {std::max(first_->minimumSize().width(), second_->minimumSize().width()) +
                around.left() + around.right(),
            both_->minimumSize().height()};
}

bool FlowBar::event(QEvent* event) {
    // A field that comes or goes may need the second row, or no longer.
    if (event->type() == QEvent::LayoutRequest)
        arrange();
    return QWidget::event(event);
}

void FlowBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void FlowBar::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    // What became narrower while it was hidden has been placed with the old height.
    QMetaObject::invokeMethod(
        this,
        [this] {
            both_->invalidate();
            arrange();
            if (QLayout* around = parentWidget() != nullptr ? parentWidget()->layout() : nullptr) {
                around->invalidate();
                around->activate();
            }
        },
        Qt::QueuedConnection);
}

void FlowBar::arrange() {
    const QMargins around = both_->contentsMargins();
    const int needed = first_->sizeHint().width() + second_->sizeHint().width() +
                       2 * both_->spacing() + around.left() + around.right();
    const auto direction = width() < needed ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
    if (direction != both_->direction()) {
        both_->setDirection(direction);
        updateGeometry();
    }
    // A fixed height does not follow the width by itself.
    if (const int height = both_->totalHeightForWidth(width()); height != minimumHeight())
        setFixedHeight(height);
}

} // namespace smat::gui

#include "moc_FlowBar.cpp"
