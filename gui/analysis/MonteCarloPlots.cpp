#include "gui/analysis/MonteCarloPlots.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPen>
#include <QSlider>
#include <QSplitter>
#include <QVBoxLayout>

#include <QwtIntervalSymbol>
#include <QwtPlotCanvas>
#include <QwtPlotGrid>
#include <QwtPlotHistogram>
#include <QwtPlotIntervalCurve>
#include <QwtPlotMarker>

#include "gui/analysis/RankingBars.h"
#include "gui/image/ImageExport.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PlotLook.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Quantity.h"
#include "smatcore/analysis/MonteCarloFile.h"
#include "smatcore/data/ColumnName.h"

namespace smat::gui {

namespace {

constexpr int narrow_px = 560;

/// "Contrast intensity (W·sr⁻¹)" of the quantity that was asked for.
QString quantityTitle(const MonteCarloData& data) {
    const ResultColumn column{data.analysis.table.provenance.value("quantity"), data.unit, {}};
    return QString::fromStdString(column.axisTitle());
}

/// What the histogram draws, in the unit of display where every draw has one in it.
struct HistogramValues {
    std::vector<double> values;
    double nominal = 0.0, mean = 0.0;
    QString title;
};

HistogramValues shownValues(const MonteCarloData& data, std::size_t place) {
    HistogramValues drawn{data.values[place], data.nominal[place], meanOf(data.values[place]),
                          quantityTitle(data)};
    const ShownUnit* unit = shownUnitOf(data.unit);
    if (unit == nullptr)
        return drawn;
    HistogramValues other{drawn.values, unit->shown(drawn.nominal), unit->shown(drawn.mean),
                          unit->titleOf(drawn.title)};
    std::ranges::transform(other.values, other.values.begin(), unit->shown);
    const auto isFinite = [](double value) { return std::isfinite(value); };
    return isFinite(other.nominal) && isFinite(other.mean) &&
                   std::ranges::all_of(other.values, isFinite)
               ? other
               : drawn;
}

QString abscissaTitle(const MonteCarloData& data) {
    const ResultColumn column{data.abscissaKey, data.abscissaUnit, {}};
    return QString::fromStdString(column.axisTitle());
}

/// A cell of the table by its column, in the order of the abscissae.
std::vector<double> columnOf(const MonteCarloData& data, const std::string& key) {
    const ResultColumn* found = data.analysis.table.find(key);
    return found == nullptr ? std::vector<double>{} : found->values;
}

/// "3-5 µm" of one of several bands, else nothing.
QString bandText(const MonteCarloData& data, std::size_t band) {
    return withFormattedUnits(
        QString::fromStdString(ColumnName{"", "", "", data.bands.at(band)}.which()));
}

/// The part of the plot between two curves.
QwtPlotIntervalCurve* bandBetween(const Curve& low, const Curve& high, const QString& title,
                                  QColor color, int alpha) {
    QVector<QwtIntervalSample> samples;
    for (std::size_t i = 0; i < low.x.size(); ++i)
        if (std::isfinite(low.y[i]) && std::isfinite(high.y[i]))
            samples.append(QwtIntervalSample(low.x[i], low.y[i], high.y[i]));
    auto* band = new QwtPlotIntervalCurve(title);
    band->setSamples(samples);
    band->setStyle(QwtPlotIntervalCurve::Tube);
    band->setPen(QPen(Qt::NoPen));
    color.setAlpha(alpha);
    band->setBrush(color);
    band->setZ(5.0);
    band->setItemAttribute(QwtPlotItem::Legend, false); // the lines at its edges are named
    return band;
}

} // namespace

MonteCarloPlots::MonteCarloPlots(QWidget* parent) : QWidget(parent) {
    setObjectName("monteCarloPlots");
    columns_ = new QSplitter(Qt::Vertical, this);
    below_ = new QSplitter(Qt::Horizontal, columns_);
    histogramPart_ = new QWidget(below_);
    histogramPart_->setAutoFillBackground(true);
    auto* histogramColumn = new QVBoxLayout(histogramPart_);
    histogramColumn->setContentsMargins(8, 0, 8, 8);
    auto* placeRow = new QHBoxLayout;
    place_ = new QSlider(Qt::Horizontal, histogramPart_);
    place_->setObjectName("histogramPlace");
    place_->setToolTip(tr("Where in the sweep the histogram is taken"));
    placeText_ = new QLabel(histogramPart_);
    placeText_->setObjectName("histogramPlaceText");
    placeText_->setMinimumWidth(80);
    placeRow->addWidget(place_, 1);
    placeRow->addWidget(placeText_);
    histogramColumn->addLayout(placeRow);
    ranking_ = new RankingBars(below_);
    empty_ = new QLabel(tr("Run shows the bands of the percentiles, a histogram and the scales "
                           "that matter most here."),
                        this);
    empty_->setObjectName("nothingYet");
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(24);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(empty_);
    all->addWidget(columns_);
    columns_->hide();
    const auto draw = [this] {
        drawBands();
        drawHistogram();
    };
    connect(place_, &QSlider::valueChanged, this, draw);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this, draw);
    makePlots();
}

