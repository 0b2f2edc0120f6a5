#include "gui/widgets/FlowBar.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>

namespace smat::gui {

FlowBar::FlowBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    both_ = new QBoxLayout(QBoxLayout::LeftToRight, this);
    both_->setContentsMargins(0, 0, 0, 0);
    first_ = new QHBoxLayout;
    second_ = new QHBoxLayout;
    both_->addLayout(first_);
    both_->addStretch(1);
    both_->addLayout(second_);
    both_->setAlignment(first_, Qt::AlignLeft | Qt::AlignVCenter);
    both_->setAlignment(second_, Qt::AlignRight | Qt::AlignVCenter);
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

void FlowBar::arrange() {
    const QMargins around = both_->contentsMargins();
    const int needed = first_->sizeHint().width() + second_->sizeHint().width() +
                       2 * both_->spacing() + around.left() + around.right();
    const auto direction = width() < needed ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
    if (direction == both_->direction())
        return;
    both_->setDirection(direction);
    updateGeometry();
}

} // namespace smat::gui

#include "moc_FlowBar.cpp"
