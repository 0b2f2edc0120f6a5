#include "gui/tools/DetectionPage.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/analysis/SummaryText.h"
#include "gui/tools/DetectionCasesBox.h"
#include "gui/tools/DetectionPlot.h"
#include "gui/tools/SensorChooser.h"
#include "gui/widgets/NotesArea.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

struct BoxRange {
    double least, most, value;
    int decimals;
};

RealBox* boxOf(const char* name, const QString& unit, const BoxRange& range, QWidget* parent) {
    auto* box = new RealBox(name, unit, parent);
    box->setDecimals(range.decimals);
    box->setRange(range.least, range.most);
    box->setValue(range.value);
    return box;
}

QFormLayout* formOf(QGroupBox* box) {
    auto* form = new QFormLayout(box);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setVerticalSpacing(3);
    return form;
}

} // namespace

DetectionPage::DetectionPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : ToolPage(workbench, std::move(dialogs), tr("Detection range"), parent) {
    setObjectName("detectionPage");
    QWidget* form = makeForm();
    QWidget* right = makeRight();
    connect(sensors_, &SensorChooser::changed, this, &DetectionPage::refresh);
    for (QComboBox* box : {criterion_, task_, place_, thresholdBy_, clutterBy_})
        connect(box, &QComboBox::currentIndexChanged, this, &DetectionPage::refresh);
    for (RealBox* box : {snr_, falseAlarms_, clutter_, pointProbability_, probability_,
                         sceneContrast_, nearest_, farthest_, background_, step_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &DetectionPage::refresh);
    connect(cases_, &DetectionCasesBox::changed, this, &DetectionPage::refresh);
    connect(sensitivity_, &QCheckBox::toggled, this, &DetectionPage::refresh);
    connect(leftOut_->menu(), &QMenu::aboutToShow, this, &DetectionPage::fillLeftOut);
    layOut(form, 340, tr("Stops and keeps the aspects that are done"), right);
}

QWidget* DetectionPage::makeForm() {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 6, 10, 6);
    column->addWidget(makeSensorBox(panel));
    column->addWidget(makeCriterionBox(panel));
    cases_ = new DetectionCasesBox(panel);
    column->addWidget(cases_);
    column->addWidget(makePlaceBox(panel));
    column->addStretch();
    return panel;
}

QWidget* DetectionPage::makeSensorBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("Sensor"), parent);
    auto* column = new QVBoxLayout(box);
    sensors_ = new SensorChooser(dialogs_, box);
    column->addWidget(sensors_);
    return box;
}

