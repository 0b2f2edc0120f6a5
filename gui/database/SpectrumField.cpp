#include "gui/database/SpectrumField.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>

#include "gui/database/EntryNumbers.h"

namespace smat::gui {

irsg::Spectrum greyMeanOf(const irsg::Spectrum& spectrum, const irsg::SpectralRange& band) {
    const irsg::Spectrum* factors[] = {&spectrum};
    const double mean = irsg::integrateProduct(factors, band) / band.width_um();
    return irsg::Spectrum::constant(QString::number(mean, 'f', 4).toDouble());
}

irsg::Spectrum evenNodesOf(const irsg::Spectrum& grey, const irsg::SpectralRange& band) {
    const double level = grey.maximum();
    return {{band.min_um, band.centre_um(), band.max_um}, {level, level, level}};
}

SpectrumField::SpectrumField(const Row& row, QWidget* parent) : QWidget(parent), row_(row) {
    const QString key = row.key;
    form_ = new QComboBox(this);
    form_->setObjectName(key + "Form");
    form_->addItems({tr("Grey"), tr("Spectral")});
    form_->setToolTip(tr("Grey: one value at every wavelength. Spectral: nodes over wavelength, "
                         "linear between them and held outside"));
    grey_ = makeNumberField(row.key, row.unit, row.help, row.number, this);
    nodes_ = new QPushButton(this);
    nodes_->setObjectName(key + "Nodes");
    nodes_->setCheckable(true);
    nodes_->setToolTip(QCoreApplication::translate("EntryFields", row.help) +
                       tr(". Shows its nodes over wavelength, to be edited"));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(form_);
    line->addWidget(grey_, 1);
    line->addWidget(nodes_, 1);
    connect(form_, &QComboBox::activated, this, [this](int form) { chooseForm(form == 0); });
    connect(grey_, &NumberField::edited, this, [this](double value) {
        value_ = irsg::Spectrum::constant(value);
        emit edited(value_, tr("to a grey value"));
    });
    connect(grey_, &NumberField::finished, this, &SpectrumField::gestureEnded);
    connect(nodes_, &QPushButton::clicked, this, &SpectrumField::opened);
}

void SpectrumField::show(const irsg::Spectrum& value, const irsg::SpectralRange& band) {
    value_ = value;
    band_ = band;
    const bool isGrey = value.isConstant();
    form_->setCurrentIndex(isGrey ? 0 : 1);
    grey_->setVisible(isGrey);
    nodes_->setVisible(!isGrey);
    if (isGrey) {
        grey_->setValue(value.maximum());
        return;
    }
    const auto number = [](double of) { return QString::number(of, 'g', 4); };
    nodes_->setText(tr("%1 nodes, %2 to %3")
                        .arg(value.wavelengths_um().size())
                        .arg(number(value.minimum()), number(value.maximum())));
}

NodeRules SpectrumField::rules() const {
    NodeRules rules;
    rules.xName = tr("wavelength");
    rules.xUnit = tr("µm");
    rules.yName = QCoreApplication::translate("EntryFields", row_.word);
    rules.yUnit = QCoreApplication::translate("EntryFields", row_.unit);
    rules.xPositive = true;
    rules.yMinimum = row_.number.least;
    rules.yMaximum = row_.number.most;
    rules.fewest = 2;
    return rules;
}

bool SpectrumField::isOpen() const {
    return nodes_->isChecked();
}

void SpectrumField::setOpen(bool open) {
    nodes_->setChecked(open);
}

void SpectrumField::chooseForm(bool isGrey) {
    if (isGrey == value_.isConstant())
        return;
    value_ = isGrey ? greyMeanOf(value_, band_) : evenNodesOf(value_, band_);
    emit edited(value_, isGrey ? tr("to its mean in the band") : tr("to nodes over wavelength"));
    emit gestureEnded();
    emit opened(!isGrey);
}

} // namespace smat::gui

#include "moc_SpectrumField.cpp"
