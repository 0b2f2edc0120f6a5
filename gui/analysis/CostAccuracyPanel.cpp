#include "gui/analysis/CostAccuracyPanel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCheckBox>
#include <QEvent>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QSplitter>
#include <QToolTip>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QwtPlotMarker>
#include <QwtSymbol>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Theme.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/CostAccuracyStudy.h"

namespace smat::gui {
namespace {

constexpr int rowRole = Qt::UserRole;
constexpr int wide_px = 900;

double cell(const ResultTable& table, const char* key, std::size_t row) {
    const ResultColumn* column = table.find(key);
    if (column == nullptr)
        throw irsg::InputError({"result", "header", std::string("no column ") + key,
                                "a result of smat-batch cost-accuracy"});
    return column->values.at(row);
}

QString atmosphereWords(const ResultTable& table, std::size_t row) {
    if (cell(table, "wideband", row) != 0.0)
        return CostAccuracyPanel::tr("wideband-ck");
    const double bins_per_cm = cell(table, "bins", row);
    return bins_per_cm > 0.0 ? CostAccuracyPanel::tr("bins of %1 cm⁻¹").arg(bins_per_cm)
                             : CostAccuracyPanel::tr("spectral");
}

QString lightWords(const ResultTable& table, std::size_t row) {
    switch (static_cast<int>(cell(table, "light", row))) {
    case CostAccuracyStudy::noLight:
        return CostAccuracyPanel::tr("no sun, sky and ground");
    case CostAccuracyStudy::sunAndSky:
        return CostAccuracyPanel::tr("no shadows, none between surfaces");
    case CostAccuracyStudy::withShadows:
        return CostAccuracyPanel::tr("none between surfaces");
    default:
        return CostAccuracyPanel::tr("all");
    }
}

QString rowsWords(const ResultTable& table, std::size_t row) {
    const double rows = cell(table, "background_rows", row);
    return rows == 0.0 ? CostAccuracyPanel::tr("as many as needed") : QString::number(rows);
}

/// "mode 4, bins of 5 cm⁻¹, background rows 1, light: all".
QString words(const ResultTable& table, std::size_t row) {
    return CostAccuracyPanel::tr("mode %1, %2, background rows: %3, light: %4")
        .arg(cell(table, "antialiasing", row))
        .arg(atmosphereWords(table, row), rowsWords(table, row), lightWords(table, row));
}

QString percent(double value) {
    return QString::number(value, 'g', 3) + " %";
}

QString milliseconds(double value) {
    return QString::number(value, 'g', 3) + " ms";
}

} // namespace

CostAccuracyPanel::CostAccuracyPanel(Dialogs dialogs, QWidget* parent) : QWidget(parent) {
    setObjectName("frontierPanel");
    parts_ = new QSplitter(Qt::Vertical, this);
    plot_ = new PlotPanel(PlotKind::cartesian, std::move(dialogs), parts_);
    plot_->cartesian()->sheet()->installEventFilter(this);

    auto* below = new QWidget(parts_);
    auto* column = new QVBoxLayout(below);
    column->setContentsMargins(10, 6, 10, 10);
    said_ = new QLabel(below);
    said_->setObjectName("frontierSaid");
    said_->setWordWrap(true);
    said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    configurations_ = new QTreeWidget(below);
    configurations_->setObjectName("frontierWays");
    configurations_->setHeaderLabels({tr("True error"), tr("Time"), tr("First time"),
                                      tr("Stated error"), tr("Antialiasing"), tr("Air"),
                                      tr("Background rows"), tr("Light")});
    configurations_->setRootIsDecorated(false);
    configurations_->setAlternatingRowColors(true);
    configurations_->setUniformRowHeights(true);
    configurations_->setMinimumHeight(90);
    configurations_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    auto* row = new QHBoxLayout;
    all_ = new QCheckBox(tr("&Also those off the front"), below);
    all_->setObjectName("frontierAll");
    use_ = new QPushButton(tr("&Use this configuration"), below);
    use_->setObjectName("useWay");
    use_->setToolTip(
        tr("Sets the project to the configuration that is marked, as one step that can "
           "be undone; a target error is taken off, which would choose another"));
    row->addWidget(all_, 1);
    row->addWidget(use_);
    column->addWidget(said_);
    column->addWidget(configurations_, 1);
    column->addLayout(row);
    parts_->setStretchFactor(0, 3);
    parts_->setStretchFactor(1, 2);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(parts_);

    connect(all_, &QCheckBox::toggled, this, &CostAccuracyPanel::fillConfigurations);
    connect(configurations_, &QTreeWidget::currentItemChanged, this, [this] { showMark(); });
    connect(use_, &QPushButton::clicked, this, &CostAccuracyPanel::askToUse);
    use_->setEnabled(false);
}

void CostAccuracyPanel::setTable(const ResultTable& table) {
    for (const char* key : {"true_error", "time", "first_time", "stated_error", "antialiasing",
                            "bins", "wideband", "background_rows", "light", "on_front", "chosen"})
        if (table.rowCount() > 0)
            (void)cell(table, key, 0);
    table_ = table;
    QStringList sentences;
    for (const auto& [key, value] : table_.provenance.entries)
        if (key == "answered by" &&
            (value.starts_with("target error") || value.starts_with("configurations: ") ||
             value.starts_with("ways: "))) // as earlier versions wrote it
            sentences << withFormattedUnits(QString::fromStdString(value));
        else if (key == "warning")
            sentences << tr("note: %1").arg(QString::fromStdString(value));
    said_->setText(sentences.join('\n'));
    said_->setVisible(!sentences.isEmpty());
    fillPlot();
    fillConfigurations();
}

void CostAccuracyPanel::fillPlot() {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    // A sample between gaps is drawn as a dot.
    Curve configurations{tr("a configuration"), {}, {}},
        front{tr("front: none is both quicker and more accurate"), {}, {}},
        chosen{tr("chosen"), {}, {}};
    for (std::size_t i = 0; i < table_.rowCount(); ++i) {
        const double error = cell(table_, "true_error", i), time = cell(table_, "time", i);
        if (cell(table_, "on_front", i) != 0.0) {
            front.x.push_back(error);
            front.y.push_back(time);
        }
        if (cell(table_, "chosen", i) != 0.0) {
            chosen.x.push_back(error);
            chosen.y.push_back(time);
        }
        for (const double y : {time, gap}) {
            configurations.x.push_back(error);
            configurations.y.push_back(y);
        }
    }
    PlotData data;
    data.title = tr("Time against error of one view");
    ResultTable only;
    only.provenance = table_.provenance;
    data.conditions = QString::fromStdString(lineOf(conditionsOf(only)));
    data.xTitle = tr("True error (%)");
    data.yTitle = tr("Time per case (ms)");
    data.xLogarithmic = data.yLogarithmic = true;
    if (table_.rowCount() > 0)
        data.curves = {front, configurations};
    if (!chosen.x.empty())
        data.curves.push_back(chosen);
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

void CostAccuracyPanel::fillConfigurations() {
    const auto before = marked();
    const QSignalBlocker quiet(configurations_);
    configurations_->clear();
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < table_.rowCount(); ++i) {
        const bool isOnFront = cell(table_, "on_front", i) != 0.0;
        const bool isChosen = cell(table_, "chosen", i) != 0.0;
        if (isChosen)
            chosen = i;
        if (!isOnFront && !isChosen && !all_->isChecked())
            continue;
        auto* item = new QTreeWidgetItem(configurations_);
        item->setData(0, rowRole, static_cast<qulonglong>(i));
        const QStringList texts{percent(cell(table_, "true_error", i)),
                                milliseconds(cell(table_, "time", i)),
                                milliseconds(cell(table_, "first_time", i)),
                                percent(cell(table_, "stated_error", i)),
                                tr("mode %1").arg(cell(table_, "antialiasing", i)),
                                atmosphereWords(table_, i),
                                rowsWords(table_, i),
                                lightWords(table_, i)};
        for (int k = 0; k < texts.size(); ++k) {
            item->setText(k, texts[k]);
            if (k < 4)
                item->setTextAlignment(k, Qt::AlignRight | Qt::AlignVCenter);
            if (isChosen) {
                QFont bold = configurations_->font();
                bold.setBold(true);
                item->setFont(k, bold);
            }
        }
        if (isChosen)
            item->setToolTip(0, tr("The quickest whose true error is at most the target"));
    }
    if (before)
        mark(*before);
    if (!marked() && chosen)
        mark(*chosen);
    showMark();
}

std::optional<std::size_t> CostAccuracyPanel::marked() const {
    const QTreeWidgetItem* item = configurations_->currentItem();
    return item == nullptr ? std::nullopt
                           : std::optional<std::size_t>(item->data(0, rowRole).toULongLong());
}

void CostAccuracyPanel::mark(std::size_t row) {
    for (int i = 0; i < configurations_->topLevelItemCount(); ++i)
        if (configurations_->topLevelItem(i)->data(0, rowRole).toULongLong() == row)
            return configurations_->setCurrentItem(configurations_->topLevelItem(i));
    if (row < table_.rowCount() && !all_->isChecked()) {
        all_->setChecked(true); // it is off the front
        mark(row);
    }
}

void CostAccuracyPanel::showMark() {
    CartesianPlot& plot = *plot_->cartesian();
    plot.detachItems(QwtPlotItem::Rtti_PlotMarker, true);
    const auto row = marked();
    use_->setEnabled(usable_ && row.has_value());
    if (row) {
        const PlotStyle style = PlotStyle::screen(palette());
        auto* ring = new QwtPlotMarker;
        ring->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, QBrush(Qt::NoBrush),
                                      QPen(style.text, 2.0), QSize(15, 15)));
        ring->setValue(cell(table_, "true_error", *row), cell(table_, "time", *row));
        ring->setZ(30.0);
        ring->attach(&plot);
    }
    plot.replot();
}