QWidget* DetectionPage::makeCriterionBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("Detection criterion"), parent);
    criteria_ = formOf(box);
    criterion_ = new QComboBox(box);
    criterion_->setObjectName("criterion");
    criterion_->addItem(tr("its signal exceeds the noise"),
                        static_cast<int>(RangeCriterion::point));
    criterion_->addItem(tr("its shape is resolved (Johnson)"),
                        static_cast<int>(RangeCriterion::bars));
    criterion_->addItem(tr("its shape is resolved (TTP)"),
                        static_cast<int>(RangeCriterion::targeting));
    criterion_->setToolTip(
        tr("A small target is a point whose radiation all falls into one pixel. A large one must "
           "be resolved: its mean contrast decides how many cycles across it are seen."));
    snr_ = boxOf("snr", {}, {0.01, 1e6, 5.0, 2}, box);
    thresholdBy_ = new QComboBox(box);
    thresholdBy_->setObjectName("thresholdBy");
    thresholdBy_->addItem(tr("a signal to noise ratio"));
    thresholdBy_->addItem(tr("a rate of false alarms"));
    falseAlarms_ = boxOf("falseAlarms", {}, {-12.0, -0.31, -6.0, 2}, box);
    falseAlarms_->setPrefix(tr("10^"));
    falseAlarms_->setToolTip(
        tr("Probability that noise alone exceeds the threshold in one pixel of one frame"));
    pointProbability_ = boxOf("pointProbability", "%", {0.0, 99.9, 0.0, 1}, box);
    pointProbability_->setSpecialValueText(tr("not required"));
    pointProbability_->setToolTip(
        tr("Probability that the signal with its noise exceeds the threshold, averaged over all "
           "positions of the image within a pixel"));
    clutterBy_ = new QComboBox(box);
    clutterBy_->setObjectName("clutterBy");
    clutterBy_->addItem(tr("none"));
    clutterBy_->addItem(tr("a number"));
    clutterBy_->addItem(tr("that of the background"));
    clutterBy_->setToolTip(tr("The background's changes from pixel to pixel, which count as noise: "
                              "a number, or those of the rendered background beside the target"));
    clutter_ = boxOf("clutter", "K", {0.001, 1000.0, 0.1, 3}, box);
    place_ = new QComboBox(box);
    place_->setObjectName("pointPlace");
    place_->addItem(tr("in the middle of a pixel"), static_cast<int>(PointPlace::centre));
    place_->addItem(tr("anywhere (mean)"), static_cast<int>(PointPlace::mean));
    place_->addItem(tr("where four pixels meet"), static_cast<int>(PointPlace::corner));
    task_ = new QComboBox(box);
    task_->setObjectName("task");
    for (const std::string& task : rangeTaskWords())
        task_->addItem(textOf(task)); // with its cycles, see refreshed()
    probability_ = boxOf("probability", "%", {0.1, 99.9, 50.0, 1}, box);
    criteria_->addRow(criterion_);
    criteria_->addRow(tr("Threshold by"), thresholdBy_);
    criteria_->addRow(tr("Signal to noise ratio"), snr_);
    criteria_->addRow(tr("False alarms"), falseAlarms_);
    criteria_->addRow(tr("Detected with"), pointProbability_);
    criteria_->addRow(tr("Clutter"), clutterBy_);
    criteria_->addRow(tr("Standard deviation"), clutter_);
    criteria_->addRow(tr("Position in pixel"), place_);
    criteria_->addRow(tr("Task"), task_);
    criteria_->addRow(tr("Probability"), probability_);
    sceneContrast_ =
        boxOf("sceneContrast", "K", {0.01, 1e4, irsg::SensorDisplay().sceneContrast_K, 2}, box);
    sceneContrast_->setToolTip(tr("Temperature difference that the display shows from black to "
                                  "white"));
    criteria_->addRow(tr("Scene contrast"), sceneContrast_);
    leftOut_ = menuButton({}, "leftOut",
                          tr("Surfaces with these temperatures and materials are not counted, such "
                             "as hot parts and plumes that are not resolved"));
    criteria_->addRow(tr("Left out"), leftOut_);
    return box;
}

QWidget* DetectionPage::makePlaceBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("Search"), parent);
    QFormLayout* form = places_ = formOf(box);
    step_ = boxOf("aspectStep", tr("°"), {0.1, 90.0, 10.0, 3}, box);
    step_->setToolTip(tr("Between two aspects. Type, elevation and sector are those of the "
                         "project's polar plot; directions are those of its signature table."));
    nearest_ = boxOf("nearest", "m", {0.1, 1e9, 100.0, 1}, box);
    farthest_ = boxOf("farthest", "m", {0.1, 1e9, 1e6, 1}, box);
    background_ = boxOf("backgroundTemperature", "K", {0.0, 5000.0, 0.0, 2}, box);
    background_->setSpecialValueText(tr("that of the scene"));
    background_->setToolTip(tr("Temperature of the background whose photons cause noise"));
    form->addRow(tr("Step"), step_);
    form->addRow(tr("Nearest range"), nearest_);
    form->addRow(tr("Farthest range"), farthest_);
    form->addRow(tr("Background"), background_);
    sensitivity_ = new QCheckBox(tr("Sensitivity of the range"), box);
    sensitivity_->setObjectName("sensitivity");
    sensitivity_->setToolTip(
        tr("Relative change of the range per relative change of each number of "
           "the sensor, of the extinction, and of the target"));
    form->addRow(sensitivity_);
    return box;
}

