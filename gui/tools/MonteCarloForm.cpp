#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/tools/MonteCarloPage.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/workbench/Workbench.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

QSpinBox* wholeNumber(const QString& name, int least, int most, int value, QWidget* parent) {
    auto* box = new WholeBox(name, parent);
    box->setRange(least, most);
    box->setValue(value);
    return box;
}

QComboBox* choice(const QString& name, const QList<std::pair<QString, QString>>& words,
                  QWidget* parent) {
    auto* box = new QComboBox(parent);
    box->setObjectName(name);
    for (const auto& [word, data] : words)
        box->addItem(word, data);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(20);
    return box;
}

} // namespace

QWidget* MonteCarloPage::makeForm() {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 10, 10, 10);
    const auto group = [&](const QString& title, void (MonteCarloPage::*fill)(QFormLayout*)) {
        auto* box = new QGroupBox(title, panel);
        auto* form = new QFormLayout(box);
        form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        (this->*fill)(form);
        column->addWidget(box);
    };
    group(tr("What is repeated"), &MonteCarloPage::addWhat);
    group(tr("Draws"), &MonteCarloPage::addRealisations);

    auto* scalesBox = new QGroupBox(tr("Scales"), panel);
    auto* scalesColumn = new QVBoxLayout(scalesBox);
    scales_ = new QTreeWidget(scalesBox);
    scales_->setObjectName("scales");
    scales_->setHeaderLabels({tr("Scale"), tr("Distribution"), tr("Range")});
    scales_->setRootIsDecorated(false);
    scales_->setAlternatingRowColors(true);
    scales_->setMinimumHeight(70); // two of them; all that a higher window has room for
    scales_->header()->setStretchLastSection(false);
    scales_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    scales_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    scales_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    scalesNote_ = new QLabel(scalesBox);
    scalesNote_->setObjectName("scalesNote");
    scalesNote_->setWordWrap(true);
    write_ = new QPushButton(tr("Write scaling files"), scalesBox);
    write_->setObjectName("writeScalingFiles");
    write_->setToolTip(tr("Writes both files beside the model with scales of 1, to be edited; "
                          "existing files are left unchanged"));
    scalesColumn->addWidget(scales_, 1);
    scalesColumn->addWidget(scalesNote_);
    scalesColumn->addWidget(write_);
    scalesColumn->addStretch();
    column->addWidget(scalesBox, 1);
    return panel;
}

void MonteCarloPage::addWhat(QFormLayout* form) {
    analysis_ = choice("analysis", {}, this);
    analysis_->setToolTip(tr("The analysis that is repeated for every draw of the scales"));
    quantity_ = choice("quantity",
                       {{tr("Contrast intensity"), "contrast_intensity"},
                        {tr("Intensity"), "intensity"},
                        {tr("Irradiance"), "irradiance"}},
                       this);
    percentiles_ = new QLineEdit("5, 25, 50, 75, 95", this);
    percentiles_->setObjectName("percentiles");
    percentiles_->setToolTip(tr("Bands of the plot, in %: ascending numbers from 0 to 100"));
    subpixelShifts_ =
        wholeNumber("subpixelShifts", 1, MonteCarloOptions::mostSubpixelShifts, 4, this);
    subpixelShifts_->setToolTip(tr("Renderings of each case with the target at different sub-pixel "
                                   "shifts, which estimate the numerical error. 1: no estimate."));
    form->addRow(tr("Analysis"), analysis_);
    form->addRow(tr("Quantity"), quantity_);
    form->addRow(tr("Percentiles (%)"), percentiles_);
    form->addRow(tr("Renderings of each case"), subpixelShifts_);
}

void MonteCarloPage::addRealisations(QFormLayout* form) {
    samples_ = wholeNumber("samples", MonteCarloOptions::leastSamples,
                           MonteCarloOptions::mostSamples, 1024, this);
    samples_->setSingleStep(256);
    sequence_ =
        choice("sequence", {{tr("Sobol' sequence"), "sobol"}, {tr("Plain draws"), "plain"}}, this);
    sequence_->setToolTip(tr("Sobol' points fill the space of the scales evenly and need far fewer "
                             "draws; plain draws are independent"));
    const SettingInfo& seed = settingInfo(key::scalingSeed);
    seed_ = wholeNumber("seed", static_cast<int>(seed.minimum), static_cast<int>(seed.maximum), 1,
                        this);
    seed_->setToolTip(tr("The same seed gives the same draws on every machine"));
    stops_ = new QCheckBox(tr("Stop at a standard error of"), this);
    stops_->setObjectName("stops");
    standardError_ = new RealBox("standardError", "%", this);
    standardError_->setRange(0.0001, 50.0);
    standardError_->setDecimals(4);
    standardError_->setValue(0.1);
    standardError_->setToolTip(
        tr("Relative to the largest magnitude of the statistic over the sweep"));
    statistic_ = choice("statistic",
                        {{tr("Mean"), "mean"},
                         {tr("Standard deviation"), "standard-deviation"},
                         {tr("5th percentile"), "p5"},
                         {tr("Median"), "p50"},
                         {tr("95th percentile"), "p95"}},
                        this);
    form->addRow(tr("Maximum draws"), samples_);
    form->addRow(tr("Sequence"), sequence_);
    form->addRow(tr("Seed"), seed_);
    form->addRow(tr("Standard error of"), statistic_);
    ranks_ = new QCheckBox(tr("Rank by pairs of draws"), this);
    ranks_->setObjectName("ranks");
    ranks_->setChecked(true);
    ranks_->setToolTip(tr("Ranks the scales by first-order Sobol' indices over the whole sweep: "
                          "the share of the variance that would vanish if the scale were known"));
    pairs_ = wholeNumber("pairs", MonteCarloOptions::leastRankingPairs,
                         MonteCarloOptions::mostRankingPairs, 1024, this);
    pairs_->setSingleStep(256);
    form->addRow(stops_, standardError_);
    form->addRow(ranks_, pairs_);
}

} // namespace smat::gui
