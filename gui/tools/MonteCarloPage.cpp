#include "gui/tools/MonteCarloPage.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "gui/analysis/MonteCarloPlots.h"
#include "gui/analysis/SummaryText.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/NotesArea.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/NumberText.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisDefinition.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

/// "temperature 5 (exhaust pipes)", as the ranking calls it.
QString nameOfScale(const irsg::SignatureDatabase* database, irsg::ScalingKind kind, int index) {
    const bool isTemperature = kind == irsg::ScalingKind::temperature;
    std::string name;
    if (database != nullptr && isTemperature && database->temperatures.contains(index))
        name = database->temperatures.at(index).name;
    if (database != nullptr && !isTemperature && database->materials.contains(index))
        name = database->materials.at(index).name;
    const QString number = isTemperature ? MonteCarloPage::tr("temperature %1").arg(index)
                                         : MonteCarloPage::tr("emissivity %1").arg(index);
    return name.empty() ? number
                        : number + QStringLiteral(" (%1)").arg(QString::fromStdString(name));
}

} // namespace

MonteCarloPage::MonteCarloPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : ToolPage(workbench, std::move(dialogs), tr("Monte Carlo"), parent) {
    setObjectName("monteCarloPage");
    QWidget* form = makeForm();
    auto* right = new QWidget(this);
    auto* rightColumn = new QVBoxLayout(right);
    rightColumn->setContentsMargins(0, 0, 0, 0);
    plots_ = new MonteCarloPlots(right);
    summary_ = new QLabel(right);
    summary_->setObjectName("summary");
    summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    summary_->setContentsMargins(12, 6, 12, 8);
    notes_ = new NotesArea(summary_, 110, right);
    notes_->hide();
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, this,
            &MonteCarloPage::summarize);
    rightColumn->addWidget(plots_, 1);
    rightColumn->addWidget(notes_);

    connect(write_, &QPushButton::clicked, this, &MonteCarloPage::writeScalingFiles);
    for (QComboBox* box : {analysis_, quantity_, sequence_, statistic_})
        connect(box, &QComboBox::currentIndexChanged, this, &MonteCarloPage::refresh);
    for (QSpinBox* box : {samples_, seed_, subpixelShifts_, pairs_})
        connect(box, &QSpinBox::valueChanged, this, &MonteCarloPage::refresh);
    for (QCheckBox* box : {stops_, ranks_})
        connect(box, &QCheckBox::toggled, this, &MonteCarloPage::refresh);
    connect(standardError_, &QDoubleSpinBox::valueChanged, this, &MonteCarloPage::refresh);
    connect(percentiles_, &QLineEdit::textChanged, this, &MonteCarloPage::refresh);
    connect(&workbench_.database(), &DatabaseSession::stateChanged, this, &MonteCarloPage::refresh);
    layOut(form, 360, tr("Stops and keeps the draws made so far"), right);
}

void MonteCarloPage::reload() {
    fillAnalyses();
    fillScales();
    refresh();
}

void MonteCarloPage::fillAnalyses() {
    const QSignalBlocker quiet(analysis_);
    const QString kept = analysis_->currentData().toString();
    analysis_->clear();
    if (!workbench_.hasProject())
        return;
    for (const NamedAnalysis& one : workbench_.project().analyses)
        if (one.kind->form != AnalysisForm::image)
            analysis_->addItem(QString::fromStdString(one.name + " (" + name(one.kind) + ")"),
                               "analysis:" + QString::fromStdString(one.name));
    for (const AnalysisKind kind : allAnalysisKinds())
        if (kind->form != AnalysisForm::image)
            analysis_->addItem(tr("%1 (project)").arg(QString::fromStdString(title(kind))),
                               "kind:" + QString::fromStdString(name(kind)));
    analysis_->setCurrentIndex(std::max(analysis_->findData(kept), 0));
}

std::shared_ptr<const irsg::SignatureDatabase>
MonteCarloPage::databaseOf(const ProjectModel& model) const {
    if (model.database.empty())
        return nullptr;
    try {
        SceneBuilder scenes;
        scenes.setDatabaseOverrides(workbench_.editedDatabases());
        return scenes.database(workbench_.project().resolve(model.database));
    } catch (const irsg::InputError&) {
        return nullptr; // told where it is opened; the indices have numbers
    }
}

void MonteCarloPage::fillScales() {
    scales_->clear();
    if (!workbench_.hasProject()) {
        scales_->hide();
        scalesNote_->setText(tr("Open a project to see its scales."));
        scalesNote_->show();
        write_->setEnabled(false);
        return;
    }
    bool anyMissing = false, anyFile = false;
    QStringList notes;
    for (const ProjectModel& one : workbench_.project().models) {
        const std::filesystem::path model = workbench_.project().resolve(one.file);
        anyFile = anyFile || irsg::hasScalingFiles(model);
        for (const irsg::ScalingKind kind :
             {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity})
            anyMissing = anyMissing || !std::filesystem::exists(irsg::scalingFile(model, kind));
        try {
            const irsg::Scalings scalings = irsg::loadScalings(model);
            const auto database = databaseOf(one);
            for (const irsg::ScalingKind kind :
                 {irsg::ScalingKind::temperature, irsg::ScalingKind::emissivity})
                for (const auto& [index, entry] : scalings.of(kind)) {
                    const irsg::Distribution& d = entry.distribution;
                    const QString what = nameOfScale(database.get(), kind, index);
                    auto* row = new QTreeWidgetItem(scales_);
                    row->setText(0, what);
                    row->setToolTip(0, QString::fromStdString(entry.documentation));
                    row->setText(1, d.isFixed() ? tr("fixed")
                                                : QString::fromUtf8(irsg::info(d.kind()).name));
                    row->setText(2, d.isFixed() ? formattedNumber(d.minimum())
                                                : formattedNumber(d.minimum()) + " – " +
                                                      formattedNumber(d.maximum()));
                    row->setDisabled(d.isFixed());
                }
        } catch (const irsg::InputError& error) {
            notes << sentencesOf(error);
        }
    }
    if (!anyFile)
        notes << tr("No scaling files lie beside the model yet.");
    scales_->setVisible(scales_->topLevelItemCount() > 0);
    scalesNote_->setText(notes.join('\n'));
    scalesNote_->setVisible(!notes.isEmpty());
    write_->setEnabled(anyMissing);
    write_->setVisible(anyMissing);
}

