#include "gui/image/ComparisonPanes.h"

#include <algorithm>
#include <cmath>

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

/// Limits at equal distances from 1, for a ratio.
irsg::DisplayLimits aroundOne(const std::vector<float>& values, double percent) {
    std::vector<float> distances;
    distances.reserve(values.size());
    for (const float value : values)
        if (std::isfinite(value))
            distances.push_back(value - 1.0F);
    const irsg::DisplayLimits limits = irsg::symmetricLimits(distances, percent);
    return {1.0 + limits.low, 1.0 + limits.high};
}

irsg::DisplayLimits differenceLimits(const std::vector<float>& values, irsg::DifferenceMode mode,
                                     double percent) {
    switch (mode) {
    case irsg::DifferenceMode::absolute:
        return {0.0, irsg::symmetricLimits(values, percent).high};
    case irsg::DifferenceMode::ratio:
        return aroundOne(values, percent);
    default:
        return irsg::symmetricLimits(values, percent);
    }
}

constexpr double usualPercent = 99.5; ///< of the differences have colours of the map
constexpr int leastCompanionWidth_px = 150;

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
    map_ = &irsg::ColorMap::named(irsg::ColorMap::defaultName);
    shared_ = new ColorBar(this);
    shared_->setObjectName("sharedBar");
    shared_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
    // A few pixels at edges differ by much; the rest shows only where they do not set the limits.
    difference_ = new ColorBar(this, {LimitMode::percentile, LimitMode::full, LimitMode::locked});
    difference_->setObjectName("differenceBar");
    difference_->setPercentiles(0.0, usualPercent);
    difference_->askUpperPercentileAlone();
    difference_->hideScale();
    static const char* const names[] = {"canvasA", "canvasB", "canvasDifference"};
    for (std::size_t i = 0; i < canvases_.size(); ++i) {
        canvases_[i] = new ImageCanvas(this);
        canvases_[i]->setObjectName(names[i]);
        canvases_[i]->setMinimumSize(160, 120);
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
    grid_->addWidget(shared_, 1, 2);
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
    connect(shared_, &ColorBar::limitsEdited, this, &ComparisonPanes::updateSharedColors);
    connect(shared_, &ColorBar::modeChosen, this, &ComparisonPanes::updateSharedColors);
    connect(shared_, &ColorBar::scaleChosen, this, &ComparisonPanes::updateSharedColors);
    connect(shared_, &ColorBar::marksChosen, this, &ComparisonPanes::updateSharedColors);
    connect(difference_, &ColorBar::marksChosen, this, &ComparisonPanes::updateDifferenceColors);
    connect(difference_, &ColorBar::limitsEdited, this, &ComparisonPanes::updateDifferenceColors);
    connect(difference_, &ColorBar::modeChosen, this, &ComparisonPanes::updateDifferenceColors);
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
    showTitles();
}

void ComparisonPanes::setCompanion(QWidget* companion) {
    auto* beside = new Beside(this);
    auto* row = new QHBoxLayout(beside);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    difference_->setParent(beside);
    row->addWidget(difference_);
    row->addWidget(companion, 1);
    if (auto* before = grid_->itemAtPosition(3, 1); before != nullptr)
        delete before->widget();
    // Both rows of images are equally high, whatever the companion would like.
    beside->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Ignored);
    grid_->addWidget(beside, 3, 1, 1, 2);
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
    shared_->setTitle(title);
    showTitles();
    updateSharedColors();
}

void ComparisonPanes::setDifference(SharedValues values, irsg::DifferenceMode mode,
                                    const QString& title) {
    differenceValues_ = std::move(values);
    if (mode != mode_ && difference_->mode() == LimitMode::locked)
        difference_->setMode(LimitMode::percentile); // limits of another quantity
    mode_ = mode;
    difference_->setTitle(title);
    if (!differenceValues_) {
        differenceTask_.cancel();
        canvases_[2]->clear();
    } else {
        canvases_[2]->setPlane(planes_[0].width, planes_[0].height, differenceValues_);
        canvases_[2]->setView(canvases_[0]->view());
        canvases_[2]->setSelection(canvases_[0]->selection());
        updateDifferenceColors();
    }
    showTitles();
}

