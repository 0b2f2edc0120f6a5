#include "gui/analysis/ResultPage.h"

#include <algorithm>
#include <optional>

#include <QCheckBox>
#include <QComboBox>
#include <QVBoxLayout>

#include "gui/analysis/CostAccuracyPanel.h"
#include "gui/analysis/MonteCarloPlots.h"
#include "gui/image/ColorBar.h"
#include "gui/image/ImageExport.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/plot/TablePanel.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/workbench/ModelStore.h"
#include "irsg/core/Errors.h"
#include "irsg/image/PngView.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/analysis/CostAccuracyStudy.h"
#include "smatcore/analysis/PartColumns.h"
#include "smatcore/analysis/PixelExplainer.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/tables/TableFormats.h"

namespace smat::gui {
namespace {

std::vector<NamedResult> named(const std::vector<ResultEntry>& results) {
    std::vector<const AnalysisData*> data;
    for (const auto& entry : results)
        data.push_back(entry.data.get());
    const std::vector<std::string> telling = distinguishingNames(data);
    // What somebody called it says more than what differs, and that more than "2  Polar plot".
    const auto isUsual = [](const ResultEntry& entry) {
        return entry.title.endsWith("  " + QString::fromStdString(smat::title(entry.data->kind)));
    };
    std::vector<NamedResult> list;
    for (std::size_t i = 0; i < results.size(); ++i) {
        const bool tells = !telling[i].empty() && isUsual(results[i]);
        list.push_back(
            {tells ? withFormattedUnits(QString::fromStdString(telling[i])) : results[i].title,
             &results[i].data->table, results.size() == 1});
    }
    return list;
}

/// That of the sensor, or what an image file says of it: "3-5 (3 to 5 um)". None where neither is
/// a band that can be used.
std::optional<irsg::Band> bandOf(const ResultEntry& entry) {
    try {
        if (entry.canRunAgain())
            return sensorOf(entry.data->project, entry.data->settings).band;
        const std::string said = entry.data->table.provenance.value("band");
        const QString text = QString::fromStdString(said.substr(0, said.find(' ')));
        if (!text.isEmpty())
            return irsg::Band::fromText(text.toStdString());
    } catch (const irsg::InputError&) {
        // Apparent temperatures are then not offered.
    }
    return std::nullopt;
}

} // namespace

ResultPage::ResultPage(const std::vector<ResultEntry>& results, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), results_(results) {
    if (results_.empty())
        throw irsg::LogicError("a result page needs a result");
    setObjectName("resultPage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    for (const auto& entry : results_)
        ids_ << entry.id;
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    if (results_.front().monteCarlo && results_.size() == 1)
        showMonteCarlo();
    else if (results_.front().isImage())
        showImage(std::move(dialogs));
    else if (results_.size() == 1 && SignatureTable::isOne(results_.front().data->table))
        showTable(std::move(dialogs));
    else if (results_.size() == 1 && results_.front().data->kind == CostAccuracyStudy::kind())
        showCostAccuracy(std::move(dialogs));
    else
        showPlot(std::move(dialogs));
}

void ResultPage::showImage(Dialogs dialogs) {
    const ResultEntry& entry = results_.front();
    image_ = new ImageView(this, std::move(dialogs));
    image_->setImage(entry.image(), bandOf(entry));
    image_->setTitle(entry.title);
    image_->setConditions(QString::fromStdString(lineOf(conditionsOf(entry.data->table))));
    image_->setColorMap(entry.data->settings.text(key::displayColorMap));
    const Settings& settings = entry.data->settings;
    image_->setColorScale(irsg::colorScaleNamed(settings.text(key::displayScale)),
                          settings[key::displayMarkOutside]);
    image_->setLimits(settings[key::displayMinimum], settings[key::displayMaximum]);
    layout()->addWidget(image_);
    setBackgroundRole(QPalette::Window); // so that fields stand out in the dark, too
}

void ResultPage::setModels(const std::shared_ptr<ModelStore>& models) {
    const ResultEntry& entry = results_.front();
    if (image_ == nullptr || !entry.canRunAgain())
        return;
    image_->setExplainer([data = entry.data, models]() -> PixelPanel::Work {
        return [data, models] {
            AnalysisData asked = *data;
            asked.image = {};
            return std::make_shared<PixelExplainer>(std::move(asked), ModelStore::loader(models));
        };
    });
}

void ResultPage::showMonteCarlo() {
    draws_ = new MonteCarloPlots(this);
    draws_->setData(*results_.front().monteCarlo);
    layout()->addWidget(draws_);
}

void ResultPage::showTable(Dialogs dialogs) {
    const ResultEntry& entry = results_.front();
    tables_ = new TablePanel({entry.data, &entry.data->table}, std::move(dialogs), this);
    tables_->setTitle(entry.title);
    tables_->setConditions(QString::fromStdString(lineOf(conditionsOf(entry.data->table))));
    layout()->addWidget(tables_);
    setBackgroundRole(QPalette::Window);
}

void ResultPage::showCostAccuracy(Dialogs dialogs) {
    costAccuracy_ = new CostAccuracyPanel(std::move(dialogs), this);
    costAccuracy_->setTable(results_.front().data->table);
    layout()->addWidget(costAccuracy_);
    setBackgroundRole(QPalette::Window);
}

void ResultPage::showPlot(Dialogs dialogs) {
    const ResultTable& table = results_.front().data->table;
    quantity_ = new QComboBox(this);
    quantity_->setObjectName("quantity");
    quantity_->setMinimumWidth(90); // long titles give way where the page is narrow
    quantity_->setToolTip(tr("Quantity to plot"));
    for (const auto& key : plottableQuantities(table))
        quantity_->addItem(quantityTitle(table, key), QString::fromStdString(key));
    panel_ = new PlotPanel(isPolar(table) ? PlotKind::polar : PlotKind::cartesian,
                           std::move(dialogs), this);
    panel_->addInFront(quantity_);
    const auto isStack = [&](const std::string& key) { return canStack(table, key); };
    if (results_.size() == 1 && std::ranges::any_of(plottableQuantities(table), isStack)) {
        stack_ = new QCheckBox(tr("Stack"), this);
        stack_->setObjectName("stack");
        stack_->setToolTip(tr("Draw what each part adds to the sum as a layer"));
        stack_->setChecked(partsByOf(results_.front().data->settings) != PartsBy::none);
        panel_->addInFront(stack_);
        connect(stack_, &QCheckBox::toggled, this, &ResultPage::drawQuantity);
    }
    layout()->addWidget(panel_);
    drawQuantity();
    connect(quantity_, &QComboBox::activated, this, &ResultPage::drawQuantity);
}

void ResultPage::drawQuantity() {
    const std::string key = quantity_->currentData().toString().toStdString();
    const bool canBeStack = stack_ != nullptr && canStack(results_.front().data->table, key);
    if (stack_ != nullptr)
        stack_->setEnabled(canBeStack);
    const bool stacked = canBeStack && stack_->isChecked();
    if (auto* polar = panel_->polar()) {
        polar->setData(polarData(named(results_), key, stacked));
    } else {
        auto* cartesian = panel_->cartesian();
        auto data = cartesianData(named(results_), key, stacked);
        // The first quantity chooses the axes, then they stay as the user has them.
        if (drawn_) {
            data.xLogarithmic = cartesian->isLogarithmic(QwtPlot::xBottom);
            data.yLogarithmic = cartesian->isLogarithmic(QwtPlot::yLeft);
        }
        cartesian->setData(std::move(data));
    }
    drawn_ = true;
    panel_->refresh();
}

void ResultPage::rename(int id, const QString& title) {
    for (auto& entry : results_)
        if (entry.id == id)
            entry.title = title;
    if (panel_ != nullptr)
        drawQuantity();
    if (tables_ != nullptr)
        tables_->setTitle(title);
}

PolarPlot* ResultPage::polarPlot() const {
    return panel_ != nullptr ? panel_->polar() : nullptr;
}

CartesianPlot* ResultPage::cartesianPlot() const {
    return panel_ != nullptr ? panel_->cartesian() : nullptr;
}

QStringList ResultPage::exportFilters() const {
    if (draws_ != nullptr)
        return draws_->exportFilters();
    if (costAccuracy_ != nullptr)
        return costAccuracy_->exportFilters();
    if (image_ != nullptr)
        return imageFilters();
    QStringList filters{tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)"),
                        tr("Values as text (*.csv)")};
    if (results_.size() == 1)
        filters << tr("All inputs and values (*.json)");
    if (tables_ != nullptr)
        for (const TableFormat* format : tableFormats())
            if (format->isBuilt)
                filters << QStringLiteral("%1 (*%2)").arg(format->name, format->extension);
    return filters;
}

void ResultPage::exportTo(const std::filesystem::path& file) const {
    if (draws_ != nullptr) {
        draws_->exportTo(file);
        return;
    }
    if (costAccuracy_ != nullptr) {
        costAccuracy_->exportTo(file);
        return;
    }
    const std::string suffix = file.extension().string();
    const irsg::ImageFormat* format = irsg::imageFormatOf(file);
    if (image_ != nullptr && format != nullptr &&
        format->keeps == irsg::ImageFormat::Keeps::picture) {
        image_->exportTo(file); // the plane, colours and limits that are seen
    } else if (image_ != nullptr) {
        saveResult(*results_.front().data, file);
    } else if (results_.size() == 1 && (suffix == ".json" || suffix == ".csv")) {
        // The data with its provenance, rather than what is visible of it.
        results_.front().data->table.save(file);
    } else if (tables_ != nullptr && tableFormatOf(file) != nullptr) {
        saveTable(results_.front().data->table, file);
    } else if (tables_ != nullptr) {
        tables_->exportTo(file);
    } else {
        panel_->exportTo(file);
    }
}

} // namespace smat::gui

#include "moc_ResultPage.cpp"
