#include "gui/widgets/VerticalScrollArea.h"

#include <algorithm>

#include <QEvent>
#include <QScrollBar>

namespace smat::gui {
namespace {

constexpr int leastHeight_px = 120;

} // namespace

VerticalScrollArea::VerticalScrollArea(QWidget* body, QWidget* parent, int leastWidth_px)
    : QScrollArea(parent), leastWidth_px_(leastWidth_px) {
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    setWidget(body);
}

QSize VerticalScrollArea::sizeHint() const {
    return {minimumSizeHint().width(), QScrollArea::sizeHint().height()};
}

QSize VerticalScrollArea::minimumSizeHint() const {
    const int bar = verticalScrollBar()->sizeHint().width();
    return {std::max(leastWidth_px_, widget()->minimumSizeHint().width() + bar), leastHeight_px};
}

bool VerticalScrollArea::eventFilter(QObject* watched, QEvent* event) {
    if (watched == widget() && event->type() == QEvent::LayoutRequest)
        updateGeometry();
    return QScrollArea::eventFilter(watched, event);
}

} // namespace smat::gui

#include "moc_VerticalScrollArea.cpp"
