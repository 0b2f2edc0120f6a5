#include "gui/view/BandBox.h"

#include <QLineEdit>

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat::gui {
namespace {

/// "3-5" as people write it: "3–5 µm".
QString readableBand(const QString& band) {
    return QString(band).replace('-', QChar(0x2013)) + QStringLiteral(" µm");
}

/// "3 – 5 um" as the settings want it: "3-5".
QString plainBand(QString text) {
    text.replace(QChar(0x2013), '-').remove(' ');
    for (const char* unit : {"µm", "um"})
        text.remove(QString::fromUtf8(unit));
    return text;
}

} // namespace

BandBox::BandBox(Workbench& workbench, QWidget* parent) : QComboBox(parent), workbench_(workbench) {
    setObjectName("bandBox");
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setMinimumContentsLength(12);
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setToolTip(tr("Band of the sensor: choose one, or type another such as 3.4-4.1"));
    connect(this, &QComboBox::activated, this,
            [this](int index) { choose(itemData(index).toString()); });
    connect(lineEdit(), &QLineEdit::editingFinished, this, [this] {
        if (lineEdit()->isModified())
            choose(plainBand(lineEdit()->text()));
    });
    for (const auto signal :
         {&Workbench::projectOpened, &Workbench::projectChanged, &Workbench::settingsChanged})
        connect(&workbench_, signal, this, &BandBox::fill);
    fill();
}

void BandBox::addBand(const QString& band, const QString& name) {
    if (findData(band) < 0)
        addItem(name.isEmpty() ? readableBand(band) : readableBand(band) + "  " + name, band);
}

void BandBox::fill() {
    const QSignalBlocker quiet(this);
    clear();
    setEnabled(workbench_.hasProject());
    if (!workbench_.hasProject())
        return;
    addBand("3-5", "MWIR");
    addBand("8-12", "LWIR");
    const Settings& now = workbench_.settings();
    const auto add = [this](const Settings& settings) {
        const QString bands = QString::fromStdString(settings.text(key::sensorBand));
        for (const QString& band : bands.split(',', Qt::SkipEmptyParts))
            addBand(band.trimmed());
    };
    add(workbench_.project().settings);
    for (const NamedAnalysis& analysis : workbench_.project().analyses)
        add(workbench_.project().settings.with(analysis.settings));
    add(now);
    const auto responses = now[key::sensorResponse];
    const QString band = QString::fromStdString(now.text(key::sensorBand));
    if (!responses.empty())
        setEditText(QString::fromStdString(responses.front().filename().string()));
    else if (const int index = findData(band); index >= 0)
        setCurrentIndex(index);
    else
        setEditText(readableBand(band));
    lineEdit()->setModified(false);
    lineEdit()->setCursorPosition(0);
}

void BandBox::choose(const QString& band) {
    lineEdit()->setModified(false);
    try {
        Settings changed = workbench_.settings();
        changed.set(key::sensorBand, band.toStdString());
        // A measured response would stand before the band.
        changed.set(key::sensorResponse, std::string());
        workbench_.set(changed, tr("Set band to %1").arg(readableBand(band)));
    } catch (const irsg::InputError& error) {
        emit refused(sentencesOf(error));
    }
    fill();
}

} // namespace smat::gui

#include "moc_BandBox.cpp"
