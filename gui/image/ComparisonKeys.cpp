#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMimeData>
#include <QTabWidget>

#include "gui/image/ComparisonPanes.h"
#include "gui/image/ComparisonWindow.h"
#include "gui/image/FiguresTable.h"
#include "gui/image/ImageCanvas.h"
#include "gui/image/ImageExport.h"
#include "gui/image/PaperPicture.h"
#include "smatcore/analysis/Conditions.h"
#include <algorithm>

namespace smat::gui {
namespace {

constexpr double exposureStep = 0.25, offsetStep = 0.05;
constexpr int thresholdsTab = 1, histogramTab = 2;

} // namespace

void ComparisonWindow::keyPressEvent(QKeyEvent* event) {
    const bool back = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->matches(QKeySequence::Copy)) {
        numbers_->copy();
        return;
    }
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        QWidget::keyPressEvent(event);
        return;
    }
    switch (event->key()) {
    case Qt::Key_Space:
        if (!event->isAutoRepeat())
            panes_->setFlicker(true);
        return;
    case Qt::Key_V:
        panes_->setWipe(!panes_->isWiping());
        return;
    case Qt::Key_W:
        goToWorstPixel();
        return;
    case Qt::Key_X:
        mark_->toggle();
        return;
    case Qt::Key_S:
        swapSides();
        return;
    case Qt::Key_M: {
        const int step = back ? colors_->count() - 1 : 1;
        colors_->setCurrentIndex((colors_->currentIndex() + step) % colors_->count());
        return;
    }
    case Qt::Key_E:
        panes_->activeBar()->changeExposure(back ? -exposureStep : exposureStep);
        return;
    case Qt::Key_O:
        if (!panes_->activeBar()->map().isDiverging())
            panes_->activeBar()->changeOffset(back ? offsetStep : -offsetStep);
        return;
    case Qt::Key_N:
    case Qt::Key_L: {
        ColorBar* bar = panes_->activeBar();
        const LimitMode automatic =
            bar == panes_->sharedBar() ? LimitMode::target : LimitMode::full;
        bar->setMode(event->key() == Qt::Key_N ? automatic : LimitMode::locked);
        emit bar->modeChosen(bar->mode());
        return;
    }
    case Qt::Key_H:
    case Qt::Key_T: {
        const int tab = event->key() == Qt::Key_H ? histogramTab : thresholdsTab;
        tabs_->setCurrentIndex(tabs_->currentIndex() == tab ? 0 : tab);
        return;
    }
    default:
        if (event->key() >= Qt::Key_1 && event->key() <= Qt::Key_4 && difference_)
            setDifferenceMode(irsg::allDifferenceModes[event->key() - Qt::Key_1]);
        else
            QWidget::keyPressEvent(event);
    }
}

void ComparisonWindow::keyReleaseEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        panes_->setFlicker(false);
    else
        QWidget::keyReleaseEvent(event);
}

bool ComparisonWindow::eventFilter(QObject* watched, QEvent* event) {
    // A key that is held while the focus goes elsewhere is let go unseen.
    if (event->type() == QEvent::FocusOut && panes_->isFlickering())
        panes_->setFlicker(false);
    return QWidget::eventFilter(watched, event);
}

void ComparisonWindow::dragEnterEvent(QDragEnterEvent* event) {
    const auto urls = event->mimeData()->urls();
    const bool local =
        std::all_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
    if (!urls.isEmpty() && urls.size() <= 2 && local)
        event->acceptProposedAction();
}

void ComparisonWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        files << url.toLocalFile();
    // One file takes the place of the image it is dropped on.
    const QWidget* under = childAt(event->position().toPoint());
    std::optional<int> side;
    for (const int i : {0, 1})
        if (under == panes_->canvas(i))
            side = i;
    event->acceptProposedAction();
    openFiles(files, side);
}

void ComparisonWindow::copyPicture() const {
    if (!difference_)
        return;
    QGuiApplication::clipboard()->setImage(pictureOfDifference(*difference_));
}

void ComparisonWindow::copyCommand() const {
    if (const QString command = commandLine(); !command.isEmpty())
        QGuiApplication::clipboard()->setText(command);
}

QImage ComparisonWindow::pictureOfDifference(const irsg::RadianceImage& difference) const {
    // The conditions that both images have.
    std::vector<Condition> conditions = conditionsOf(*sides_[0].image);
    const std::vector<Condition> ofB = conditionsOf(*sides_[1].image);
    std::erase_if(conditions,
                  [&](const Condition& one) { return std::ranges::find(ofB, one) == ofB.end(); });
    const ColorBar& bar = *panes_->differenceBar();
    return onPaper({enlargedPlane(difference, difference.primary(), bar),
                    tr("%1 of two images").arg(differenceName(mode_)),
                    QString::fromStdString(lineOf(conditions)), &bar});
}

} // namespace smat::gui
