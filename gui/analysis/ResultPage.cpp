#include "gui/analysis/ResultPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/Theme.h"
#include "gui/image/ColorBar.h"
#include "gui/image/ImageView.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotExport.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "irsg/image/PngView.h"
#include "irsg/radiometry/Errors.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {
namespace {

std::vector<NamedResult> named(const std::vector<ResultEntry>& results) {
    std::vector<NamedResult> list;
    for (const auto& entry : results)
        list.push_back({entry.title, &entry.data.table});
    return list;
}

} // namespace

ResultPage::ResultPage(const std::vector<ResultEntry>& results, QWidget* parent)
    : QWidget(parent), results_(results) {
    if (results_.empty())
        throw irsg::LogicError("a result page needs a result");
    setObjectName("resultPage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    for (const auto& entry : results_)
        ids_ << entry.id;
    if (results_.front().data.kind == AnalysisKind::image)
        showImage();
    else
        showPlot();
}

void ResultPage::showImage() {
    const AnalysisData& data = results_.front().data;
    image_ = new ImageView(this);
    image_->setImage(data.image, sensorOf(data.project, data.settings).band);
    image_->setColorMap(data.settings.text("display.colorMap"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(image_);
}

void ResultPage::showPlot() {
    const ResultTable& table = results_.front().data.table;
    quantity_ = new QComboBox(this);
    quantity_->setObjectName("quantity");
    quantity_->setToolTip(tr("Quantity that is drawn"));
    for (const auto& key : plottableQuantities(table))
        quantity_->addItem(QString::fromStdString(table.find(key)->axisTitle()),
                           QString::fromStdString(key));
    if (isPolar(table)) {
        polar_ = new PolarPlot(PlotStyle::screen(palette()), this);
        makeBar(polar_);
    } else {
        cartesian_ = new CartesianPlot(PlotStyle::screen(palette()), this);
        makeBar(cartesian_);
    }
    drawQuantity();
    connect(quantity_, &QComboBox::activated, this, &ResultPage::drawQuantity);
}

void ResultPage::makeBar(QWidget* plot) {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(10, 10, 10, 0);
    bar->addWidget(quantity_);
    bar->addStretch(1);
    const auto check = [&](const QString& text, const QString& name) {
        auto* box = new QCheckBox(text, this);
        box->setObjectName(name);
        bar->addWidget(box);
        return box;
    };
    if (polar_ != nullptr) {
        connect(check(tr("dB radius"), "decibel"), &QCheckBox::toggled, this, [this](bool on) {
            polar_->setRadiusScale(on ? RadiusScale::decibel : RadiusScale::linear);
        });
    } else {
        connect(check(tr("log x"), "logX"), &QCheckBox::toggled, this,
                [this](bool on) { cartesian_->setLogarithmic(QwtPlot::xBottom, on); });
        connect(check(tr("log y"), "logY"), &QCheckBox::toggled, this,
                [this](bool on) { cartesian_->setLogarithmic(QwtPlot::yLeft, on); });
    }
    auto* reset = new QToolButton(this);
    reset->setIcon(icon("home"));
    reset->setObjectName("resetView");
    reset->setToolTip(tr("Show all (double click)"));
    reset->setAutoRaise(true);
    bar->addWidget(reset);
    connect(reset, &QToolButton::clicked, this,
            [this] { polar_ != nullptr ? polar_->resetView() : cartesian_->resetView(); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addLayout(bar);
    column->addWidget(plot, 1);
}

void ResultPage::drawQuantity() {
    const std::string key = quantity_->currentData().toString().toStdString();
    if (polar_ != nullptr) {
        polar_->setData(polarData(named(results_), key));
        return;
    }
    auto data = cartesianData(named(results_), key);
    auto* logX = findChild<QCheckBox*>("logX");
    if (cartesian_->data().curves.empty())
        logX->setChecked(data.xLogarithmic);
    data.xLogarithmic = logX->isChecked();
    data.yLogarithmic = findChild<QCheckBox*>("logY")->isChecked();
    cartesian_->setData(std::move(data));
}

QStringList ResultPage::exportFilters() const {
    if (image_ != nullptr)
        return {tr("OpenEXR image (*.exr)"), tr("Values as text (*.csv)"), tr("Picture (*.png)")};
    return {tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)"),
            tr("Values as text (*.csv)"), tr("All inputs and values (*.json)")};
}

void ResultPage::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (image_ != nullptr && suffix == ".png") {
        // The plane, colours and limits that are seen.
        irsg::PngViewOptions options;
        options.colorMap = image_->colorMap().name();
        options.limits = image_->colorBar()->limits();
        options.title = results_.front().title.toStdString();
        irsg::writePngView(image_->image(), file, options, image_->shownChannel());
    } else if (image_ != nullptr) {
        saveResult(results_.front().data, file);
    } else if (results_.size() == 1 && (suffix == ".json" || suffix == ".csv")) {
        // The data with its provenance, rather than what is visible of it.
        saveResult(results_.front().data, file);
    } else if (polar_ != nullptr) {
        exportPlot(*polar_, file);
    } else {
        exportPlot(*cartesian_, file);
    }
}

} // namespace smat::gui