void ComparisonPanes::setMarks(std::vector<std::uint8_t> marks) {
    if (differenceValues_)
        canvases_[2]->setMarks(std::move(marks));
}

void ComparisonPanes::setColorMap(const std::string& name) {
    map_ = &irsg::ColorMap::named(name);
    shared_->setColors(*map_, shared_->limits());
    for (const int i : {0, 1})
        canvas(i)->setColors(*map_, shared_->limits());
    updateDifferenceColors();
}

bool ComparisonPanes::isBusy() const {
    return sharedTask_.isBusy() || differenceTask_.isBusy() ||
           std::any_of(canvases_.begin(), canvases_.end(),
                       [](const ImageCanvas* canvas) { return canvas->isBusy(); });
}

void ComparisonPanes::find(LatestTask& task, const std::vector<ImageCanvas*>& waiting,
                           std::size_t pixels, const std::function<FoundLimits()>& work,
                           const std::function<void(FoundLimits)>& use) {
    task.cancel();
    if (pixels <= quickPixels) {
        use(work());
        return;
    }
    for (ImageCanvas* canvas : waiting)
        canvas->awaitColors();
    task.run<FoundLimits>(work, use);
}

void ComparisonPanes::updateSharedColors() {
    std::vector<SharedValues> planes;
    std::vector<ImageCanvas*> waiting;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        if (!planes_[i].values)
            continue;
        planes.push_back(planes_[i].values);
        waiting.push_back(canvases_[i]);
        pixels = std::max(pixels, planes_[i].values->size());
    }
    std::optional<irsg::DisplayLimits> known;
    if (shared_->mode() == LimitMode::locked)
        known = shared_->limits();
    find(
        sharedTask_, waiting, pixels,
        [planes, known, rule = shared_->rule()] { return findLimits(rule, planes, known); },
        [this](const FoundLimits& found) { useShared(found); });
}

void ComparisonPanes::useShared(const FoundLimits& found) {
    shared_->setColors(*map_, found.limits);
    shared_->setOutOfRange(found.outside);
    for (const int i : {0, 1})
        canvas(i)->setColors(*map_, found.limits);
}

void ComparisonPanes::updateDifferenceColors() {
    if (!differenceValues_)
        return;
    std::optional<irsg::DisplayLimits> known;
    if (difference_->mode() == LimitMode::locked)
        known = difference_->limits();
    const double percent =
        difference_->mode() == LimitMode::percentile ? difference_->percentiles().second : 100.0;
    find(
        differenceTask_, {canvases_[2]}, differenceValues_->size(),
        [values = differenceValues_, mode = mode_, known, percent,
         marks = difference_->marksOutside()] {
            irsg::DisplayLimits limits = known ? *known : differenceLimits(*values, mode, percent);
            limits.scale = irsg::ColorScale::linear;
            limits.marksOutside = marks;
            return FoundLimits{limits, countOutOfRange(*values, limits)};
        },
        [this](const FoundLimits& found) { useDifference(found); });
}

void ComparisonPanes::useDifference(const FoundLimits& found) {
    // What has a sign diverges from its middle; a size does not.
    const irsg::ColorMap& map =
        mode_ == irsg::DifferenceMode::absolute ? *map_ : irsg::ColorMap::named("diverging");
    difference_->setColors(map, found.limits);
    difference_->setOutOfRange(found.outside);
    canvases_[2]->setColors(map, found.limits);
    emit differenceLimitsFound(found.limits);
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
    show(2, tr("Difference"), differenceValues_ ? differenceName(mode_) : QString());
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
    return canvases_[2]->hasFocus() ? difference_ : shared_;
}

std::optional<irsg::PixelRectangle> ComparisonPanes::selection() const {
    return canvases_[0]->selection();
}

} // namespace smat::gui
