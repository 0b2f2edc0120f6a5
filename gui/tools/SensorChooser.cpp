#include "gui/tools/SensorChooser.h"

#include <algorithm>
#include <vector>

#include <QComboBox>
#include <QLabel>
#include <QVBoxLayout>

#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/sensor/SensorFile.h"
#include "irsg/sensor/SensorNumbers.h"

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
        if (entry.path().extension() == irsg::sensorExtension)
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

} // namespace

SensorChooser::SensorChooser(Dialogs dialogs, QWidget* parent)
    : QWidget(parent), dialogs_(std::move(dialogs)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    list_ = new QComboBox(this);
    list_->setObjectName("sensorFile");
    list_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (const std::filesystem::path& file : shippedSensors())
        list_->addItem(QString::fromStdString(file.stem().string()),
                       QString::fromStdString(file.string()));
    list_->addItem(tr("A file…"), QString(another));
    text_ = new QLabel(this);
    text_->setObjectName("sensorText");
    text_->setWordWrap(true);
    column->addWidget(list_);
    column->addWidget(text_);
    connect(list_, &QComboBox::activated, this, &SensorChooser::choose);
    describe();
}

std::filesystem::path SensorChooser::file() const {
    return list_->currentData().toString().toStdString();
}

void SensorChooser::choose(int index) {
    if (list_->itemData(index).toString() != another) {
        chosen_ = index;
        describe();
        emit changed();
        return;
    }
    list_->setCurrentIndex(chosen_);
    const QString file =
        dialogs_.openFile(this, tr("Sensor"), {tr("Sensor (*.smatsensor)"), tr("All files (*)")});
    if (!file.isEmpty())
        open(file.toStdString());
}

void SensorChooser::open(const std::filesystem::path& file) {
    const QString path = QString::fromStdString(std::filesystem::absolute(file).string());
    int index = list_->findData(path);
    if (index < 0) {
        index = list_->count() - 1; // before "A file"
        list_->insertItem(index, QString::fromStdString(file.stem().string()), path);
    }
    list_->setCurrentIndex(index);
    choose(index);
}

void SensorChooser::describe() {
    sensor_.reset();
    problem_.clear();
    const QString file = list_->currentData().toString();
    list_->setToolTip(file);
    if (file == another || file.isEmpty()) {
        problem_ = tr("Choose a sensor.");
        text_->setText(tr("No sensor comes with this program: choose a file."));
        return;
    }
    try {
        sensor_ = irsg::loadSensor(file.toStdString());
        const irsg::SensorDescription& sensor = *sensor_;
        const irsg::SensorNumbers numbers =
            irsg::sensorNumbers(sensor, 300.0, irsg::ConeConvention::exact, 1.0);
        text_->setText(
            tr("%1\n%2–%3 µm, %4 × %5 pixels of %6 mrad, F/⁠%7, NETD %8 mK at 300 K")
                .arg(QString::fromStdString(sensor.title),
                     formattedNumber(sensor.detector.band.min_um),
                     formattedNumber(sensor.detector.band.max_um))
                .arg(sensor.detector.columns)
                .arg(sensor.detector.rows)
                .arg(1e3 * sensor.pixelAngle_rad(), 0, 'g', 3)
                .arg(sensor.optics.fNumber(), 0, 'g', 3)
                .arg(1e3 * numbers.netd_K, 0, 'g', 3));
    } catch (const irsg::InputError& error) {
        problem_ = sentencesOf(error).join('\n');
        text_->setText(tr("This sensor cannot be used."));
    }
}

} // namespace smat::gui

#include "moc_SensorChooser.cpp"
