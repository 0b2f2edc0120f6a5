#include "gui/tools/DetectionPage.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QVBoxLayout>

#include "gui/analysis/SummaryText.h"
#include "gui/plot/PlotPanel.h"
#include "gui/plot/PolarPlot.h"
#include "gui/plot/ResultPlot.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberBoxes.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/sensor/SensorNumbers.h"
#include "smatcore/analysis/AnalysisPlan.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {

namespace {

/// In the list of sensors: opens a file.
constexpr const char* another = "another";

/// Those that come with the program, by file name.
std::vector<std::filesystem::path> shippedSensors() {
    const std::filesystem::path folder = dataFolder("resources/sensors");
    std::vector<std::filesystem::path> files;
    if (folder.empty())
        return files;
    std::error_code failure;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
        if (entry.path().extension() == ".smatsensor")
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

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
    return form;
}

} // namespace

DetectionPage::DetectionPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : ToolPage(workbench, std::move(dialogs), tr("Detection range"), parent) {
    setObjectName("detectionPage");
    QWidget* form = makeForm();
    QWidget* right = makeRight();
    connect(sensors_, &QComboBox::activated, this, &DetectionPage::chooseSensor);
    for (QComboBox* box : {criterion_, task_, place_})
        connect(box, &QComboBox::currentIndexChanged, this, &DetectionPage::refresh);
    for (RealBox* box :
         {snr_, probability_, sceneContrast_, nearest_, farthest_, background_, step_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &DetectionPage::refresh);
    connect(quantity_, &QComboBox::activated, this, &DetectionPage::drawResult);
    describeSensor();
    layOut(form, 340, tr("Stops and keeps the aspects that are done"), right);
}

QWidget* DetectionPage::makeForm() {
    auto* panel = new QWidget(this);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(10, 10, 10, 10);
    column->addWidget(makeSensorBox(panel));
    column->addWidget(makeCriterionBox(panel));
    column->addWidget(makePlaceBox(panel));
    column->addStretch();
    return panel;
}

QWidget* DetectionPage::makeSensorBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("Sensor"), parent);
    auto* column = new QVBoxLayout(box);
    sensors_ = new QComboBox(box);
    sensors_->setObjectName("sensorFile");
    sensors_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const std::filesystem::path& file : shippedSensors())
        sensors_->addItem(QString::fromStdString(file.stem().string()),
                          QString::fromStdString(file.string()));
    sensors_->addItem(tr("A file…"), QString(another));
    sensorText_ = new QLabel(box);
    sensorText_->setObjectName("sensorText");
    sensorText_->setWordWrap(true);
    column->addWidget(sensors_);
    column->addWidget(sensorText_);
    return box;
}

QWidget* DetectionPage::makeCriterionBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("The target is seen where"), parent);
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
        tr("A small target is a point whose whole light falls into one pixel. A large one has "
           "to be resolved: its mean contrast decides how many cycles across it are seen."));
    snr_ = boxOf("snr", {}, {0.01, 1e6, 5.0, 2}, box);
    place_ = new QComboBox(box);
    place_->setObjectName("pointPlace");
    place_->addItem(tr("in the middle of a pixel"), static_cast<int>(PointPlace::centre));
    place_->addItem(tr("anywhere: its mean"), static_cast<int>(PointPlace::mean));
    place_->addItem(tr("where four pixels meet"), static_cast<int>(PointPlace::corner));
    task_ = new QComboBox(box);
    task_->setObjectName("task");
    for (const std::string& task : rangeTaskWords())
        task_->addItem(textOf(task)); // with its cycles, see refreshed()
    probability_ = boxOf("probability", "%", {0.1, 99.9, 50.0, 1}, box);
    criteria_->addRow(criterion_);
    criteria_->addRow(tr("Signal to noise ratio"), snr_);
    criteria_->addRow(tr("Image of the point"), place_);
    criteria_->addRow(tr("Task"), task_);
    criteria_->addRow(tr("Probability"), probability_);
    sceneContrast_ =
        boxOf("sceneContrast", "K", {0.01, 1e4, irsg::SensorDisplay().sceneContrast_K, 2}, box);
    sceneContrast_->setToolTip(tr("Temperature difference that the display shows from black to "
                                  "white"));
    criteria_->addRow(tr("Scene contrast"), sceneContrast_);
    return box;
}

