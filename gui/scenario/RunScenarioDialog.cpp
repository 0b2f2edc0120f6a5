#include "gui/scenario/RunScenarioDialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/scenario/ScenarioDocument.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/DialogButtons.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/image/ImageFormat.h"
#include "smatcore/support/ShellText.h"

namespace smat::gui {
namespace {

/// "flyby-frames" beside the scenario.
std::filesystem::path usualFolder(const Scenario& scenario) {
    const std::filesystem::path own = ownPlaceOf(scenario.file);
    return own.parent_path() / (own.stem().string() + "-frames");
}

bool areAllOn(const std::vector<QCheckBox*>& boxes) {
    return std::ranges::all_of(boxes, [](const QCheckBox* box) { return box->isChecked(); });
}

bool isAnyOn(const std::vector<QCheckBox*>& boxes) {
    return std::ranges::any_of(boxes, [](const QCheckBox* box) { return box->isChecked(); });
}

} // namespace

RunScenarioDialog::RunScenarioDialog(const EditedScenario& scenario, bool isSaved, Dialogs& dialogs,
                                     QWidget* parent)
    : QDialog(parent), scenario_(scenario), isSaved_(isSaved) {
    setObjectName("runScenarioDialog");
    setWindowTitle(tr("Write the frames of a scenario"));
    resize(560, 300);
    folder_ = new QLineEdit(textOf(usualFolder(scenario.scenario)), this);
    folder_->setObjectName("folder");
    auto* browse = new QToolButton(this);
    browse->setObjectName("browseFolder");
    browse->setText(tr("Browse…"));
    browse->setFocusPolicy(Qt::StrongFocus);
    connect(browse, &QToolButton::clicked, this, [this, &dialogs] {
        const QString chosen =
            dialogs.chooseFolder(this, tr("Folder for frames and tables"), folder_->text());
        if (!chosen.isEmpty())
            folder_->setText(chosen);
    });
    auto* place = new QHBoxLayout;
    place->addWidget(folder_, 1);
    place->addWidget(browse);

    auto* sensors = new QVBoxLayout;
    for (const ScenarioSensor& sensor : scenario.scenario.sensors) {
        auto* box = new QCheckBox(textOf(sensor.name), this);
        box->setObjectName("sensor-" + textOf(sensor.name));
        box->setChecked(true);
        sensors->addWidget(box);
        sensors_.push_back(box);
    }
    auto* forms = new QHBoxLayout;
    forms->setSpacing(14);
    for (const irsg::ImageFormat* format : irsg::imageFormats()) {
        const QString name = QString::fromUtf8(format->shortName);
        const QString extension = textOf(format->extensionList().front());
        const bool isPicture = format->keeps == irsg::ImageFormat::Keeps::picture;
        auto* box = new QCheckBox(isPicture ? tr("Pictures (%1)").arg(name) : name, this);
        box->setObjectName("form" + extension);
        box->setProperty("extension", extension);
        box->setChecked(forms_.empty());
        forms->addWidget(box);
        forms_.push_back(box);
    }
    forms->addStretch(1);
    command_ = new QLineEdit(this);
    command_->setObjectName("commandLine");
    command_->setReadOnly(true);
    command_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    problem_ = new QLabel(this);
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    problem_->setForegroundRole(QPalette::PlaceholderText);

    auto* form = new QFormLayout;
    form->setHorizontalSpacing(14);
    form->setVerticalSpacing(10);
    auto* named = new QLabel(tr("&Folder"), this);
    named->setBuddy(folder_);
    form->addRow(named, place);
    form->addRow(tr("Sensors"), sensors);
    form->addRow(tr("Frames as"), forms);
    form->addRow(tr("Equivalent command"), command_);
    auto* buttons = okAndCancel(*this, tr("Write"));
    run_ = buttons->button(QDialogButtonBox::Ok);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 18, 20, 14);
    column->setSpacing(12);
    column->addLayout(form);
    column->addWidget(problem_);
    column->addStretch(1);
    column->addWidget(buttons);
    connect(folder_, &QLineEdit::textChanged, this, &RunScenarioDialog::refresh);
    for (const auto* boxes : {&sensors_, &forms_})
        for (QCheckBox* box : *boxes)
            connect(box, &QCheckBox::toggled, this, &RunScenarioDialog::refresh);
    refresh();
}

void RunScenarioDialog::refresh() {
    QString problem;
    try {
        requireOwnPlace(folder_->text().toStdString());
    } catch (const irsg::InputError& error) {
        problem = sentencesOf(error).join(' ');
    }
    if (folder_->text().trimmed().isEmpty())
        problem = tr("Choose a folder.");
    else if (!isAnyOn(sensors_))
        problem = tr("Choose at least one of the sensors.");
    else if (!isAnyOn(forms_))
        problem = tr("Choose at least one form of the frames.");
    run_->setEnabled(problem.isEmpty());
    command_->setText(isSaved_ ? textOf(commandLine())
                               : tr("save the scenario first: the command reads its file"));
    problem_->setText(problem);
    problem_->setVisible(!problem.isEmpty());
}

std::string RunScenarioDialog::commandLine() const {
    std::string line = "smat-batch simulate " + shellQuoted(scenario_.scenario.file.string()) +
                       " --out " + shellQuoted(folder_->text().toStdString());
    if (!areAllOn(sensors_))
        for (const QCheckBox* box : sensors_)
            if (box->isChecked())
                line += " --sensor " + shellQuoted(box->text().toStdString());
    // OpenEXR alone is what it does unasked.
    if (order().extensions != std::vector<std::string>{".exr"})
        for (const std::string& extension : order().extensions)
            line += " --format " + extension.substr(1);
    return line;
}

SimulationJob RunScenarioDialog::order() const {
    SimulationJob order{.scenario = scenario_.scenario,
                        .trajectories = scenario_.trajectories,
                        .request = {},
                        .folder = folder_->text().toStdString(),
                        .extensions = {},
                        .commandLine = isSaved_ ? command_->text().toStdString() : ""};
    if (!areAllOn(sensors_))
        for (const QCheckBox* box : sensors_)
            if (box->isChecked())
                order.request.sensors.push_back(box->text().toStdString());
    for (const QCheckBox* box : forms_)
        if (box->isChecked())
            order.extensions.push_back(box->property("extension").toString().toStdString());
    return order;
}

} // namespace smat::gui

#include "moc_RunScenarioDialog.cpp"
