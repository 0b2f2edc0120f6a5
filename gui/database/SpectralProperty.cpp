#include "gui/database/SpectralProperty.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"
#include "gui/database/SpectrumField.h"
#include "gui/plot/PlotData.h"
#include "gui/widgets/NumberField.h"

namespace smat::gui {
namespace {

constexpr int greyForm = 0;
constexpr int spectralForm = 1;
/// Colours of plot styles.
constexpr int emissivityColor = 1;
constexpr int transmissivityColor = 0;
constexpr int reflectivityColor = 2;

/// As the line above the plot has them: names leave a low plot no room.
QString symbolOf(bool isEmissivity) {
    return isEmissivity ? QStringLiteral("ε") : QStringLiteral("t");
}

Curve curveOf(const QString& name, const irsg::Spectrum& spectrum,
              const std::vector<double>& wavelengths_um) {
    return {name, wavelengths_um, spectrum.sample(wavelengths_um)};
}

} // namespace

SpectralProperty::SpectralProperty(Which which, QWidget* parent) : QWidget(parent), which_(which) {
    const bool emission = which == Which::emissivity;
    setObjectName(emission ? "emissivity" : "transmissivity");
    form_ = new QComboBox(this);
    form_->setObjectName("form");
    form_->addItems({tr("Grey"), tr("Spectral")});
    form_->setToolTip(tr("Grey: one value at every wavelength. Spectral: nodes over wavelength, "
                         "linear between them and clamped outside"));
    grey_ = new NumberField({}, this);
    grey_->setObjectName("greyValue");
    grey_->setStep(0.01);
    remark_ = new QLabel(this);
    remark_->setObjectName("reflectivity");
    remark_->setForegroundRole(QPalette::PlaceholderText);
    remark_->setToolTip(tr("Reflectivity over the wavelengths of the plot"));
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(form_);
    row->addWidget(grey_);
    row->addWidget(remark_, 1);
    nodes_ = new NodeEditor(this);
    nodes_->plot()->setCurveColors(
        emission ? emissivityColor : transmissivityColor,
        {emission ? transmissivityColor : emissivityColor, reflectivityColor});
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(6);
    column->addLayout(row);
    column->addWidget(nodes_, 1);

    connect(form_, &QComboBox::activated, this, &SpectralProperty::chooseForm);
    connect(grey_, &NumberField::edited, this, [this](double value) {
        value_ = irsg::Spectrum::constant(value);
        emit edited(value_, tr("to a grey value"));
    });
    connect(grey_, &NumberField::finished, this, &SpectralProperty::gestureEnded);
    connect(nodes_, &NodeEditor::edited, this, [this](const Nodes& nodes, const QString& what) {
        value_ = spectrumOf(nodes, irsg::Spectrum::Outside::hold);
        drawBackdrop();
        emit edited(value_, what);
    });
    connect(nodes_, &NodeEditor::gestureEnded, this, &SpectralProperty::gestureEnded);
}

void SpectralProperty::setValue(const irsg::Spectrum& value, const irsg::Spectrum& other,
                                const irsg::SpectralRange& band) {
    value_ = value;
    const bool same = std::exchange(ruled_, true) && other_ == other && band_ == band;
    other_ = other;
    band_ = band;
    const bool grey = value_.isConstant();
    form_->setCurrentIndex(grey ? greyForm : spectralForm);
    grey_->setVisible(grey);
    grey_->setRange(0.0, 1.0 - other_.maximum());
    grey_->setToolTip(tr("From 0 to %1, so that the sum with the other property is at most 1")
                          .arg(textOf(1.0 - other_.maximum())));
    if (!same) {
        const bool emission = which_ == Which::emissivity;
        NodeRules rules;
        rules.xName = tr("wavelength");
        rules.xUnit = tr("µm");
        rules.yName = emission ? tr("emissivity") : tr("transmissivity");
        rules.ySymbol = symbolOf(emission);
        rules.xPositive = true;
        rules.yMinimum = 0.0;
        rules.yMaximum = 1.0;
        rules.yMaximumAt = [rest = other_](double x) { return 1.0 - rest.at(x); };
        rules.fewest = 2;
        rules.yStart = emission ? 0.9 : 0.0;
        nodes_->setRules(rules);
        nodes_->plot()->setLeastView(
            Interval{std::max(0.2, band_.min_um - 0.5), band_.max_um + 0.5}, Interval{0.0, 1.0});
    }
    // A grey value is drawn as the level it is; nodes appear when it becomes spectral.
    if (grey)
        grey_->setValue(value_.maximum());
    nodes_->setNodes(nodesOf(value_));
    nodes_->setEnabled(!grey);
    drawBackdrop();
}

void SpectralProperty::chooseForm(int form) {
    const bool toGrey = form == greyForm;
    if (toGrey == value_.isConstant())
        return;
    if (toGrey) {
        const double mean = greyMeanOf(value_, band_).maximum();
        value_ = irsg::Spectrum::constant(std::min(mean, 1.0 - other_.maximum()));
        emit edited(value_, tr("to its mean in the band"));
    } else {
        value_ = evenNodesOf(value_, band_);
        emit edited(value_, tr("to nodes over wavelength"));
    }
    emit gestureEnded();
}

void SpectralProperty::drawBackdrop() {
    const bool emission = which_ == Which::emissivity;
    const Nodes nodes = nodesOf(value_);
    const double low = std::min(nodes.empty() ? band_.min_um : nodes.front().x, band_.min_um);
    const double high = std::max(nodes.empty() ? band_.max_um : nodes.back().x, band_.max_um);
    const irsg::Spectrum* both[] = {&value_, &other_};
    const auto axis = irsg::mergeAxes(both, {std::max(0.2, low - 0.5), high + 0.5});
    Curve rest{QStringLiteral("ρ"), axis, {}};
    const auto a = value_.sample(axis);
    const auto b = other_.sample(axis);
    for (std::size_t i = 0; i < axis.size(); ++i)
        rest.y.push_back(1.0 - a[i] - b[i]);
    // A grey value has no nodes: it is drawn as the level it is.
    const int own = emission ? emissivityColor : transmissivityColor;
    const int others = emission ? transmissivityColor : emissivityColor;
    if (value_.isConstant()) {
        nodes_->plot()->setBackdrop({curveOf(symbolOf(emission), value_, axis),
                                     curveOf(symbolOf(!emission), other_, axis), rest});
        nodes_->plot()->setCurveColors(own, {own, others, reflectivityColor});
    } else {
        nodes_->plot()->setBackdrop({curveOf(symbolOf(!emission), other_, axis), rest});
        nodes_->plot()->setCurveColors(own, {others, reflectivityColor});
    }
    const auto [least, most] = std::minmax_element(rest.y.begin(), rest.y.end());
    const auto shown = [](double value) {
        return QString::number(std::abs(value) < 5e-4 ? 0.0 : value, 'f', 3);
    };
    remark_->setText(shown(*least) == shown(*most)
                         ? tr("ρ = 1 − ε − t = %1").arg(shown(*least))
                         : tr("ρ = 1 − ε − t from %1 to %2").arg(shown(*least), shown(*most)));
}

} // namespace smat::gui

#include "moc_SpectralProperty.cpp"
