#include "gui/database/ImportSpectrumDialog.h"

#include <algorithm>
#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QLineEdit>

#include "gui/database/Nodes.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/SpectrumCsv.h"

namespace smat::gui {

ImportSpectrumDialog::ImportSpectrumDialog(const EditorContext& context,
                                           const std::filesystem::path& file, QWidget* parent)
    : ImportDialog(context, file, parent) {
    setObjectName("importSpectrumDialog");
    name_ = new QLineEdit(
        QString::fromStdString(freeSpectrumName(context.session().value(), file.stem().string())),
        this);
    name_->setObjectName("spectrumName");
    unit_ = new QComboBox(this);
    unit_->setObjectName("radianceUnit");
    unit_->addItem(tr("as the file states"));
    for (const auto& unit : irsg::SpectralRadianceUnit::known())
        unit_->addItem(QString::fromStdString(unit));
    unit_->setToolTip(tr("Densities per cm-1 become densities per um with the factor ν²/10⁴"));
    distance_ = new QLineEdit(this);
    distance_->setObjectName("importDistance");
    distance_->setPlaceholderText(tr("as the file states, else 0"));
    distance_->setToolTip(
        tr("m: absorption up to this distance is already contained in the measurement"));
    connect(name_, &QLineEdit::textChanged, this, &ImportSpectrumDialog::read);
    connect(unit_, &QComboBox::currentIndexChanged, this, &ImportSpectrumDialog::read);
    connect(distance_, &QLineEdit::textChanged, this, &ImportSpectrumDialog::read);
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Unit of the values"), unit_);
    form->addRow(tr("Reference distance (m)"), distance_);
    start(form);
}

QString ImportSpectrumDialog::readFile() {
    spectrum_.reset();
    std::optional<irsg::SpectralRadianceUnit> unit;
    if (unit_->currentIndex() > 0)
        unit = irsg::SpectralRadianceUnit::parse(unit_->currentText().toStdString());
    std::optional<double> distance_m;
    if (!distance_->text().trimmed().isEmpty()) {
        distance_m = typedNumber(distance_->text(), "m").value;
        if (!distance_m || *distance_m < 0.0)
            throw irsg::InputError({"", tr("reference distance").toStdString(),
                                    distance_->text().toStdString(),
                                    tr("a number of at least 0 m").toStdString()});
    }
    const std::string name = name_->text().trimmed().toStdString();
    if (name.empty() || context().session().value().spectra.contains(name))
        throw irsg::InputError({"", tr("name").toStdString(), "'" + name + "'",
                                tr("a name that no other spectrum has").toStdString()});
    irsg::UserSpectrum read = irsg::readSpectrumCsv(file(), unit, distance_m);
    read.name = name;

    // The brightness temperature of the strongest peak tells whether the unit is plausible.
    double hottest_K = 0.0;
    for (const auto& component : read.components) {
        const auto& axis = component.radiance.wavelengths_um();
        for (std::size_t i = 0; i < axis.size(); ++i)
            hottest_K = std::max(
                hottest_K, irsg::brightnessTemperature_K(axis[i], component.radiance.values()[i])
                               .value_or(0.0));
    }
    const auto& axis = read.components.front().radiance.wavelengths_um();
    QStringList names;
    for (const auto& component : read.components)
        names << QString::fromStdString(component.name);
    QString words = tr("%1: %2 nodes from %3 to %4 um; brightest as a black body of %5 K; "
                       "reference distance %6 m.")
                        .arg(names.join(", "))
                        .arg(axis.size())
                        .arg(axis.front(), 0, 'g', 5)
                        .arg(axis.back(), 0, 'g', 5)
                        .arg(hottest_K, 0, 'f', 0)
                        .arg(textOf(read.referenceDistance_m));
    if (hottest_K > 4000.0 || hottest_K < 200.0)
        words += "\n" + tr("That is outside 200 to 4000 K: is the unit right?");
    spectrum_ = std::move(read);
    return words;
}

} // namespace smat::gui

#include "moc_ImportSpectrumDialog.cpp"
