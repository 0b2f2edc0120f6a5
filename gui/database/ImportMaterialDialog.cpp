#include "gui/database/ImportMaterialDialog.h"

#include <algorithm>
#include <utility>

#include <QFormLayout>
#include <QLineEdit>

#include "gui/database/Nodes.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/EntryFields.h"
#include "irsg/signature/MaterialCsv.h"
#include "irsg/signature/ReflectanceCsv.h"

namespace smat::gui {

ImportMaterialDialog::ImportMaterialDialog(const EditorContext& context,
                                           const std::filesystem::path& file,
                                           std::optional<int> index, QWidget* parent)
    : ImportDialog(context, file, parent) {
    setObjectName("importMaterialDialog");
    indexField_ = new QLineEdit(
        QString::number(index ? *index : freeIndex(context.session().value(), EntryKind::material)),
        this);
    indexField_->setObjectName("materialIndex");
    indexField_->setToolTip(tr("Of the entry that gets the spectra: a new one, or an existing one, "
                               "which keeps its N angle factor and its notes"));
    name_ = new QLineEdit(this);
    name_->setObjectName("materialName");
    connect(indexField_, &QLineEdit::textChanged, this, &ImportMaterialDialog::read);
    connect(name_, &QLineEdit::textChanged, this, &ImportMaterialDialog::read);
    auto* form = new QFormLayout;
    form->addRow(tr("&Material index"), indexField_);
    form->addRow(tr("&Name"), name_);
    start(form);
}

QString ImportMaterialDialog::readFile() {
    material_.reset();
    bool isWhole = false;
    index_ = indexField_->text().trimmed().toInt(&isWhole);
    if (!isWhole)
        throw irsg::InputError({"", tr("material index").toStdString(),
                                "'" + indexField_->text().toStdString() + "'",
                                tr("a whole number").toStdString()});
    const auto import =
        irsg::isReflectanceTable(file()) ? irsg::importedReflectance : irsg::importedMaterial;
    irsg::Material read =
        import(file(), context().session().value(), index_, name_->text().trimmed().toStdString());
    name_->setPlaceholderText(QString::fromStdString(read.name));
    material_ = std::move(read);
    return wordsOf(*material_);
}

QString ImportMaterialDialog::wordsOf(const irsg::Material& material) const {
    QStringList lines;
    const irsg::ReflectanceTable& table = material.reflectanceTable;
    if (!table.empty() && material.surfaceModel == "tabulated")
        lines << (table.isBrdf() ? tr("A BRDF of %1 directions at %2 wavelengths.")
                                 : tr("Reflectance at %1 angles and %2 wavelengths."))
                     .arg(table.rows().size())
                     .arg(table.wavelengths_um().size());
    irsg::forEachField<irsg::Spectrum>(irsg::materialFields(), [&](const auto& field, auto member) {
        const auto& axis = (material.*member).wavelengths_um();
        if (!axis.empty())
            lines << tr("%1: %2 nodes from %3 to %4 um.")
                         .arg(tr(field.label))
                         .arg(axis.size())
                         .arg(axis.front(), 0, 'g', 5)
                         .arg(axis.back(), 0, 'g', 5);
    });
    const double emissivity = context().bandMean(material.emissivity);
    const double transmissivity = context().bandMean(material.transmissivity);
    lines << tr("In the band of the project: emissivity %1, transmissivity %2, reflectivity %3.")
                 .arg(emissivity, 0, 'f', 4)
                 .arg(transmissivity, 0, 'f', 4)
                 .arg(std::max(0.0, 1.0 - emissivity - transmissivity), 0, 'f', 4);
    const EntryKey key{EntryKind::material, index_};
    if (contains(context().session().value(), key))
        lines << tr("Replaces the spectra of %1.").arg(context().title(key));
    const int faces = context().facesOf(key);
    lines << (faces > 0 ? tr("%1 of the model with code %2 will look like this.")
                              .arg(counted(faces, tr("face"), tr("faces")))
                              .arg(index_)
                        : tr("No face of the model carries code %1.").arg(index_));
    return lines.join('\n');
}

} // namespace smat::gui

#include "moc_ImportMaterialDialog.cpp"