void MonteCarloPage::writeScalingFiles() {
    try {
        SceneBuilder scenes;
        scenes.setDatabaseOverrides(workbench_.editedDatabases());
        for (const ProjectModel& one : workbench_.project().models)
            if (!one.database.empty())
                irsg::createScalingFiles(
                    workbench_.project().resolve(one.file),
                    *scenes.database(workbench_.project().resolve(one.database)));
    } catch (const irsg::InputError& error) {
        QStringList sentences = sentencesOf(error);
        if (isOfSample(error.diagnostics().front().file))
            sentences << tr("Save the project with copies of its files first: File, Save project "
                            "as….");
        dialogs_.tell(this, tr("The scaling files cannot be written"), sentences);
    }
    fillScales();
    refresh();
}

MonteCarloData MonteCarloPage::asked() const {
    MonteCarloData data;
    const QString word = analysis_->currentData().toString();
    const std::string after = word.section(':', 1).toStdString();
    const Project project = workbench_.editedProject();
    if (word.startsWith("analysis:"))
        data.analysis = AnalysisData::of(project, after);
    else if (const auto kind = analysisKindFromName(after))
        data.analysis = AnalysisData::of(project, *kind);
    else
        throw irsg::InputError({"", tr("Analysis").toStdString(), "nothing", "an analysis"});
    // Its command tells what differs from the file.
    data.analysis.project = workbench_.project();
    data.analysis.settings.set(key::scalingSeed, seed_->value());

    MonteCarloOptions& options = data.options;
    options.samples = static_cast<std::size_t>(samples_->value());
    options.sequence = sequence_->currentData().toString() == "plain" ? RealisationSequence::plain
                                                                      : RealisationSequence::sobol;
    options.quantity = *monteCarloQuantity(quantity_->currentData().toString().toStdString());
    options.statistic = *statisticFromName(statistic_->currentData().toString().toStdString());
    if (stops_->isChecked())
        options.standardError = standardError_->value() / 100.0;
    options.subpixelShifts = subpixelShifts_->value();
    options.ranking = ranks_->isChecked();
    options.rankingPairs = static_cast<std::size_t>(pairs_->value());
    options.percentiles.clear();
    const QString list = percentiles_->text();
    const QChar separator = list.contains(';') ? ';' : ',';
    for (const QString& part : list.split(separator, Qt::SkipEmptyParts)) {
        const auto percent = typedNumber(part, "%").value;
        if (!percent)
            throw irsg::InputError({"", tr("Percentiles").toStdString(),
                                    part.trimmed().toStdString(),
                                    "numbers separated by commas, or by semicolons"});
        options.percentiles.push_back(*percent);
    }
    options.check();
    return data;
}

QStringList MonteCarloPage::problems() const {
    QStringList problems;
    try {
        const AnalysisData analysis = asked().analysis;
        planAnalysis(analysis.kind, analysis.project, analysis.settings);
    } catch (const irsg::InputError& error) {
        problems << sentencesOf(error);
    }
    if (scales_->topLevelItemCount() == 0)
        problems << tr("There are no scales to draw.");
    return problems;
}

QString MonteCarloPage::command() const {
    return QString::fromStdString(asked().equivalentCommand("montecarlo.csv"));
}

void MonteCarloPage::refreshed(bool) {
    standardError_->setEnabled(stops_->isChecked());
    pairs_->setEnabled(ranks_->isChecked());
}

int MonteCarloPage::start() {
    MonteCarloData data = asked();
    data.analysis.commandLine = data.equivalentCommand("montecarlo.csv");
    return workbench_.start(data, this);
}

QString MonteCarloPage::progressText(const Progress& progress) const {
    return QString::fromStdString(progress.what);
}

QString MonteCarloPage::cancelText() const {
    return tr("cancelling; the draws made so far are shown in a moment");
}

void MonteCarloPage::showResult(const JobResult& result) {
    if (!result.monteCarlo)
        return;
    const MonteCarloData& data = *result.monteCarlo;
    setProgress(1000, tr("%1 draws in %2 s")
                          .arg(data.realisations())
                          .arg(sentenceNumber(data.analysis.elapsed_s, 3)));
    plots_->setData(data);
    items_ = data.analysis.summary;
    warnings_ = data.analysis.warnings;
    summarize();
    notes_->show();
    refresh();
}

void MonteCarloPage::summarize() {
    QStringList lines;
    for (const SummaryItem& item : items_)
        if (item.label.find("index of") == std::string::npos)
            lines << summaryLine(item);
    for (const std::string& warning : warnings_)
        lines << tr("note: %1").arg(QString::fromStdString(warning));
    summary_->setText(lines.join(" · "));
}

const Exportable& MonteCarloPage::content() const {
    return *plots_;
}

} // namespace smat::gui

#include "moc_MonteCarloPage.cpp"
