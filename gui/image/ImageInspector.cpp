#include "gui/image/ImageInspector.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "gui/image/FiguresTable.h"
#include "gui/image/HistogramPlot.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "irsg/image/ImageIntensity.h"

namespace smat::gui {
namespace {

constexpr int bins = 256, contrastRow = 6;

QString where(double value, int x, int y) {
    return x < 0 ? formattedNumber(value)
                 : QStringLiteral("%1  (%2, %3)").arg(formattedNumber(value)).arg(x).arg(y);
}

/// The column of one set of figures.
QStringList column(const PlaneFigures& figures) {
    const auto& s = figures.statistics;
    return {where(s.minimum, s.minimumX, s.minimumY),
            where(s.maximum, s.maximumX, s.maximumY),
            formattedNumber(s.mean),
            formattedNumber(s.median),
            formattedNumber(s.standardDeviation),
            formattedNumber(s.sum),
            figures.contrastIntensity_W_sr
                ? valueWithUnit(*figures.contrastIntensity_W_sr, "W sr-1")
                : QStringLiteral("–"),
            QString::number(s.finite),
            QString::number(s.nan),
            QString::number(s.positiveInfinite + s.negativeInfinite)};
}

QString withUnit(const QString& word, const QString& unit) {
    return unit.isEmpty() ? word : word + " (" + unit + ")";
}

} // namespace

PlaneFigures figuresOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                       const std::optional<irsg::PixelRectangle>& rectangle) {
    return {irsg::imageStatistics(image, plane, rectangle),
            irsg::contrastIntensity_W_sr(image, plane, rectangle)};
}

ImageInspector::ImageInspector(QWidget* parent) : QWidget(parent) {
    setObjectName("imageInspector");
    histogram_ = new HistogramPlot(this);
    table_ = new FiguresTable(this);
    table_->setObjectName("imageFigures");
    histogram_->setMinimumSize(120, 100); // low pages have room for what a pixel is made of, too
    scope_ = new QLabel(this);
    scope_->setObjectName("histogramScope");
    scope_->setWordWrap(true);
    logarithmicCounts_ = new QCheckBox(tr("log pixels"), this);
    logarithmicCounts_->setObjectName("logCounts");
    logarithmicCounts_->setChecked(true);
    logarithmicValues_ = new QCheckBox(tr("log values"), this);
    logarithmicValues_->setObjectName("logValues");

    auto* bar = new QHBoxLayout;
    bar->addWidget(scope_, 1);
    bar->addWidget(logarithmicCounts_);
    bar->addSpacing(8);
    bar->addWidget(logarithmicValues_);
    auto* left = new QVBoxLayout;
    left->setSpacing(4);
    left->addLayout(bar);
    left->addWidget(histogram_, 1);
    row_ = new QHBoxLayout(this);
    row_->setContentsMargins(0, 4, 0, 0);
    row_->setSpacing(12);
    row_->addLayout(left, 3);
    row_->addWidget(table_, 2);
    setTableBelow(false);

    connect(logarithmicCounts_, &QCheckBox::toggled, histogram_,
            &HistogramPlot::setLogarithmicCounts);
    connect(logarithmicValues_, &QCheckBox::toggled, this, &ImageInspector::refresh);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            &ImageInspector::refresh);
}

void ImageInspector::show(std::shared_ptr<const irsg::RadianceImage> image,
                          const irsg::ImageChannel& plane, const QString& title,
                          const QString& unit) {
    image_ = std::move(image);
    plane_ = &plane;
    title_ = title;
    unit_ = unit;
    ofImage_.reset();
    rectangle_.reset();
    refresh();
}

void ImageInspector::setRectangle(const std::optional<irsg::PixelRectangle>& rectangle) {
    rectangle_ = rectangle;
    refresh();
}

void ImageInspector::setTableBelow(bool below) {
    row_->setDirection(below ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    // Beside the histogram, names and values are to be read whole.
    table_->setMinimumWidth(below ? 0 : 24 * fontMetrics().averageCharWidth());
}

void ImageInspector::clear() {
    task_.cancel();
    image_.reset();
    plane_ = nullptr;
    ofImage_.reset();
    rectangle_.reset();
    scope_->clear();
    histogram_->setHistogram({}, {});
    table_->setFigures({}, {});
}

void ImageInspector::setLimits(const irsg::DisplayLimits& limits) {
    histogram_->setLimits(limits);
}

void ImageInspector::showEvent(QShowEvent*) {
    if (stale_)
        refresh();
}

void ImageInspector::refresh() {
    // Nothing is worked out for nobody to see.
    stale_ = !isVisible();
    if (stale_ || plane_ == nullptr)
        return;
    const bool logarithmic = logarithmicValues_->isChecked();
    task_.run<Answer>(
        [image = image_, plane = plane_, known = ofImage_, rectangle = rectangle_, logarithmic] {
            Answer answer;
            answer.image = known ? *known : figuresOf(*image, *plane, std::nullopt);
            if (rectangle)
                answer.rectangle = figuresOf(*image, *plane, rectangle);
            answer.histogram = irsg::imageHistogram(*image, *plane, bins, logarithmic, rectangle);
            return answer;
        },
        [this](const Answer& answer) { fill(answer); });
}

void ImageInspector::fill(const Answer& answer) {
    ofImage_ = answer.image;
    histogram_->setHistogram(answer.histogram, title_);
    scope_->setText(rectangle_ ? tr("Histogram of the rectangle") : tr("Histogram of the image"));

    QStringList headings{withUnit(tr("Statistic"), unit_), tr("Image")};
    const QStringList names{tr("Minimum"),
                            tr("Maximum"),
                            tr("Mean"),
                            tr("Median"),
                            tr("Standard deviation"),
                            tr("Sum"),
                            tr("Contrast intensity"),
                            tr("Finite pixels"),
                            tr("NaN"),
                            tr("Infinite")};
    const QStringList ofImage = column(answer.image);
    const QStringList ofRectangle = answer.rectangle ? column(*answer.rectangle) : QStringList();
    if (answer.rectangle)
        headings << tr("Rectangle");
    QList<QStringList> rows;
    for (int i = 0; i < names.size(); ++i) {
        if (i == contrastRow && !answer.image.contrastIntensity_W_sr)
            continue;
        rows << QStringList{names[i], ofImage[i]};
        if (answer.rectangle)
            rows.back() << ofRectangle[i];
    }
    table_->setFigures(headings, rows);
}

} // namespace smat::gui

#include "moc_ImageInspector.cpp"
