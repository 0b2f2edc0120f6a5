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
#include "gui/database/NodeEditor.h"
#include "gui/database/NodePlot.h"
#include "gui/database/ReflectanceEditor.h"
#include "gui/database/SpectrumField.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/signature/LitBall.h"
#include "irsg/signature/SurfaceModels.h"

namespace smat::gui {

namespace {

struct ModelWords {
    const char* name;
    const char* label;
    const char* help;
};
const ModelWords modelWords[] = {
    {"", QT_TRANSLATE_NOOP("SurfacePage", "Lambertian: diffuse"), ""},
    {"ggx", QT_TRANSLATE_NOOP("SurfacePage", "Facets (GGX)"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is that along the normal, "
                                      "unless n and k give it.")},
    {"beckmann", QT_TRANSLATE_NOOP("SurfacePage", "Facets (Beckmann)"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is that along the normal, "
                                      "unless n and k give it.")},
    {"sandfordRobertson", QT_TRANSLATE_NOOP("SurfacePage", "Sandford and Robertson: paints"),
     QT_TRANSLATE_NOOP("SurfacePage", "The emissivity of the first page is hemispherical.")},
    {"shellTarget", QT_TRANSLATE_NOOP("SurfacePage", "Shell target"),
     QT_TRANSLATE_NOOP("SurfacePage", "Emissivity follows from n and k, diffuse and volume "
                                      "reflectivity.")},
    {"tabulated", QT_TRANSLATE_NOOP("SurfacePage", "Measured table"),
     QT_TRANSLATE_NOOP(
         "SurfacePage",
         "Emissivity is 1 minus the reflectance of the table and the transmissivity.")}};

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
    const auto& fields = irsg::fieldsOfSurfaceModel(material.surfaceModel);
    return std::ranges::find(fields, std::string(key)) != fields.end();
}

/// What a model lacks, as its error names it.
QString lackOf(const irsg::InputError& error) {
    const std::string& key = error.diagnostics().front().position;
    if (key == "refractiveIndex")
        return SurfacePage::tr("Shell's model needs a refractive index n above 0 at every "
                               "wavelength, and k where it absorbs. Type them above, or import "
                               "them.");
    if (key == "reflectanceTable")
        return SurfacePage::tr("There is no table yet. Import one, or start from the emissivity.");
    return sentencesOf(error).join("; ");
}

} // namespace

SurfacePage::SurfacePage(QWidget* parent) : QWidget(parent) {
    setObjectName("surfacePage");
    model_ = new QComboBox(this);
    model_->setObjectName("surfaceModel");
    model_->addItem(labelOf({}), QString());
    for (const std::string& name : irsg::surfaceModelNames())
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

    auto* spectra = new QGridLayout;
    spectra->setColumnStretch(1, 1);
    spectra->setVerticalSpacing(3);
    irsg::forEachField<irsg::Spectrum>(irsg::materialFields(), [&](const Row& row, auto) {
        if (std::string_view(row.page) != "surface")
            return;
        auto* field = new SpectrumField(row, this);
        connect(field, &SpectrumField::edited, this,
                [this, &row](const irsg::Spectrum& value, const QString& what) {
                    emit spectrumEdited(row, value, what);
                });
        connect(field, &SpectrumField::gestureEnded, this, &SurfacePage::gestureEnded);
        connect(field, &SpectrumField::opened, this, [this, &row](bool open) {
            nodesOf_ = open ? &row : nullptr;
            showNodes();
        });
        const int line = static_cast<int>(spectra_.size());
        spectra_.push_back({makeFieldLabel(row.label, this), field});
        spectra->addWidget(spectra_.back().label, line, 0);
        spectra->addWidget(field, line, 1);
    });
    nodes_ = new NodeEditor(this);
    nodes_->setObjectName("surfaceNodes");
    connect(nodes_, &NodeEditor::edited, this, [this](const Nodes& nodes, const QString& what) {
        emit spectrumEdited(*nodesOf_, spectrumOf(nodes, irsg::Spectrum::Outside::hold), what);
    });
    connect(nodes_, &NodeEditor::gestureEnded, this, &SurfacePage::gestureEnded);
    table_ = new ReflectanceEditor(this);
    connect(table_, &ReflectanceEditor::edited, this, &SurfacePage::tableEdited);
    connect(table_, &ReflectanceEditor::gestureEnded, this, &SurfacePage::gestureEnded);
    auto* import = new QPushButton(tr("Import…"), this);
    import->setObjectName("importSurface");
    import->setToolTip(tr("n and k, diffuse and volume reflectivity from a CSV of this material's "
                          "spectra, or a table of reflectance (CSV, Zemax BSDF)"));
    connect(import, &QPushButton::clicked, this, &SurfacePage::importWanted);
    top->addWidget(import, 0, 4);

    curve_ = new AngleCurve(tr("reflectance"), this);
    curve_->setObjectName("reflectanceOverAngle");
    curve_->setToolTip(tr("Directional-hemispherical reflectance against the angle from the "
                          "normal, mean over the band; dotted: emissivity"));
    ball_ = new LitBallView(this);
    auto* pictures = new QHBoxLayout;
    pictures->addWidget(curve_, 3);
    pictures->addWidget(ball_, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 10, 0, 0);
    column->setSpacing(5);
    column->addLayout(top);
    column->addLayout(form);
    column->addLayout(spectra);
    column->addWidget(nodes_, 1);
    column->addWidget(table_, 1);
    column->addLayout(pictures, 1);
}

