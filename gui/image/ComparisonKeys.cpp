#include "gui/image/ComparisonKeys.h"

#include <QKeyEvent>

#include "gui/image/ColorBar.h"
#include "gui/image/ComparisonBar.h"
#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonReport.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageCanvas.h"

namespace smat::gui {
ComparisonKeys::ComparisonKeys(ComparisonWindow* window, ComparisonBar& bar, ComparisonPanes& panes,
                               ComparisonReport& report)
    : QObject(window), bar_(bar), panes_(panes), report_(report) {
    window->installEventFilter(this);
    for (int i = 0; i < 3; ++i)
        panes.canvas(i)->installEventFilter(this);
}

bool ComparisonKeys::eventFilter(QObject* watched, QEvent* event) {
    // A key that is held while the focus goes elsewhere is let go unseen.
    if (event->type() == QEvent::FocusOut && panes_.isFlickering())
        panes_.setFlicker(false);
    if (watched != parent())
        return false;
    if (event->type() == QEvent::KeyPress)
        return press(static_cast<const QKeyEvent&>(*event));
    if (event->type() != QEvent::KeyRelease)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool isFlicker = key.key() == Qt::Key_Space && !key.isAutoRepeat();
    if (isFlicker)
        panes_.setFlicker(false);
    return isFlicker;
}

bool ComparisonKeys::press(const QKeyEvent& event) {
    if (event.matches(QKeySequence::Copy)) {
        report_.numbers()->copy();
        return true;
    }
    if (event.modifiers().testFlag(Qt::ControlModifier))
        return false;
    switch (event.key()) {
    case Qt::Key_Space:
        if (!event.isAutoRepeat())
            panes_.setFlicker(true);
        return true;
    case Qt::Key_V:
        panes_.setWipe(!panes_.isWiping());
        return true;
    case Qt::Key_W:
        emit bar_.worstWanted();
        return true;
    case Qt::Key_X:
        bar_.toggleMarks();
        return true;
    case Qt::Key_S:
        emit bar_.swapWanted();
        return true;
    case Qt::Key_H:
        report_.toggle(ComparisonReport::histogramTab);
        return true;
    case Qt::Key_T:
        report_.toggle(ComparisonReport::thresholdsTab);
        return true;
    default:
        if (event.key() < Qt::Key_1 || event.key() > Qt::Key_4 || !panes_.canvas(2)->hasImage())
            return pressOnColors(event);
        emit bar_.modeChosen(irsg::allDifferenceModes[event.key() - Qt::Key_1]);
        return true;
    }
}

bool ComparisonKeys::pressOnColors(const QKeyEvent& event) {
    const bool back = event.modifiers().testFlag(Qt::ShiftModifier);
    ColorBar& bar = *panes_.activeBar();
    switch (event.key()) {
    case Qt::Key_M:
        bar_.changeColors(back);
        return true;
    case Qt::Key_E:
        bar.changeExposure(back ? -ColorBar::exposureStep : ColorBar::exposureStep);
        return true;
    case Qt::Key_O:
        if (!bar.map().isDiverging())
            bar.changeOffset(back ? ColorBar::offsetStep : -ColorBar::offsetStep);
        return true;
    case Qt::Key_N:
    case Qt::Key_L: {
        const LimitMode automatic =
            &bar == panes_.sharedBar() ? LimitMode::target : LimitMode::full;
        bar.setMode(event.key() == Qt::Key_N ? automatic : LimitMode::locked);
        emit bar.modeChosen(bar.mode());
        return true;
    }
    default:
        return false;
    }
}

QList<std::pair<QString, QString>> comparisonKeys() {
    return {{ComparisonKeys::tr("Space, held"), ComparisonKeys::tr("B in the place of A")},
            {ComparisonKeys::tr("V"), ComparisonKeys::tr("Wipe between A and B")},
            {ComparisonKeys::tr("1 … 4"),
             ComparisonKeys::tr("Signed, absolute, relative difference, ratio")},
            {ComparisonKeys::tr("W"), ComparisonKeys::tr("Go to the worst pixel")},
            {ComparisonKeys::tr("X"), ComparisonKeys::tr("Mark pixels over the thresholds")},
            {ComparisonKeys::tr("S"), ComparisonKeys::tr("Exchange A and B")},
            {ComparisonKeys::tr("H, T"), ComparisonKeys::tr("Histogram, thresholds")}};
}

} // namespace smat::gui

#include "moc_ComparisonKeys.cpp"
