#include "gui/widgets/FoldingSplitter.h"

#include <algorithm>

#include "gui/widgets/VerticalScrollArea.h"

namespace smat::gui {
namespace {

QSize leastOf(const QWidget& widget) {
    return widget.minimumSizeHint().expandedTo(widget.minimumSize());
}

} // namespace

FoldingSplitter::FoldingSplitter(QWidget* form, int form_px, QWidget* result, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent) {
    constexpr int usualWidth_px = 1260;
    addWidget(form);
    addWidget(result);
    setChildrenCollapsible(false);
    for (auto* area : form->findChildren<VerticalScrollArea*>())
        area->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
    policy_ = form->sizePolicy();
    setStretchFactor(0, 0);
    setStretchFactor(1, 1);
    beside_ = {form_px, usualWidth_px - form_px};
    setSizes(beside_);
}

QSize FoldingSplitter::minimumSizeHint() const {
    const QSize form = leastOf(*widget(0)), result = leastOf(*widget(1));
    return {std::max(form.width(), result.width()),
            orientation() == Qt::Horizontal ? std::max(form.height(), result.height())
                                            : form.height() + result.height() + handleWidth()};
}

void FoldingSplitter::resizeEvent(QResizeEvent* event) {
    const int form_px = policy_.horizontalPolicy() == QSizePolicy::Fixed
                            ? widget(0)->sizeHint().width()
                            : leastOf(*widget(0)).width();
    const int both_px = form_px + leastOf(*widget(1)).width() + handleWidth();
    const auto wanted = width() >= both_px ? Qt::Horizontal : Qt::Vertical;
    if (wanted != orientation()) {
        if (wanted == Qt::Vertical && sizes().front() > 0)
            beside_ = sizes();
        setOrientation(wanted);
        // A form of fixed width would hold what is below it to that width.
        QSizePolicy policy = policy_;
        if (wanted == Qt::Vertical)
            policy.setHorizontalPolicy(QSizePolicy::Preferred);
        widget(0)->setSizePolicy(policy);
        if (wanted == Qt::Horizontal)
            setSizes(beside_);
        else
            setSizes({leastOf(*widget(0)).height(), leastOf(*widget(1)).height()});
        updateGeometry();
    }
    QSplitter::resizeEvent(event);
}

} // namespace smat::gui

#include "moc_FoldingSplitter.cpp"