QWidget* DetectionPage::makePlaceBox(QWidget* parent) {
    auto* box = new QGroupBox(tr("Where it is looked for"), parent);
    QFormLayout* form = formOf(box);
    step_ = boxOf("aspectStep", "deg", {0.1, 90.0, 10.0, 3}, box);
    step_->setToolTip(tr("Between two aspects. Type, elevation and sector are those of the "
                         "project's polar plot."));
    nearest_ = boxOf("nearest", "m", {0.1, 1e9, 100.0, 1}, box);
    farthest_ = boxOf("farthest", "m", {0.1, 1e9, 1e6, 1}, box);
    background_ = boxOf("backgroundTemperature", "K", {0.0, 5000.0, 0.0, 2}, box);
    background_->setSpecialValueText(tr("that of the scene"));
    background_->setToolTip(tr("Of the background whose photons make noise"));
    form->addRow(tr("Step"), step_);
    form->addRow(tr("Nearest range"), nearest_);
    form->addRow(tr("Farthest range"), farthest_);
    form->addRow(tr("Background"), background_);
    return box;
}

QWidget* DetectionPage::makeRight() {
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    plot_ = new PlotPanel(PlotKind::polar, dialogs_, right);
    quantity_ = new QComboBox(plot_);
    quantity_->setObjectName("quantity");
    quantity_->setMinimumWidth(90);
    quantity_->setToolTip(tr("Quantity that is drawn"));
    plot_->addInFront(quantity_);
    summary_ = new QLabel(right);
    summary_->setObjectName("summary");
    summary_->setWordWrap(true);
    summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    summary_->setContentsMargins(12, 6, 12, 8);
    summary_->setText(tr("The range at which the sensor just sees the target, over its aspect, "
                         "is drawn here once it was calculated."));
    column->addWidget(plot_, 1);
    column->addWidget(summary_);
    return right;
}

void DetectionPage::chooseSensor(int index) {
    if (sensors_->itemData(index).toString() != another) {
        chosen_ = index;
        describeSensor();
        refresh();
        return;
    }
    sensors_->setCurrentIndex(chosen_);
    const QString file =
        dialogs_.openFile(this, tr("Sensor"), {tr("Sensor (*.smatsensor)"), tr("All files (*)")});
    if (!file.isEmpty())
        openSensor(file.toStdString());
}

void DetectionPage::openSensor(const std::filesystem::path& file) {
    const QString path = QString::fromStdString(std::filesystem::absolute(file).string());
    int index = sensors_->findData(path);
    if (index < 0) {
        index = sensors_->count() - 1; // before "A file"
        sensors_->insertItem(index, QString::fromStdString(file.stem().string()), path);
    }
    sensors_->setCurrentIndex(index);
    chooseSensor(index);
}

void DetectionPage::describeSensor() {
    sensor_.reset();
    sensorProblem_.clear();
    const QString file = sensors_->currentData().toString();
    sensors_->setToolTip(file);
    if (file == another || file.isEmpty()) {
        sensorProblem_ = tr("Choose a sensor.");
        sensorText_->setText(tr("No sensor comes with this program: choose a file."));
        return;
    }
    try {
        sensor_ = irsg::loadSensor(file.toStdString());
        const irsg::SensorDescription& sensor = *sensor_;
        const irsg::SensorNumbers numbers =
            irsg::sensorNumbers(sensor, 300.0, irsg::ConeConvention::exact, 1.0);
        sensorText_->setText(
            tr("%1\n%2–%3 µm, %4 × %5 pixels of %6 mrad, F/%7, NETD %8 mK at 300 K")
                .arg(QString::fromStdString(sensor.title),
                     formattedNumber(sensor.detector.band.min_um),
                     formattedNumber(sensor.detector.band.max_um))
                .arg(sensor.detector.columns)
                .arg(sensor.detector.rows)
                .arg(1e3 * sensor.pixelAngle_rad(), 0, 'g', 3)
                .arg(sensor.optics.fNumber(), 0, 'g', 3)
                .arg(1e3 * numbers.netd_K, 0, 'g', 3));
    } catch (const irsg::InputError& error) {
        sensorProblem_ = sentencesOf(error).join('\n');
        sensorText_->setText(tr("This sensor cannot be used."));
    }
}

