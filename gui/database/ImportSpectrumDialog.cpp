#include "gui/database/ImportSpectrumDialog.h"

#include <algorithm>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/database/Nodes.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/radiometry/Planck.h"
#include "irsg/signature/SpectrumCsv.h"

namespace smat::gui {

ImportSpectrumDialog::ImportSpectrumDialog(const EditorContext& context,
                                           const std::filesystem::path& file, QWidget* parent)
    : QDialog(parent), context_(context), file_(file) {
    setObjectName("importSpectrumDialog");
    setWindowTitle(tr("Import %1").arg(QString::fromStdString(file.filename().string())));
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
    distance_->setToolTip(tr("m: the air up to there is inside the measurement already"));
    outcome_ = new QLabel(this);
    outcome_->setObjectName("outcome");
    outcome_->setWordWrap(true);
    outcome_->setMinimumSize(460, 90);
    outcome_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    buttons_ = okAndCancel(*this, tr("Import"));
    connect(name_, &QLineEdit::textChanged, this, &ImportSpectrumDialog::read);
    connect(unit_, &QComboBox::currentIndexChanged, this, &ImportSpectrumDialog::read);
    connect(distance_, &QLineEdit::textChanged, this, &ImportSpectrumDialog::read);
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Unit of the values"), unit_);
    form->addRow(tr("Reference distance (m)"), distance_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(outcome_, 1);
    column->addWidget(buttons_);
    read();
}

void ImportSpectrumDialog::read() {
    spectrum_.reset();
    QString words;
    try {
        std::optional<irsg::SpectralRadianceUnit> unit;
        if (unit_->currentIndex() > 0)
            unit = irsg::SpectralRadianceUnit::parse(unit_->currentText().toStdString());
        std::optional<double> distance_m;
        if (!distance_->text().trimmed().isEmpty()) {
            distance_m = numberOf(distance_->text());
            if (!distance_m || *distance_m < 0.0)
                throw irsg::InputError({"", tr("reference distance").toStdString(),
                                        distance_->text().toStdString(),
                                        tr("a number of at least 0 m").toStdString()});
        }
        const std::string name = name_->text().trimmed().toStdString();
        if (name.empty() || context_.session().value().spectra.contains(name))
            throw irsg::InputError({"", tr("name").toStdString(), "'" + name + "'",
                                    tr("a name that no other spectrum has").toStdString()});
        irsg::UserSpectrum read = irsg::readSpectrumCsv(file_, unit, distance_m);
        read.name = name;

        // The brightness temperature of the strongest peak tells whether the unit is plausible.
        double hottest_K = 0.0;
        for (const auto& component : read.components) {
            const auto& axis = component.radiance.wavelengths_um();
            for (std::size_t i = 0; i < axis.size(); ++i)
                hottest_K =
                    std::max(hottest_K,
                             irsg::brightnessTemperature_K(axis[i], component.radiance.values()[i])
                                 .value_or(0.0));
        }
        const auto& axis = read.components.front().radiance.wavelengths_um();
        QStringList names;
        for (const auto& component : read.components)
            names << QString::fromStdString(component.name);
        words = tr("%1: %2 nodes from %3 to %4 um; brightest as a black body of %5 K; "
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
    } catch (const irsg::InputError& error) {
        words = sentencesOf(error).mid(0, 6).join("\n");
    }
    outcome_->setText(words);
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(spectrum_.has_value());
    outcome_->setStyleSheet(
        spectrum_ ? QString()
                  : QStringLiteral("color: %1").arg(isDark(palette()) ? "#ff9d9d" : "#b3261e"));
}

} // namespace smat::gui