QWidget* DetectionPage::makeRight() {
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    plot_ = new DetectionPlot(dialogs_, right);
    summary_ = new QLabel(right);
    summary_->setObjectName("summary");
    summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    summary_->setContentsMargins(12, 6, 12, 8);
    summary_->setText(
        tr("After a run, the range at which the sensor just detects the target is shown here."));
    column->addWidget(plot_, 1);
    column->addWidget(new NotesArea(summary_, 110, right));
    return right;
}

const PlotPanel& DetectionPage::plot() const {
    return plot_->plot();
}

const TablePanel* DetectionPage::table() const {
    return plot_->table();
}

const Exportable& DetectionPage::content() const {
    return *plot_;
}

DetectionRequest DetectionPage::request() const {
    if (!sensors_->sensor())
        throw irsg::InputError({"", tr("Sensor").toStdString(), "nothing", "a sensor"});
    DetectionRequest request;
    request.sensor = *sensors_->sensor();
    request.sensorFile = sensors_->file();
    request.criterion = static_cast<RangeCriterion>(criterion_->currentData().toInt());
    const bool isPoint = request.criterion == RangeCriterion::point;
    request.threshold = thresholdBy_->currentIndex() == 0
                            ? snr_->value()
                            : thresholdOfFalseAlarms(std::pow(10.0, falseAlarms_->value()));
    cases_->fill(request);
    if (isPoint && cases_->seeksRange() && pointProbability_->value() > 0.0)
        request.pointProbability = 0.01 * pointProbability_->value();
    if (isPoint && clutterBy_->currentIndex() == 1)
        request.clutter_K = clutter_->value();
    request.measuresClutter = isPoint && clutterBy_->currentIndex() == 2;
    if (!isPoint)
        request.leftOut = leftOutNames_;
    request.findsSensitivity = cases_->isByCase() && sensitivity_->isChecked();
    request.place = static_cast<PointPlace>(place_->currentData().toInt());
    request.task = {
        tasksOf(request.criterion)[static_cast<std::size_t>(task_->currentIndex())].cyclesOfHalf,
        cases_->seeksRange() ? 0.01 * probability_->value() : 0.5};
    request.display.sceneContrast_K = sceneContrast_->value();
    if (cases_->seeksRange()) {
        request.limits.nearest_m = nearest_->value();
        request.limits.farthest_m = farthest_->value();
    }
    if (request.limits.farthest_m <= request.limits.nearest_m)
        throw irsg::InputError({"", tr("Farthest range").toStdString(),
                                farthest_->text().toStdString(), "a range beyond the nearest"});
    if (background_->value() > 0.0)
        request.background_K = background_->value();
    return request;
}

AnalysisData DetectionPage::asked() const {
    AnalysisData data;
    data.kind = detectionKind();
    data.name = name(data.kind);
    data.project = workbench_.project();
    data.settings = workbench_.editedProject().settings;
    data.settings.set(key::polarStep, step_->value());
    data.commandLine = detectionCommand(data.project, data.settings, request(), "detection.csv");
    return data;
}

QStringList DetectionPage::problems() const {
    if (!sensors_->problem().isEmpty())
        return {sensors_->problem()};
    try {
        const AnalysisData data = asked();
        planAnalysis(kindOf(cases_->cases()), data.project, data.settings);
    } catch (const irsg::InputError& error) {
        return sentencesOf(error);
    }
    return {};
}

QString DetectionPage::command() const {
    return QString::fromStdString(asked().commandLine);
}

