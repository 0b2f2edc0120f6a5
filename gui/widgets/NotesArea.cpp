#include "gui/widgets/NotesArea.h"

#include <algorithm>

#include <QEvent>
#include <QLabel>

namespace smat::gui {

NotesArea::NotesArea(QLabel* notes, int most_px, QWidget* parent)
    : QScrollArea(parent), most_px_(most_px) {
    notes->setWordWrap(true);
    setFrameShape(QFrame::NoFrame);
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    setWidget(notes);
}

bool NotesArea::event(QEvent* event) {
    const bool isDone = QScrollArea::event(event);
    if (event->type() == QEvent::LayoutRequest)
        fit(); // other words
    return isDone;
}

void NotesArea::resizeEvent(QResizeEvent* event) {
    QScrollArea::resizeEvent(event);
    fit();
}

void NotesArea::fit() {
    const auto* notes = qobject_cast<const QLabel*>(widget());
    if (notes == nullptr)
        return;
    const int height = notes->text().isEmpty()
                           ? 0
                           : std::min(notes->heightForWidth(viewport()->width()), most_px_);
    if (height != minimumHeight() || height != maximumHeight())
        setFixedHeight(height);
}

} // namespace smat::gui

#include "moc_NotesArea.cpp"