void MonteCarloPlots::makePlots() {
    const PlotStyle style = PlotStyle::screen(palette());
    delete bands_;
    bands_ = new CartesianPlot(style, this);
    bands_->setObjectName("monteCarloBands");
    bands_->setMinimumSize(240, 200);
    columns_->insertWidget(0, bands_);
    columns_->setStretchFactor(0, 3);
    columns_->setStretchFactor(1, 2);
    delete histogram_;
    histogram_ = new QwtPlot(histogramPart_);
    histogram_->setObjectName("monteCarloHistogram");
    histogram_->setMinimumSize(150, 130);
    auto* canvas = new QwtPlotCanvas(histogram_);
    canvas->setFrameStyle(QFrame::NoFrame);
    histogram_->setCanvas(canvas);
    histogram_->setCanvasBackground(style.canvas);
    dressPlot(*histogram_, style);
    static_cast<QVBoxLayout*>(histogramPart_->layout())->insertWidget(0, histogram_, 1);
    QPalette sheet = histogramPart_->palette();
    sheet.setColor(QPalette::Window, style.background);
    histogramPart_->setPalette(sheet);
    drawBands();
    drawHistogram();
    drawRanking();
}

void MonteCarloPlots::setData(const MonteCarloData& data) {
    data_ = data;
    empty_->setVisible(data_.values.empty());
    columns_->setVisible(!data_.values.empty());
    const bool hasPlaces = !data_.abscissae.empty();
    {
        const QSignalBlocker quiet(place_);
        place_->setRange(0, std::max(static_cast<int>(data_.values.size()) - 1, 0));
        // Where the spread is largest.
        std::size_t widest = 0;
        double most = -1.0;
        for (std::size_t k = 0; k < data_.values.size(); ++k)
            if (const double sigma = standardDeviationOf(data_.values[k]); sigma > most) {
                most = sigma;
                widest = k;
            }
        place_->setValue(static_cast<int>(widest));
    }
    place_->setEnabled(hasPlaces && data_.values.size() > 1);
    drawBands();
    drawHistogram();
    drawRanking();
}