void SurfacePage::showNodes() {
    for (const SpectrumLine& line : spectra_)
        line.field->setOpen(&line.field->row() == nodesOf_);
    nodes_->setVisible(nodesOf_ != nullptr);
    // Beside open nodes there is room for what they make of the curve and the ball alone.
    for (const SpectrumLine& line : spectra_) {
        const Row& row = line.field->row();
        const bool isSeen = takes(material_, row.key) && (nodesOf_ == nullptr || nodesOf_ == &row);
        line.field->setVisible(isSeen);
        line.label->setVisible(isSeen);
    }
    numbers_->showOnly(
        [&](const Row& row) { return nodesOf_ == nullptr && takes(material_, row.key); });
    if (nodesOf_ == nullptr)
        return;
    const auto line = std::ranges::find(
        spectra_, nodesOf_, [](const SpectrumLine& each) { return &each.field->row(); });
    nodes_->setRules(line->field->rules());
    nodes_->plot()->setLeastView(
        Interval{std::max(0.2, band_.min_um - 0.5), band_.max_um + 0.5},
        Interval{0.0, std::max(1.0, (material_.*nodesOf_->as<irsg::Spectrum>()).maximum())});
    nodes_->setNodes(gui::nodesOf(material_.*nodesOf_->as<irsg::Spectrum>()));
}

void SurfacePage::show(const irsg::Material& material, const irsg::SpectralRange& band) {
    material_ = material;
    band_ = band;
    for (const SpectrumLine& line : spectra_) {
        const Row& row = line.field->row();
        const irsg::Spectrum& value = material.*row.as<irsg::Spectrum>();
        line.field->show(value, band);
        if (&row == nodesOf_ && (!takes(material, row.key) || value.isConstant()))
            nodesOf_ = nullptr;
    }
    showNodes();
    table_->show(material, band);
    table_->setVisible(takes(material, "reflectanceTable"));
    numbers_->show(material);
    model_->setCurrentIndex(
        std::max(0, model_->findData(QString::fromStdString(material.surfaceModel))));
    model_->setToolTip(tr("With a model the sun glints, sky and ground are mirrored, emissivity "
                          "follows the angle, and N has no effect. %1")
                           .arg(helpOf(material.surfaceModel)));
    ball_->show(material, band);
    const irsg::Spectrum* through[] = {&material.transmissivity};
    const double t = irsg::integrateProduct(through, band) / band.width_um();
    try {
        // Kirchhoff: what is neither reflected nor let through is emitted.
        const auto reflectance = [&](double cosine) {
            return irsg::bandReflectance(material, cosine, band);
        };
        curve_->show(reflectance, {[&](double cosine) { return 1.0 - t - reflectance(cosine); }});
    } catch (const irsg::InputError& error) {
        curve_->clear(lackOf(error));
    }
}

} // namespace smat::gui

#include "moc_SurfacePage.cpp"
