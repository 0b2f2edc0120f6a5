#include "gui/database/MaterialPanel.h"

#include <string_view>

#include <QGridLayout>
#include <QLabel>
#include <QTabWidget>
#include <QVBoxLayout>

#include "gui/database/AngleCurve.h"
#include "gui/database/SpectralProperty.h"
#include "gui/database/SurfacePage.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {

MaterialPanel::MaterialPanel(EditorContext& context, QWidget* parent)
    : EntryPanel(context, EntryKind::material, parent) {
    setObjectName("materialPanel");
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName("materialTabs");
    tabs_->setDocumentMode(true);
    emissivity_ = makeProperty(true);
    transmissivity_ = makeProperty(false);
    tabs_->addTab(emissivity_, tr("Emissivity"));
    tabs_->addTab(transmissivity_, tr("Transmissivity"));
    tabs_->addTab(makeAngle(), tr("N angle factor"));
    tabs_->addTab(makeSurface(), tr("Surface"));
    tabs_->addTab(makeGas(), tr("Gas"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 8, 0, 0);
    column->setSpacing(4);
    column->addWidget(makeHeading());
    tabs_->addTab(makeNotes(), tr("Notes"));
    letShownPageAloneAskForRoom(*tabs_);
    column->addWidget(tabs_, 1);
}

SpectralProperty* MaterialPanel::makeProperty(bool emissivity) {
    using Which = SpectralProperty::Which;
    auto* property =
        new SpectralProperty(emissivity ? Which::emissivity : Which::transmissivity, this);
    connect(property, &SpectralProperty::edited, this,
            [this, emissivity](const irsg::Spectrum& value, const QString& what) {
                edit(tr("Set %1 of material %2 %3")
                         .arg(emissivity ? tr("emissivity") : tr("transmissivity"))
                         .arg(key_ ? key_->index : 0)
                         .arg(what),
                     emissivity ? "emissivity" : "transmissivity",
                     [&](irsg::SignatureDatabase& database) {
                         auto& material = database.materials.at(key_->index);
                         (emissivity ? material.emissivity : material.transmissivity) = value;
                     });
            });
    connect(property, &SpectralProperty::gestureEnded, this, [this] { endGesture(); });
    return property;
}

QWidget* MaterialPanel::makeAngle() {
    auto* holder = new QWidget(this);
    auto* words =
        new QLabel(tr("Emission is multiplied by cos<sup>N</sup> of the angle between the normal "
                      "and the sensor. Dotted: N = 0, 0.25, 1 and 3."),
                   holder);
    words->setWordWrap(true);
    words->setForegroundRole(QPalette::PlaceholderText);
    curve_ = new AngleCurve(tr("part of that along the normal"), holder);
    curve_->setObjectName("angleCurve");
    using Row = irsg::EntryField<irsg::Material>;
    numbers_.emplace(
        irsg::materialFields(), holder,
        [this](const Row& row, double value) { setNumber(row, value); }, [this] { endGesture(); },
        [](const Row& row) { return std::string_view(row.page).empty(); });
    auto* form = new QGridLayout;
    numbers_->addTo(*form, 1);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 10, 0, 0);
    column->setSpacing(10);
    column->addLayout(form);
    column->addWidget(words);
    column->addWidget(curve_, 1);
    return holder;
}

QWidget* MaterialPanel::makeSurface() {
    using Row = irsg::EntryField<irsg::Material>;
    surface_ = new SurfacePage(this);
    connect(surface_, &SurfacePage::modelChosen, this, [this](const std::string& name) {
        edit(tr("Set surface model of material %1").arg(key_ ? key_->index : 0), "surfaceModel",
             [&](irsg::SignatureDatabase& database) {
                 database.materials.at(key_->index).surfaceModel = name;
             });
    });
    connect(surface_, &SurfacePage::numberEdited, this,
            [this](const Row& row, double value) { setNumber(row, value); });
    connect(surface_, &SurfacePage::spectrumEdited, this,
            [this](const Row& row, const irsg::Spectrum& value, const QString& what) {
                edit(tr("Set %1 of material %2 %3")
                         .arg(tr(row.word))
                         .arg(key_ ? key_->index : 0)
                         .arg(what),
                     row.key, [&](irsg::SignatureDatabase& database) {
                         database.materials.at(key_->index).*row.as<irsg::Spectrum>() = value;
                     });
            });
    connect(surface_, &SurfacePage::tableEdited, this,
            [this](const irsg::ReflectanceTable& table, const QString& what) {
                edit(tr("Set table of reflectance of material %1 %2")
                         .arg(key_ ? key_->index : 0)
                         .arg(what),
                     "reflectanceTable", [&](irsg::SignatureDatabase& database) {
                         database.materials.at(key_->index).reflectanceTable = table;
                     });
            });
    connect(surface_, &SurfacePage::gestureEnded, this, [this] { endGesture(); });
    connect(surface_, &SurfacePage::importWanted, this, [this] {
        if (key_)
            emit importWanted(key_->index);
    });
    return surface_;
}

QWidget* MaterialPanel::makeGas() {
    auto* holder = new QWidget(this);
    auto* words = new QLabel(tr("With a pressure above 0, closed meshes of this material are zones "
                                "of gas at the temperature of their faces. Fractions are of moles; "
                                "the rest is nitrogen."),
                             holder);
    words->setWordWrap(true);
    words->setForegroundRole(QPalette::PlaceholderText);
    using Row = irsg::EntryField<irsg::Material>;
    gas_.emplace(
        irsg::materialFields(), holder,
        [this](const Row& row, double value) { setNumber(row, value); }, [this] { endGesture(); },
        [](const Row& row) { return std::string_view(row.page) == "gas"; });
    auto* form = new QGridLayout;
    gas_->addTo(*form, 2);
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 10, 0, 0);
    column->setSpacing(10);
    column->addLayout(form);
    column->addWidget(words);
    column->addStretch(1);
    return holder;
}

void MaterialPanel::setNumber(const irsg::EntryField<irsg::Material>& row, double value) {
    edit(tr("Set %1 of material %2").arg(tr(row.word)).arg(key_ ? key_->index : 0), row.key,
         [&](irsg::SignatureDatabase& database) {
             database.materials.at(key_->index).*row.as<double>() = value;
         });
}

void MaterialPanel::refresh() {
    const irsg::Material& material = context_.session().value().materials.at(key_->index);
    const int faces = context_.facesOf(*key_);
    showTexts(material.name, material.notes,
              context_.knowsModel() ? counted(faces, tr("face"), tr("faces")) : QString());
    emissivity_->setValue(material.emissivity, material.transmissivity, context_.band());
    transmissivity_->setValue(material.transmissivity, material.emissivity, context_.band());
    numbers_->show(material);
    gas_->show(material);
    curve_->showFactor(material.nAngleFactor);
    surface_->show(material, context_.band());
}

} // namespace smat::gui

#include "moc_MaterialPanel.cpp"