DetectionRequest DetectionPage::request() const {
    if (!sensor_)
        throw irsg::InputError({"", tr("Sensor").toStdString(), "nothing", "a sensor"});
    DetectionRequest request;
    request.sensor = *sensor_;
    request.sensorFile = sensors_->currentData().toString().toStdString();
    request.criterion = static_cast<RangeCriterion>(criterion_->currentData().toInt());
    request.threshold = snr_->value();
    request.place = static_cast<PointPlace>(place_->currentData().toInt());
    request.task = {
        tasksOf(request.criterion)[static_cast<std::size_t>(task_->currentIndex())].cyclesOfHalf,
        0.01 * probability_->value()};
    request.display.sceneContrast_K = sceneContrast_->value();
    request.limits.nearest_m = nearest_->value();
    request.limits.farthest_m = farthest_->value();
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
    if (!sensorProblem_.isEmpty())
        return {sensorProblem_};
    try {
        const AnalysisData data = asked();
        planAnalysis(AnalysisKind::polar, data.project, data.settings);
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
    for (QWidget* field : {static_cast<QWidget*>(snr_), static_cast<QWidget*>(place_)})
        criteria_->setRowVisible(field, isPoint);
    for (QWidget* field : {static_cast<QWidget*>(task_), static_cast<QWidget*>(probability_)})
        criteria_->setRowVisible(field, !isPoint);
}

int DetectionPage::start() {
    return workbench_.start(asked(), request(), this);
}

QString DetectionPage::progressText(const Progress& progress) const {
    return tr("%1 of %2 aspects").arg(progress.done).arg(progress.total);
}

QString DetectionPage::cancelText() const {
    return tr("cancelled; what is done so far follows in a moment");
}

void DetectionPage::showResult(const JobResult& result) {
    if (!result.data)
        return;
    result_ = result.data;
    const QSignalBlocker quiet(quantity_);
    const QString kept = quantity_->currentData().toString();
    quantity_->clear();
    for (const std::string& key : plottableQuantities(result_->table))
        quantity_->addItem(quantityTitle(result_->table, key), QString::fromStdString(key));
    const int usual = quantity_->findData(QStringLiteral("detection_range"));
    const int same = quantity_->findData(kept);
    quantity_->setCurrentIndex(std::max(same >= 0 ? same : usual, 0));
    drawResult();
    setProgress(
        1000,
        tr("%1 aspects in %2 s").arg(result_->table.rowCount()).arg(result_->elapsed_s, 0, 'f', 2));
    QStringList lines;
    for (const SummaryItem& item : result_->summary)
        lines << summaryLine(item);
    for (const std::string& warning : result_->warnings)
        lines << tr("note: %1").arg(QString::fromStdString(warning));
    summary_->setText(lines.join('\n'));
}

void DetectionPage::drawResult() {
    if (!result_)
        return;
    plot_->polar()->setData(polarData({{tr("Detection range"), &result_->table}},
                                      quantity_->currentData().toString().toStdString()));
    plot_->refresh();
}

QStringList DetectionPage::exportFilters() const {
    if (!result_)
        return {};
    return {tr("Values as text (*.csv)"), tr("All inputs and values (*.json)"),
            tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void DetectionPage::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (result_ && (suffix == ".csv" || suffix == ".json"))
        result_->table.save(file);
    else
        plot_->exportTo(file);
}

} // namespace smat::gui

#include "moc_DetectionPage.cpp"
