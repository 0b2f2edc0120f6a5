#include "gui/image/ComparisonPanes.h"

#include <algorithm>

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>

#include "gui/image/ComparedPair.h"
#include "gui/image/ImageCanvas.h"

namespace smat::gui {
namespace {

constexpr int wipeSteps = 1000;
constexpr double closeZoom = 24.0;

constexpr int leastCompanionWidth_px = 150;
/// Below it the companion stands under the images.
constexpr int narrow_px = 560;

/// Takes the size it is given: what it holds would else make its column the wider one, and lines
/// that wrap in it its row the higher one.
class Beside : public QWidget {
  public:
    using QWidget::QWidget;
    bool hasHeightForWidth() const override { return false; }
    QSize minimumSizeHint() const override {
        return {leastCompanionWidth_px, QWidget::minimumSizeHint().height()};
    }
    QSize sizeHint() const override { return minimumSizeHint(); }
};

} // namespace

ComparisonPanes::ComparisonPanes(QWidget* parent) : QWidget(parent) {
    setObjectName("comparisonPanes");
    colors_ = new ComparisonColors(this);
    static const char* const names[] = {"canvasA", "canvasB", "canvasDifference"};
    for (std::size_t i = 0; i < canvases_.size(); ++i) {
        canvases_[i] = new ImageCanvas(this);
        canvases_[i]->setObjectName(names[i]);
        canvases_[i]->setMinimumSize(110, 120);
        canvases_[i]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
        link(canvases_[i]);
    }
    canvases_[0]->setHint(tr("Open image A, or drop it here"));
    canvases_[1]->setHint(tr("Open image B, or drop it here"));
    canvases_[2]->setHint(tr("The difference of two images of the same size"));

    grid_ = new QGridLayout(this);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(8);
    grid_->setVerticalSpacing(4);
    grid_->addWidget(makeTitle(0), 0, 0);
    grid_->addWidget(makeTitle(1), 0, 1);
    grid_->addWidget(canvases_[0], 1, 0);
    grid_->addWidget(canvases_[1], 1, 1);
    grid_->addWidget(sharedBar(), 1, 2);
    grid_->addWidget(makeTitle(2), 2, 0);
    grid_->addWidget(canvases_[2], 3, 0);
    for (const int row : {1, 3})
        grid_->setRowStretch(row, 1);
    for (const int column : {0, 1})
        grid_->setColumnStretch(column, 1);
    makeWipe();
    setCompanion(new QWidget(this));

    connect(wipe_, &QCheckBox::toggled, this, &ComparisonPanes::setWipe);
    connect(wipeAt_, &QSlider::valueChanged, this, [this] { setWipe(wipe_->isChecked()); });
    followColors();
}

void ComparisonPanes::followColors() {
    connect(colors_, &ComparisonColors::sharedAwaited, this, [this] {
        for (std::size_t i = 0; i < planes_.size(); ++i)
            if (planes_[i].values)
                canvases_[i]->awaitColors();
    });
    connect(colors_, &ComparisonColors::sharedFound, this,
            [this](const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
                for (const int i : {0, 1})
                    canvas(i)->setColors(map, limits);
            });
    connect(colors_, &ComparisonColors::differenceAwaited, canvases_[2], &ImageCanvas::awaitColors);
    connect(colors_, &ComparisonColors::differenceFound, this,
            [this](const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
                canvases_[2]->setColors(map, limits);
                emit differenceLimitsFound(limits);
            });
}

QLabel* ComparisonPanes::makeTitle(int index) {
    auto* label = new QLabel(this);
    static const char* const names[] = {"titleA", "titleB", "titleDifference"};
    label->setObjectName(names[index]);
    label->setContentsMargins(2, 0, 2, 0);
    label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    titles_[static_cast<std::size_t>(index)] = label;
    return label;
}

void ComparisonPanes::makeWipe() {
    wipeControl_ = new QWidget(this);
    wipe_ = new QCheckBox(tr("Wipe"), wipeControl_);
    wipe_->setObjectName("wipe");
    wipe_->setToolTip(tr("A on the left of the line, B on its right (V)"));
    wipeAt_ = new QSlider(Qt::Horizontal, wipeControl_);
    wipeAt_->setObjectName("wipeAt");
    wipeAt_->setRange(0, wipeSteps);
    wipeAt_->setValue(wipeSteps / 2);
    wipeAt_->setFixedWidth(90);
    wipeAt_->setEnabled(false);
    wipeAt_->setToolTip(tr("Place of the line between A and B"));
    wipeControl_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    auto* row = new QHBoxLayout(wipeControl_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(wipe_);
    row->addWidget(wipeAt_);
}

void ComparisonPanes::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    placeCompanion();
    showTitles();
}

void ComparisonPanes::setCompanion(QWidget* companion) {
    delete companion_;
    auto* beside = new Beside(this);
    auto* row = new QHBoxLayout(beside);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    differenceBar()->setParent(beside);
    row->addWidget(differenceBar());
    companion_ = companion;
    besideDifference_ = row;
    row->addWidget(companion_, 1);
    if (auto* before = grid_->itemAtPosition(3, 1); before != nullptr)
        delete before->widget();
    // Both rows of images are equally high, whatever the companion would like.
    beside->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    grid_->addWidget(beside, 3, 1, 1, 2);
    placeCompanion();
}

void ComparisonPanes::placeCompanion() {
    constexpr int below = 4;
    const bool isNarrow = width() < narrow_px;
    if (isNarrow == (besideDifference_->indexOf(companion_) < 0))
        return;
    if (isNarrow) {
        besideDifference_->removeWidget(companion_);
        besideDifference_->addStretch(1);
        grid_->addWidget(companion_, below, 0, 1, grid_->columnCount());
    } else {
        grid_->removeWidget(companion_);
        delete besideDifference_->takeAt(besideDifference_->count() - 1);
        besideDifference_->addWidget(companion_, 1);
    }
    grid_->setRowStretch(below, isNarrow ? 1 : 0);
    // With the height of a row of its own the companion leaves bars no more than they need.
    const int bar_px = isNarrow ? std::max(sharedBar()->minimumSizeHint().height(),
                                           differenceBar()->minimumSizeHint().height())
                                : 0;
    for (const int row : {1, 3})
        grid_->setRowMinimumHeight(row, bar_px);
}

void ComparisonPanes::link(ImageCanvas* canvas) {
    const auto others = [this, canvas](auto&& use) {
        for (ImageCanvas* other : canvases_)
            if (other != canvas && other != nullptr)
                use(other);
    };
    connect(canvas, &ImageCanvas::viewChanged, this, [canvas, others] {
        others([&](ImageCanvas* other) { other->setView(canvas->view()); });
    });
    connect(canvas, &ImageCanvas::hovered, this, [this, others](std::optional<QPoint> pixel) {
        others([&](ImageCanvas* other) { other->setCursorPixel(pixel); });
        emit hovered(pixel);
    });
    connect(canvas, &ImageCanvas::selectionChanged, this, [this, canvas, others] {
        others([&](ImageCanvas* other) { other->setSelection(canvas->selection()); });
        emit selectionChanged();
    });
}

void ComparisonPanes::setPlanes(const ComparedPlane& a, const ComparedPlane& b,
                                const QString& title) {
    // Values of one image have one owner, whichever of its planes they are.
    const auto isOther = [](const SharedValues& x, const SharedValues& y) {
        return x.owner_before(y) || y.owner_before(x);
    };
    if (isOther(planes_[0].values, a.values))
        canvases_[0]->forgetPicture();
    if (isOther(planes_[1].values, b.values))
        canvases_[1]->forgetPicture();
    planes_ = {a, b};
    for (std::size_t i = 0; i < 2; ++i)
        if (planes_[i].values)
            canvases_[i]->setPlane(planes_[i].width, planes_[i].height, planes_[i].values);
        else
            canvases_[i]->clear();
    const bool same = a.values && b.values && a.width == b.width && a.height == b.height;
    if (same)
        canvases_[0]->setSecond(b.values);
    wipe_->setEnabled(same);
    if (!same)
        setWipe(false);
    showTitles();
    colors_->setPlanes({a.values, b.values}, title);
}

void ComparisonPanes::setDifference(SharedValues values, irsg::DifferenceMode mode,
                                    const QString& title) {
    hasDifference_ = values != nullptr;
    mode_ = mode;
    if (hasDifference_) {
        canvases_[2]->setPlane(planes_[0].width, planes_[0].height, values);
        canvases_[2]->setView(canvases_[0]->view());
        canvases_[2]->setSelection(canvases_[0]->selection());
    } else {
        canvases_[2]->clear();
    }
    colors_->setDifference(std::move(values), mode, title);
    showTitles();
}

void ComparisonPanes::setMarks(std::vector<std::uint8_t> marks) {
    if (hasDifference_)
        canvases_[2]->setMarks(std::move(marks));
}

bool ComparisonPanes::isBusy() const {
    return colors_->isBusy() ||
           std::any_of(canvases_.begin(), canvases_.end(),
                       [](const ImageCanvas* canvas) { return canvas->isBusy(); });
}

void ComparisonPanes::showTitles() {
    // Names that are too long lose their middle: numbers and endings tell files apart.
    const auto show = [this](std::size_t i, const QString& letter, const QString& name) {
        QLabel* label = titles_[i];
        QFont bold = label->font();
        bold.setBold(true);
        const int gap = 10;
        const int room = canvases_[i]->width() - QFontMetrics(bold).horizontalAdvance(letter) - gap;
        const QString shown = label->fontMetrics().elidedText(name, Qt::ElideMiddle, room);
        label->setText(
            QStringLiteral("<b>%1</b>&nbsp;&nbsp;%2").arg(letter, shown.toHtmlEscaped()));
        label->setToolTip(name);
    };
    const QString& a = planes_[0].name;
    const QString& b = planes_[1].name;
    show(0,
         flickering_  ? QStringLiteral("B")
         : isWiping() ? QStringLiteral("A | B")
                      : QStringLiteral("A"),
         flickering_  ? b
         : isWiping() ? a + " | " + b
                      : a);
    show(1, QStringLiteral("B"), b);
    show(2, tr("Difference"), hasDifference_ ? differenceName(mode_) : QString());
}

void ComparisonPanes::setFlicker(bool on) {
    canvases_[0]->setSecondShown(on);
    flickering_ = canvases_[0]->isSecondShown();
    showTitles();
}

bool ComparisonPanes::isWiping() const {
    return wipe_->isChecked();
}

void ComparisonPanes::setWipe(bool on) {
    const QSignalBlocker quiet(wipe_);
    wipe_->setChecked(on && wipe_->isEnabled());
    wipeAt_->setEnabled(wipe_->isChecked());
    if (wipe_->isChecked())
        canvases_[0]->setWipe(static_cast<double>(wipeAt_->value()) / wipeSteps);
    else
        canvases_[0]->setWipe(std::nullopt);
    showTitles();
}

void ComparisonPanes::fit() {
    canvases_[0]->fit();
}

void ComparisonPanes::showActualSize() {
    canvases_[0]->showActualSize();
}

void ComparisonPanes::goTo(const QPoint& pixel) {
    canvases_[2]->centreOn(pixel, closeZoom);
    for (ImageCanvas* canvas : canvases_)
        canvas->setCursorPixel(pixel);
    emit hovered(pixel);
}

ColorBar* ComparisonPanes::activeBar() const {
    return canvases_[2]->hasFocus() ? differenceBar() : sharedBar();
}

std::optional<irsg::PixelRectangle> ComparisonPanes::selection() const {
    return canvases_[0]->selection();
}

} // namespace smat::gui

#include "moc_ComparisonPanes.cpp"
