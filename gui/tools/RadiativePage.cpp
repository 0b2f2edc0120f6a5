#include "gui/tools/RadiativePage.h"

#include <algorithm>

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/settings/SettingForm.h"
#include "gui/tools/TargetPoint.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/radiometry/Band.h"
#include "smatcore/project/EnvironmentInput.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/tools/RadiativeOutput.h"
#include "smatcore/tools/ViewerGeometry.h"

namespace smat::gui {
namespace {

const std::vector<std::string> formKeys = {key::targetAltitude,
                                           key::cameraRange,
                                           key::cameraAzimuth,
                                           key::cameraElevation,
                                           key::targetYaw,
                                           key::sensorBand,
                                           key::environmentSunAzimuth,
                                           key::environmentSunElevation,
                                           key::environmentDayOfYear,
                                           key::environmentAtmospheres};

QString figuresOf(const RadiativeOutput& output) {
    QStringList lines;
    for (const auto& item : output.summary) {
        QString label = QString::fromStdString(item.label).replace('_', ' ');
        label.replace(0, 1, label.left(1).toUpper());
        lines << QStringLiteral("%1: %2 %3")
                     .arg(label)
                     .arg(item.value, 0, 'g', 6)
                     .arg(formattedUnit(item.unit))
                     .trimmed();
    }
    for (const auto& warning : output.warnings)
        lines << RadiativePage::tr("Note: %1").arg(QString::fromStdString(warning));
    return lines.join('\n');
}

/// The air is asked in one band at a time, of several in the first.
irsg::SpectralRange firstBand(const Settings& asked) {
    return irsg::Band::fromText(eachBand(asked).front().text(key::sensorBand)).range();
}

std::string commandFor(const Project& project, const Settings& asked,
                       const std::vector<std::string>& words, const PathGeometryInput& geometry,
                       const std::vector<double>& referenceDistances_m = {}) {
    return radiativeCommand(resolvedAtmosphere(project, asked), words, geometry, firstBand(asked),
                            sunOf(project, asked), asked[key::environmentDayOfYear],
                            "radiative.csv", referenceDistances_m);
}

} // namespace

RadiativePage::RadiativePage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : AtmosphereToolPage(workbench, std::move(dialogs), parent),
      targetPoint_(new TargetPoint(workbench, this)) {
    setObjectName("radiativePage");
    form_ = new SettingForm(
        formKeys,
        [this](const QString& title, const QString& filter) {
            return this->dialogs().openFile(this, title, {filter});
        },
        this);
    form_->layout()->setContentsMargins(0, 0, 0, 0);
    auto* take = new QPushButton(tr("Take from the project"), this);
    take->setObjectName("takeFromProject");
    take->setToolTip(tr("Camera, target, band, sun and atmosphere as the project has them now"));
    auto* asked = new QLabel(tr("Spectra"), this);
    asked->setForegroundRole(QPalette::PlaceholderText);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(14);
    grid->setVerticalSpacing(4);
    for (const RadiativeQuantity& known : radiativeQuantities()) {
        const auto& label = irsg::info(known.quantity).label;
        auto* box = new QCheckBox(
            QString::fromUtf8(label.data(), static_cast<qsizetype>(label.size())), this);
        box->setObjectName(
            QString::fromUtf8(known.word.data(), static_cast<qsizetype>(known.word.size())));
        box->setChecked(true);
        const int index = static_cast<int>(quantities_.size());
        grid->addWidget(box, index / 2, index % 2);
        connect(box, &QCheckBox::toggled, this, &RadiativePage::refresh);
        quantities_.push_back(box);
    }
    inputs()->addWidget(form_);
    inputs()->addWidget(take);
    inputs()->addWidget(asked);
    inputs()->addLayout(grid);
    auto* use = addButton(
        "useInProject", tr("Use in the project…"),
        tr("Save these spectra and put them first among the atmospheres of the "
           "project: they are then used for this geometry instead of the computed atmosphere"));
    connect(use, &QPushButton::clicked, this, &RadiativePage::useInProject);
    connect(take, &QPushButton::clicked, this, &RadiativePage::takeFromProject);
    connect(form_, &SettingForm::edited, this, &RadiativePage::refresh);
    connect(form_, &SettingForm::validityChanged, this, &RadiativePage::refresh);
    connect(targetPoint_, &TargetPoint::changed, this, &RadiativePage::refresh);
    connect(&this->workbench(), &Workbench::settingsChanged, this, &RadiativePage::refresh);
    takeFromProject();
}

void RadiativePage::takeFromProject() {
    form_->setValues(workbench().settings());
    refresh();
}

Settings RadiativePage::settings() const {
    Settings settings = workbench().settings();
    form_->writeTo(settings);
    return settings;
}

std::vector<std::string> RadiativePage::words() const {
    std::vector<std::string> words;
    for (const auto* box : quantities_)
        if (box->isChecked())
            words.push_back(box->objectName().toStdString());
    if (words.size() == quantities_.size())
        return {"all"};
    return words;
}

void RadiativePage::refresh() {
    QStringList problems = form_->problems();
    if (words().empty())
        problems << tr("Choose at least one of the spectra.");
    setProblems(problems);
    if (!problems.isEmpty())
        return;
    if (targetPoint_->isBusy() || !targetPoint_->point_m()) {
        setCommand(tr("reading the model…"));
        return;
    }
    const auto asked = settings();
    const Project& project = workbench().project();
    setCommand(QString::fromStdString(commandFor(
        project, asked, words(), viewerGeometry(project, asked, *targetPoint_->point_m()))));
}

Calculation::Work RadiativePage::work() {
    const auto project = workbench().project();
    const auto asked = settings();
    const auto words = this->words();
    return [this, project, asked, words, models = workbench().models()]() -> std::function<void()> {
        SceneBuilder scenes(ModelStore::loader(models));
        const irsg::Environment environment = environmentOf(project, asked);
        RadiativeRequest request;
        request.band = firstBand(asked);
        const irsg::Vec3 point_m = targetReferencePoint(project, scenes);
        request.geometry = viewerGeometry(project, asked, point_m);
        request.leaveOutMissing = words.front() == "all";
        for (const RadiativeQuantity& known : radiativeQuantities())
            if (request.leaveOutMissing ||
                std::find(words.begin(), words.end(), known.word) != words.end())
                request.quantities.push_back(known.property);
        request.referenceDistances_m = referenceDistancesOf_m(project, scenes);
        request.commandLine =
            commandFor(project, asked, words, request.geometry, request.referenceDistances_m);
        const auto output = radiativeOutput(environment, request);
        return [this, output, point_m, models = project.models] {
            showTable(output.table, tr("Radiative output"), figuresOf(output));
            targetPoint_->take(models, point_m);
        };
    };
}

void RadiativePage::useInProject() {
    const QString file = dialogs().saveFile(this, tr("Save the spectra as an input"),
                                            {tr("Atmospheric spectra (*.csv)")}, "air.csv");
    if (file.isEmpty())
        return;
    try {
        if (!file.endsWith(".csv", Qt::CaseInsensitive))
            throw irsg::InputError({file.toStdString(), "", "another extension", ".csv"});
        table().save(file.toStdString());
        const std::string before = workbench().settings().text(key::environmentAtmospheres);
        Settings changed = workbench().settings();
        changed.set(key::environmentAtmospheres,
                    file.toStdString() + (before == "none" || before.empty() ? "" : ";" + before));
        workbench().set(changed, tr("Use radiative output"));
    } catch (const irsg::InputError& error) {
        dialogs().tell(this, tr("These spectra cannot be used"), sentencesOf(error));
    }
}

} // namespace smat::gui

#include "moc_RadiativePage.cpp"