std::optional<std::size_t> CostAccuracyPanel::configurationNear(const QPointF& canvasPoint) const {
    constexpr double reach_px = 9.0;
    const CartesianPlot& plot = *plot_->cartesian();
    std::optional<std::size_t> nearest;
    double least = reach_px;
    for (std::size_t i = 0; i < table_.rowCount(); ++i) {
        const double x = plot.transform(QwtPlot::xBottom, cell(table_, "true_error", i));
        const double y = plot.transform(QwtPlot::yLeft, cell(table_, "time", i));
        const double distance = std::hypot(x - canvasPoint.x(), y - canvasPoint.y());
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

bool CostAccuracyPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        if (const auto row = configurationNear(help->pos()))
            QToolTip::showText(help->globalPos(),
                               words(table_, *row) + "\n" +
                                   tr("error %1, %2 per case")
                                       .arg(percent(cell(table_, "true_error", *row)),
                                            milliseconds(cell(table_, "time", *row))));
        else
            QToolTip::hideText();
        return true;
    }
    if (event->type() == QEvent::MouseButtonRelease)
        if (const auto row = configurationNear(static_cast<QMouseEvent*>(event)->position()))
            mark(*row);
    return QWidget::eventFilter(watched, event);
}

void CostAccuracyPanel::setUsable(bool usable) {
    usable_ = usable;
    showMark();
}

void CostAccuracyPanel::askToUse() {
    if (const auto row = marked())
        emit useAsked(
            CostAccuracyStudy::settingsOf(table_, *row),
            tr("Use the configuration of mode %1").arg(cell(table_, "antialiasing", *row)));
}

void CostAccuracyPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    // Beside each other where that leaves the plot wide enough.
    parts_->setOrientation(width() > 2 * wide_px ? Qt::Horizontal : Qt::Vertical);
}

void CostAccuracyPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && use_ != nullptr)
        showMark();
}

QStringList CostAccuracyPanel::exportFilters() const {
    if (table_.empty())
        return {};
    return {tr("Configurations as text (*.csv)"), tr("All inputs and values (*.json)"),
            tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void CostAccuracyPanel::exportTo(const std::filesystem::path& file) const {
    if (file.extension() == ".csv" || file.extension() == ".json")
        table_.save(file);
    else
        plot_->exportTo(file);
}

} // namespace smat::gui

#include "moc_CostAccuracyPanel.cpp"
