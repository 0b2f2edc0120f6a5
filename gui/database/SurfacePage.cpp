#include "gui/database/SurfacePage.h"

#include <algorithm>
#include <string_view>

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/database/AngleCurve.h"
#include "gui/database/LitBallView.h"
#include "irsg/radiometry/Errors.h"
#include "irsg/signature/LitBall.h"
#include "irsg/signature/SurfaceModel.h"

namespace smat::gui {

namespace {

using Row = irsg::EntryField<irsg::Material>;

struct ModelWords {
    const char* name;
    const char* label;
    const char* help;
};
const ModelWords modelWords[] = {
    {"", QT_TRANSLATE_NOOP("SurfacePage", "Lambertian: alike in all directions"), ""},
    {"ggx", QT_TRANSLATE_NOOP("SurfacePage", "Facets (GGX)"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is that along the normal, "
                                      "unless n and k say it.")},
    {"beckmann", QT_TRANSLATE_NOOP("SurfacePage", "Facets (Beckmann)"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is that along the normal, "
                                      "unless n and k say it.")},
    {"sandfordRobertson", QT_TRANSLATE_NOOP("SurfacePage", "Sandford and Robertson: paints"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is the hemispherical.")},
    {"shellTarget", QT_TRANSLATE_NOOP("SurfacePage", "Shell target"),
     QT_TRANSLATE_NOOP("SurfacePage", "Emissivity follows from n and k, diffuse and volume "
                                      "reflectivity.")},
    {"tabulated", QT_TRANSLATE_NOOP("SurfacePage", "As a table was measured"),
     QT_TRANSLATE_NOOP("SurfacePage", "Emissivity is what the table leaves.")}};

QString labelOf(const std::string& name) {
    for (const ModelWords& words : modelWords)
        if (name == words.name)
            return SurfacePage::tr(words.label);
    return QString::fromStdString(name);
}

QString helpOf(const std::string& name) {
    for (const ModelWords& words : modelWords)
        if (name == words.name)
            return QString(words.help).isEmpty() ? QString() : SurfacePage::tr(words.help);
    return {};
}

bool takes(const irsg::Material& material, const char* key) {
    const auto& fields = irsg::SurfaceModel::fieldsOf(material.surfaceModel);
    return std::ranges::find(fields, std::string(key)) != fields.end();
}

QString rangeOf(const irsg::Spectrum& spectrum) {
    const double least = spectrum.minimum(), most = spectrum.maximum();
    return least == most ? QString::number(most, 'g', 4)
                         : SurfacePage::tr("%1 to %2")
                               .arg(QString::number(least, 'g', 4), QString::number(most, 'g', 4));
}

/// "Refractive index 1.4, Extinction 0.1 to 2", and what lacks.
QString spectraOf(const irsg::Material& material) {
    QStringList words;
    irsg::forEachField<irsg::Spectrum>(irsg::materialFields(), [&](const Row& row, auto member) {
        if (takes(material, row.key) && material.*member != irsg::Spectrum())
            words << SurfacePage::tr(row.label) + " " + rangeOf(material.*member);
    });
    if (takes(material, "reflectanceTable")) {
        const irsg::ReflectanceTable& table = material.reflectanceTable;
        words << (table.empty() ? SurfacePage::tr("No table yet")
                                : SurfacePage::tr("%1 of %2 directions at %3 wavelengths")
                                      .arg(table.isBrdf() ? SurfacePage::tr("BRDF")
                                                          : SurfacePage::tr("Reflectance"))
                                      .arg(table.rows().size())
                                      .arg(table.wavelengths_um().size()));
    }
    if (words.isEmpty() && takes(material, "refractiveIndex"))
        words << SurfacePage::tr("n and k not known");
    return words.join(", ");
}

} // namespace

SurfacePage::SurfacePage(QWidget* parent) : QWidget(parent) {
    setObjectName("surfacePage");
    model_ = new QComboBox(this);
    model_->setObjectName("surfaceModel");
    model_->addItem(labelOf({}), QString());
    for (const std::string& name : irsg::SurfaceModel::names())
        model_->addItem(labelOf(name), QString::fromStdString(name));
    connect(model_, &QComboBox::activated, this, [this](int) {
        emit modelChosen(model_->currentData().toString().toStdString());
        emit gestureEnded();
    });
    auto* top = new QGridLayout;
    top->addWidget(makeFieldLabel("Surface model", this), 0, 0);
    top->addWidget(model_, 0, 1, 1, 3);
    top->setColumnStretch(1, 1);
    top->setColumnStretch(3, 1);
    numbers_.emplace(
        irsg::materialFields(), this,
        [this](const Row& row, double value) { emit numberEdited(row, value); },
        [this] { emit gestureEnded(); },
        [](const Row& row) { return std::string_view(row.page) == "surface"; });
    auto* form = new QGridLayout;
    numbers_->addTo(*form, 2);

    spectra_ = new QLabel(this);
    spectra_->setObjectName("surfaceSpectra");
    spectra_->setWordWrap(true);
    spectra_->setForegroundRole(QPalette::PlaceholderText);
    constexpr int lines = 3;
    spectra_->setMinimumHeight(lines * spectra_->fontMetrics().lineSpacing());
    auto* import = new QPushButton(tr("Import…"), this);
    import->setObjectName("importSurface");
    import->setToolTip(tr("n and k, diffuse and volume reflectivity from a CSV of this material's "
                          "spectra, or a table of reflectance (CSV, Zemax BSDF)"));
    connect(import, &QPushButton::clicked, this, &SurfacePage::importWanted);
    top->addWidget(import, 0, 4);

    curve_ = new AngleCurve(tr("reflectance in the band"), this);
    curve_->setObjectName("reflectanceOverAngle");
    curve_->setToolTip(tr("Directional-hemispherical reflectance against the angle from the "
                          "normal, mean over the band; dotted: emissivity"));
    ball_ = new LitBallView(this);
    auto* pictures = new QHBoxLayout;
    pictures->addWidget(curve_, 3);
    pictures->addWidget(ball_, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 10, 0, 0);
    column->setSpacing(8);
    column->addLayout(top);
    column->addLayout(form);
    column->addWidget(spectra_);
    column->addLayout(pictures, 1);
}

void SurfacePage::show(const irsg::Material& material, const irsg::SpectralRange& band) {
    numbers_->show(material);
    numbers_->showOnly([&](const Row& row) { return takes(material, row.key); });
    model_->setCurrentIndex(
        std::max(0, model_->findData(QString::fromStdString(material.surfaceModel))));
    model_->setToolTip(tr("With a model the sun glints, sky and ground are mirrored, emissivity "
                          "follows the angle, and N has no effect. %1")
                           .arg(helpOf(material.surfaceModel)));
    spectra_->setText(spectraOf(material));
    ball_->show(material, band);
    const irsg::Spectrum* through[] = {&material.transmissivity};
    const double t = irsg::integrateProduct(through, band) / band.width_um();
    try {
        // Kirchhoff: what is neither reflected nor let through is emitted.
        const auto reflectance = [&](double cosine) {
            return irsg::bandReflectance(material, cosine, band);
        };
        curve_->show(reflectance, {[&](double cosine) { return 1.0 - t - reflectance(cosine); }});
    } catch (const irsg::InputError&) {
        curve_->clear();
    }
}

} // namespace smat::gui