void MonteCarloPlots::drawBands() {
    bands_->detachItems(QwtPlotItem::Rtti_PlotIntervalCurve, true);
    bands_->detachItems(QwtPlotItem::Rtti_PlotMarker, true);
    PlotData plot;
    plot.title = tr("Spread from uncertain inputs");
    if (data_.abscissae.empty()) {
        bands_->setData(plot);
        return;
    }
    plot.xTitle = abscissaTitle(data_);
    plot.yTitle = quantityTitle(data_);
    plot.xUnit = data_.abscissaUnit;
    plot.yUnit = data_.unit;
    // Along the abscissa at the place of the slider on the other axes.
    const std::size_t chosen = static_cast<std::size_t>(place_->value()) % data_.abscissae.size();
    const std::vector<std::size_t> rows = data_.rowsAlong(chosen);
    const auto along = [&](const std::vector<double>& all) {
        std::vector<double> some;
        for (const std::size_t row : rows)
            if (row < all.size())
                some.push_back(all[row]);
        return some;
    };
    const std::vector<double> x = along(data_.abscissae);
    // The outermost percentiles as lines, so that the axis holds them and a crosshair reads them.
    std::vector<std::string> keys;
    for (const double percent : data_.options.percentiles)
        keys.push_back("p" + irsg::numberText(percent));
    const std::size_t bands = data_.bands.size();
    const auto called = [&](const QString& what, std::size_t band) {
        const QString label = bandText(data_, band);
        return label.isEmpty() ? what : what + ", " + label;
    };
    for (std::size_t band = 0; band < bands; ++band) {
        plot.curves.push_back(
            {called(tr("nominal"), band), x, along(data_.ofBand(data_.nominal, band))});
        plot.curves.push_back(
            {called(tr("mean"), band), x, along(columnOf(data_, data_.columnKey("mean", band)))});
        for (const std::string& key : keys)
            plot.curves.push_back({called(QString::fromStdString(key), band), x,
                                   along(columnOf(data_, data_.columnKey(key, band)))});
    }
    bands_->setData(std::move(plot));

    const PlotStyle style = PlotStyle::screen(palette());
    const int pairs = static_cast<int>(keys.size() / 2);
    const std::size_t ofBand = keys.size() + 2;
    // In the units that the plot shows.
    const auto curve = [&](std::size_t band, std::size_t key) -> const Curve& {
        return bands_->data().curves[band * ofBand + 2 + key];
    };
    for (std::size_t band = 0; band < bands; ++band)
        for (int i = 0; i < pairs; ++i) {
            const auto low = static_cast<std::size_t>(i), high = keys.size() - 1 - low;
            bandBetween(curve(band, low), curve(band, high),
                        called(QString::fromStdString(keys[low] + " – " + keys[high]), band),
                        style.curve(1 + static_cast<int>(band)),
                        40 + 120 * (i + 1) / std::max(pairs, 1) / 2)
                ->attach(bands_);
        }
    auto* here = new QwtPlotMarker;
    here->setLineStyle(QwtPlotMarker::VLine);
    here->setLinePen(style.faintText, 1.0, Qt::DashLine);
    const double at = data_.abscissae[chosen];
    const ShownUnit* unit = shownUnitOf(data_.abscissaUnit);
    here->setXValue(unit == nullptr ? at : unit->shown(at));
    here->attach(bands_);
    bands_->replot();
}

