#include "gui/tools/DetectionPlot.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QSignalBlocker>
#include <QStackedLayout>

#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/plot/TablePanel.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/tables/SignatureTable.h"

namespace smat::gui {

DetectionPlot::DetectionPlot(Dialogs dialogs, QWidget* parent)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    pages_ = new QStackedLayout(this);
    // Not that of the widest page, which may be hidden.
    setMinimumWidth(240);
    rose_ = panelOf(true);
    PolarData empty;
    empty.title = tr("Detection range");
    empty.clockwise = true;
    rose_.panel->polar()->setData(std::move(empty));
    curves_ = panelOf(false);
}

DetectionPlot::Panel DetectionPlot::panelOf(bool isPolar) {
    Panel made;
    made.panel = new PlotPanel(isPolar ? PlotKind::polar : PlotKind::cartesian, dialogs_, this);
    made.quantity = new QComboBox(made.panel);
    made.quantity->setObjectName(isPolar ? "quantity" : "quantityOfCurves");
    made.quantity->setMinimumWidth(90);
    made.quantity->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    made.quantity->hide(); // until there is something to choose from
    made.quantity->setToolTip(tr("Quantity to plot"));
    made.panel->addInFront(made.quantity);
    connect(made.quantity, &QComboBox::activated, this, &DetectionPlot::draw);
    pages_->addWidget(made.panel);
    return made;
}

const PlotPanel& DetectionPlot::plot() const {
    return *(pages_->currentWidget() == curves_.panel ? curves_ : rose_).panel;
}

void DetectionPlot::setResult(std::shared_ptr<const AnalysisData> result) {
    result_ = std::move(result);
    delete table_;
    table_ = nullptr;
    const ResultTable& table = result_->table;
    if (SignatureTable::isOne(table)) {
        table_ = new TablePanel({result_, &table}, dialogs_, this);
        table_->setTitle(tr("Detection range"));
        table_->setConditions(QString::fromStdString(lineOf(conditionsOf(table))));
        pages_->setCurrentIndex(pages_->addWidget(table_));
        return;
    }
    const Panel& shown = !table.empty() && !isPolar(table) ? curves_ : rose_;
    pages_->setCurrentWidget(shown.panel);
    const QSignalBlocker quiet(shown.quantity);
    const QString kept = shown.quantity->currentData().toString();
    shown.quantity->clear();
    for (const std::string& key : plottableQuantities(table))
        shown.quantity->addItem(quantityTitle(table, key), QString::fromStdString(key));
    int at = shown.quantity->findData(kept);
    for (const char* usual : {"detection_range", "probability"})
        if (at < 0)
            at = shown.quantity->findData(QString(usual));
    shown.quantity->setCurrentIndex(std::max(at, 0));
    shown.quantity->show();
    draw();
}

void DetectionPlot::draw() {
    if (!result_ || table_ != nullptr)
        return;
    const bool isRose = pages_->currentWidget() == rose_.panel;
    const Panel& shown = isRose ? rose_ : curves_;
    const std::string quantity = shown.quantity->currentData().toString().toStdString();
    const std::vector<NamedResult> results{{tr("Detection range"), &result_->table}};
    if (isRose)
        shown.panel->polar()->setData(polarData(results, quantity));
    else
        shown.panel->cartesian()->setData(cartesianData(results, quantity));
    shown.panel->refresh();
}

QStringList DetectionPlot::exportFilters() const {
    if (!result_)
        return {};
    return {tr("Values as text (*.csv)"), tr("All inputs and values (*.json)"),
            tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void DetectionPlot::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (result_ && (suffix == ".csv" || suffix == ".json"))
        result_->table.save(file);
    else if (table_ != nullptr)
        table_->exportTo(file);
    else
        plot().exportTo(file);
}

} // namespace smat::gui

#include "moc_DetectionPlot.cpp"
