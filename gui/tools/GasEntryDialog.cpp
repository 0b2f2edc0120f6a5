#include "gui/tools/GasEntryDialog.h"

#include <utility>

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/database/DatabaseEdits.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/ThemeColors.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

namespace {

/// The first index that neither a material nor a temperature has.
int freeInBoth(const irsg::SignatureDatabase& database) {
    int index = freeIndex(database, EntryKind::material);
    while (contains(database, {EntryKind::temperature, index}))
        index = freeIndex(database, EntryKind::material, index + 1);
    return index;
}

/// Throws irsg::InputError naming the field.
int indexIn(const QLineEdit& field) {
    bool isWhole = false;
    const int index = field.text().trimmed().toInt(&isWhole);
    if (!isWhole)
        throw irsg::InputError({"", field.accessibleName().toStdString(),
                                "'" + field.text().toStdString() + "'", "a whole number"});
    return index;
}

} // namespace

GasEntryDialog::GasEntryDialog(std::shared_ptr<const irsg::SignatureDatabase> database,
                               std::size_t layers, std::size_t chosen, const QString& name,
                               QWidget* parent)
    : QDialog(parent), database_(std::move(database)) {
    setObjectName("gasEntryDialog");
    setWindowTitle(tr("Add gas to the database"));
    what_ = new QComboBox(this);
    what_->setObjectName("gasEntryWhat");
    const auto offer = [&](const QString& words, What what) {
        what_->addItem(words, static_cast<int>(what));
    };
    offer(tr("Gas zone of layer %1").arg(chosen + 1), What::zone);
    offer(tr("Spectrum of layer %1").arg(chosen + 1), What::layerSpectrum);
    if (layers > 1)
        offer(tr("Spectrum of all %1 layers").arg(layers), What::allSpectrum);
    const auto field = [this](const char* object, const QString& title, const QString& text) {
        auto* edit = new QLineEdit(text, this);
        edit->setObjectName(object);
        edit->setAccessibleName(title);
        connect(edit, &QLineEdit::textChanged, this, &GasEntryDialog::refresh);
        return edit;
    };
    const QString index = QString::number(freeInBoth(*database_));
    name_ = field("gasEntryName", tr("Name"),
                  QString::fromStdString(freeSpectrumName(*database_, name.toStdString())));
    material_ = field("gasEntryMaterial", tr("Material index"), index);
    temperature_ = field("gasEntryTemperature", tr("Temperature index"), index);
    auto* form = new QFormLayout;
    form->addRow(tr("&Add"), what_);
    for (QLineEdit* edit : {name_, material_, temperature_})
        form->addRow(edit->accessibleName(), edit);
    outcome_ = new QLabel(this);
    outcome_->setObjectName("outcome");
    outcome_->setWordWrap(true);
    outcome_->setMinimumSize(440, 80);
    outcome_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    buttons_ = okAndCancel(*this, tr("Add"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(outcome_, 1);
    column->addWidget(buttons_);
    connect(what_, &QComboBox::currentIndexChanged, this, &GasEntryDialog::refresh);
    refresh();
    name_->setFocus();
    name_->selectAll();
}

GasEntryDialog::What GasEntryDialog::what() const {
    return static_cast<What>(what_->currentData().toInt());
}

QString GasEntryDialog::problem() {
    try {
        place_.name = name_->text().trimmed().toStdString();
        if (place_.name.empty())
            throw irsg::InputError({"", tr("Name").toStdString(), "nothing", "a name"});
        place_.material = indexIn(*material_);
        place_.temperature = indexIn(*temperature_);
        checkGasEntryPlace(*database_, place_, what() != What::zone);
        return {};
    } catch (const irsg::InputError& error) {
        return sentencesOf(error).join('\n');
    }
}

void GasEntryDialog::refresh() {
    if (buttons_ == nullptr)
        return;
    const QString wrong = problem();
    buttons_->button(QDialogButtonBox::Ok)->setEnabled(wrong.isEmpty());
    outcome_->setStyleSheet(
        wrong.isEmpty() ? QString()
                        : QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
    if (!wrong.isEmpty())
        outcome_->setText(wrong);
    else if (what() == What::zone)
        outcome_->setText(
            tr("A material of this pressure and these fractions, and a temperature. "
               "Closed meshes with these codes are filled with the gas; the length is "
               "that of the mesh."));
    else
        outcome_->setText(
            tr("A spectrum without background and atmosphere, a temperature that "
               "emits it, and a material of its transmittance. Faces with these codes "
               "look like the gas from every direction."));
}

} // namespace smat::gui

#include "moc_GasEntryDialog.cpp"