void DetectionPage::refreshed(bool) {
    const auto criterion = static_cast<RangeCriterion>(criterion_->currentData().toInt());
    const bool isPoint = criterion == RangeCriterion::point;
    const std::vector<irsg::JohnsonTask>& tasks = tasksOf(criterion);
    for (int i = 0; i < task_->count(); ++i) {
        const irsg::JohnsonTask& task = tasks[static_cast<std::size_t>(i)];
        task_->setItemText(i, tr("%1: %2 cycles").arg(tr(task.name)).arg(task.cyclesOfHalf));
    }
    criteria_->setRowVisible(sceneContrast_, criterion == RangeCriterion::targeting);
    for (QWidget* field : std::initializer_list<QWidget*>{thresholdBy_, clutterBy_, place_})
        criteria_->setRowVisible(field, isPoint);
    criteria_->setRowVisible(pointProbability_, isPoint && cases_->seeksRange());
    criteria_->setRowVisible(snr_, isPoint && thresholdBy_->currentIndex() == 0);
    criteria_->setRowVisible(falseAlarms_, isPoint && thresholdBy_->currentIndex() == 1);
    criteria_->setRowVisible(clutter_, isPoint && clutterBy_->currentIndex() == 1);
    for (QWidget* field : std::initializer_list<QWidget*>{task_, leftOut_})
        criteria_->setRowVisible(field, !isPoint);
    criteria_->setRowVisible(probability_, !isPoint && cases_->seeksRange());
    places_->setRowVisible(step_, cases_->cases() == RangeCases::aspects);
    for (QWidget* field : std::initializer_list<QWidget*>{nearest_, farthest_})
        places_->setRowVisible(field, cases_->seeksRange());
    places_->setRowVisible(sensitivity_, cases_->isByCase());
    QStringList names;
    for (const std::string& name : leftOutNames_)
        names << QString::fromStdString(name);
    leftOut_->setText(names.isEmpty() ? tr("nothing") : names.join(", "));
}

void DetectionPage::fillLeftOut() {
    QMenu& menu = *leftOut_->menu();
    menu.clear();
    const auto add = [&](const std::string& name) {
        if (name.empty())
            return;
        QAction* action = menu.addAction(QString::fromStdString(name).replace("&", "&&"));
        action->setCheckable(true);
        action->setChecked(std::ranges::find(leftOutNames_, name) != leftOutNames_.end());
        connect(action, &QAction::toggled, this, [this, name](bool on) {
            std::erase(leftOutNames_, name);
            if (on)
                leftOutNames_.push_back(name);
            refresh();
        });
    };
    if (workbench_.database().isOpen()) {
        menu.addSection(tr("Temperatures"));
        for (const auto& [index, entry] : workbench_.database().value().temperatures)
            add(entry.name);
        menu.addSection(tr("Materials"));
        for (const auto& [index, entry] : workbench_.database().value().materials)
            add(entry.name);
    }
    if (menu.actions().isEmpty())
        menu.addAction(tr("the project has no signature database"))->setEnabled(false);
}

int DetectionPage::start() {
    return workbench_.start(asked(), request(), this);
}

QString DetectionPage::progressText(const Progress& progress) const {
    return tr("%1 of %2 aspects").arg(progress.done).arg(progress.total);
}

QString DetectionPage::cancelText() const {
    return tr("cancelling; the cases done so far are shown in a moment");
}

void DetectionPage::showResult(const JobResult& result) {
    if (!result.data)
        return;
    result_ = result.data;
    plot_->setResult(result_);
    setProgress(1000, tr("%1 rows in %2 s")
                          .arg(result_->table.rowCount())
                          .arg(sentenceNumber(result_->elapsed_s, 3)));
    QStringList lines;
    const QString sensitivity = tr("Sensitivity of the range to: ");
    QStringList sensitivities;
    for (const SummaryItem& item : result_->summary) {
        const QString line = summaryLine(item);
        if (line.startsWith(sensitivity))
            sensitivities << line.mid(sensitivity.size());
        else
            lines << line;
    }
    // The largest come first; the others are quantities of the plot as well.
    constexpr qsizetype shown = 6;
    if (!sensitivities.isEmpty())
        lines << sensitivity + sensitivities.mid(0, shown).join(", ");
    for (const std::string& warning : result_->warnings)
        lines << tr("note: %1").arg(QString::fromStdString(warning));
    summary_->setText(lines.join('\n'));
}

} // namespace smat::gui

#include "moc_DetectionPage.cpp"