void MonteCarloPlots::drawHistogram() {
    histogram_->detachItems(QwtPlotItem::Rtti_PlotItem, true);
    const PlotStyle style = PlotStyle::screen(palette());
    histogram_->setTitle(plotTitle(tr("Histogram"), {}, style));
    histogram_->setAxisTitle(QwtPlot::yLeft, axisText(tr("Draws"), style));
    if (data_.values.empty()) {
        placeText_->clear();
        histogram_->replot();
        return;
    }
    const auto k = static_cast<std::size_t>(place_->value());
    const std::size_t count = data_.abscissae.size();
    const QString band = bandText(data_, k / count);
    QString place = valueWithUnit(data_.abscissae[k % count], data_.abscissaUnit);
    for (const ResultColumn& axis : data_.otherAxes)
        place += ", " + QString::fromStdString(axis.key) + " " +
                 valueWithUnit(axis.values.at(k % count), axis.unit);
    placeText_->setText(place + (band.isEmpty() ? "" : ", " + band));
    const HistogramValues drawn = shownValues(data_, k);
    histogram_->setAxisTitle(QwtPlot::xBottom, axisText(drawn.title, style));
    auto* grid = new QwtPlotGrid;
    grid->setMajorPen(style.grid, 1.0);
    grid->enableX(false);
    grid->attach(histogram_);

    const SampleHistogram counted = histogramOf(drawn.values);
    QVector<QwtIntervalSample> samples;
    double most = 1.0;
    for (std::size_t bin = 0; bin < counted.counts.size(); ++bin) {
        const double count = static_cast<double>(counted.counts[bin]);
        const double from = counted.least + static_cast<double>(bin) * counted.width;
        samples.append(QwtIntervalSample(count, from, from + counted.width));
        most = std::max(most, count);
    }
    auto* bars = new QwtPlotHistogram;
    bars->setStyle(QwtPlotHistogram::Columns);
    QColor fill = style.curve(0);
    bars->setPen(fill.darker(120), 1.0);
    fill.setAlpha(150);
    bars->setBrush(fill);
    bars->setSamples(samples);
    bars->attach(histogram_);
    const double low = std::min(counted.least, drawn.nominal);
    const double high = std::max(
        counted.least + counted.width * static_cast<double>(counted.counts.size()), drawn.nominal);
    const double pad = high > low ? 0.03 * (high - low) : std::max(std::abs(high), 1.0) * 0.1;
    histogram_->setAxisScale(QwtPlot::xBottom, low - pad, high + pad);
    histogram_->setAxisScale(QwtPlot::yLeft, 0.0, 1.12 * most);

    const auto mark = [&](double at, const QString& text, const QColor& color, Qt::Alignment side) {
        auto* line = new QwtPlotMarker;
        line->setLineStyle(QwtPlotMarker::VLine);
        line->setLinePen(color, 1.6);
        QwtText label(text);
        label.setColor(color);
        label.setFont(plotFont(0.9));
        line->setLabel(label);
        line->setLabelAlignment(side | Qt::AlignTop);
        line->setXValue(at);
        line->attach(histogram_);
    };
    const bool meanIsRight = drawn.mean >= drawn.nominal;
    mark(drawn.nominal, tr("nominal"), style.text, meanIsRight ? Qt::AlignLeft : Qt::AlignRight);
    mark(drawn.mean, tr("mean"), style.curve(1), meanIsRight ? Qt::AlignRight : Qt::AlignLeft);
    histogram_->replot();
}

void MonteCarloPlots::drawRanking() {
    std::vector<RankingBar> bars;
    for (const RankedScaling& one : data_.ranking)
        bars.push_back(
            {QString::fromStdString(data_.scalings[one.scaling].name), one.firstOrder, one.total});
    ranking_->setHint(tr("Run the ranking to see which inputs matter."));
    ranking_->setBars(std::move(bars));
}

void MonteCarloPlots::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Too narrow for both beside each other, they stand one below the other.
    below_->setOrientation(width() < narrow_px ? Qt::Vertical : Qt::Horizontal);
}

void MonteCarloPlots::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    // Later: Qt still goes through the widgets that are there, and new plots take their place.
    if (event->type() == QEvent::PaletteChange && bands_ != nullptr)
        QMetaObject::invokeMethod(
            this, [this] { makePlots(); }, Qt::QueuedConnection);
}

QStringList MonteCarloPlots::exportFilters() const {
    if (data_.values.empty())
        return {};
    return {tr("Bands as text, with the ranking beside them (*.csv)"),
            tr("All inputs and values (*.json)"),
            tr("Raw draws as text (*.draws.csv)"),
            tr("Raw draws (*.draws.json)"),
            tr("Bands as a scalable picture (*.svg)"),
            tr("Bands as PDF (*.pdf)"),
            tr("Picture of all plots (*.png)")};
}

void MonteCarloPlots::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (file.stem().extension() == ".draws" && (suffix == ".csv" || suffix == ".json"))
        return realisationsTable(data_).save(file);
    if (suffix == ".svg" || suffix == ".pdf")
        exportPlot(*bands_, file);
    else if (suffix == ".png")
        writePicture(columns_->grab().toImage(), file);
    else
        saveMonteCarlo(data_, file);
}

} // namespace smat::gui

#include "moc_MonteCarloPlots.cpp"
