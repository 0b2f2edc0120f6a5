#include "gui/tools/SensorPage.h"

#include <algorithm>

#include <QButtonGroup>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSplitter>
#include <QVBoxLayout>

#include "gui/analysis/ResultStore.h"
#include "gui/plot/CartesianPlot.h"
#include "gui/plot/PlotPanel.h"
#include "gui/tools/PlanePane.h"
#include "gui/tools/SensorChooser.h"
#include "gui/tools/SensorScene.h"
#include "gui/tools/StageCard.h"
#include "gui/widgets/FoldingSplitter.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/sensor/SensorNumbers.h"
#include "smatcore/support/ShellText.h"
#include "smatcore/tools/SensorOutput.h"

namespace smat::gui {

namespace {

constexpr double background_K = 300.0;
constexpr std::size_t wholeChain = irsg::sensorStages.size();
constexpr std::size_t electronics = wholeChain - 1;
constexpr std::array cardNames = {"stageOptics", "stageDetector", "stageMotion", "stageElectronics",
                                  "stageChain"};
constexpr std::array cardTitles = {QT_TRANSLATE_NOOP("smat::gui::SensorPage", "Optics"),
                                   QT_TRANSLATE_NOOP("smat::gui::SensorPage", "Detector"),
                                   QT_TRANSLATE_NOOP("smat::gui::SensorPage", "Motion"),
                                   QT_TRANSLATE_NOOP("smat::gui::SensorPage", "Electronics"),
                                   QT_TRANSLATE_NOOP("smat::gui::SensorPage", "Chain")};

double nyquist_per_rad(const irsg::SensorDescription& sensor) {
    return 0.5 / sensor.pixelAngle_rad();
}

/// From 0 to twice Nyquist's frequency, which is one of them.
std::vector<double> frequenciesOf(const irsg::SensorDescription& sensor) {
    std::vector<double> frequencies;
    constexpr int steps = 64;
    for (int i = 0; i <= 2 * steps; ++i)
        frequencies.push_back(nyquist_per_rad(sensor) * i / steps);
    return frequencies;
}

/// The product of a stage's columns of a table of transfer functions.
std::vector<double> productOf(const ResultTable& table, irsg::SensorStage stage) {
    std::vector<double> product(table.rowCount(), 1.0);
    for (std::size_t row = 0; row < product.size(); ++row) {
        std::vector<irsg::SensorTransfer::Component> components;
        for (const ResultColumn& column : table.columns())
            if (column.key != "frequency" && column.key != "system")
                components.push_back({column.key, column.values[row]});
        for (const auto& one : irsg::componentsOf(stage, components))
            product[row] *= one.value;
    }
    return product;
}

QString wordsOf(std::string key) {
    std::ranges::replace(key, '_', ' ');
    return QString::fromStdString(key);
}

QString rounded(double value) {
    return sentenceNumber(value, 3);
}

} // namespace

SensorPage::SensorPage(Workbench& workbench, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), workbench_(workbench), dialogs_(std::move(dialogs)) {
    setObjectName("sensorPage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    constexpr int side_px = 270;
    auto* side = new VerticalScrollArea(makeSide(), this, side_px);
    row->addWidget(new FoldingSplitter(side, side_px, makeRight(), this));
    connect(chooser_, &SensorChooser::changed, this, &SensorPage::takeSensor);
    connect(scenes_, &QComboBox::currentIndexChanged, this, &SensorPage::takeScene);
    connect(direction_, &QComboBox::currentIndexChanged, this, &SensorPage::takeSensor);
    for (const auto of : {&ResultStore::added, &ResultStore::addedQuietly, &ResultStore::renamed,
                          &ResultStore::removed})
        connect(&workbench_.resultStore(), of, this, &SensorPage::fillScenes);
    fillScenes();
    takeSensor();
}

QWidget* SensorPage::makeSide() {
    auto* side = new QWidget(this);
    side->setAutoFillBackground(true);
    side->setBackgroundRole(QPalette::Window);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(10, 10, 10, 10);
    auto* sensor = new QGroupBox(tr("Sensor"), side);
    auto* sensorColumn = new QVBoxLayout(sensor);
    chooser_ = new SensorChooser(dialogs_, sensor);
    problem_ = new QLabel(sensor);
    problem_->setObjectName("problem");
    problem_->setWordWrap(true);
    sensorColumn->addWidget(chooser_);
    sensorColumn->addWidget(problem_);
    auto* seen = new QGroupBox(tr("Scene"), side);
    auto* seenColumn = new QVBoxLayout(seen);
    scenes_ = new QComboBox(seen);
    scenes_->setObjectName("stageScene");
    scenes_->setToolTip(tr("A test pattern, or an image among the results of the project"));
    scenes_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    sceneText_ = new QLabel(seen);
    sceneText_->setObjectName("stageSceneText");
    sceneText_->setWordWrap(true);
    seenColumn->addWidget(scenes_);
    seenColumn->addWidget(sceneText_);
    auto* transfer = new QGroupBox(tr("Transfer function"), side);
    auto* form = new QFormLayout(transfer);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    direction_ = new QComboBox(transfer);
    direction_->setObjectName("transferDirection");
    direction_->addItem(tr("along the rows"), false);
    direction_->addItem(tr("along the columns"), true);
    form->addRow(tr("Direction"), direction_);
    column->addWidget(sensor);
    column->addWidget(seen);
    column->addWidget(transfer);
    column->addStretch();
    column->addWidget(new QLabel(tr("Equivalent command:"), side));
    command_ = new QLineEdit(side);
    command_->setObjectName("command");
    command_->setReadOnly(true);
    column->addWidget(command_);
    side->setFixedWidth(258);
    return side;
}

QWidget* SensorPage::makeRight() {
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(10, 10, 10, 10);
    auto* cards = new QHBoxLayout;
    cards->setSpacing(2);
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        if (i > 0)
            cards->addWidget(new QLabel(i == wholeChain ? "=" : "→", right), 0);
        cards_[i] = new StageCard(cardNames[i], tr(cardTitles[i]), right);
        group->addButton(cards_[i], static_cast<int>(i));
        cards->addWidget(cards_[i], 1);
    }
    cards_[chosen_]->setChecked(true);
    connect(group, &QButtonGroup::idToggled, this, [this](int id, bool on) {
        if (!on)
            return;
        chosen_ = static_cast<std::size_t>(id);
        showStage();
    });
    numbers_ = new QLabel(right);
    numbers_->setObjectName("stageNumbers");
    numbers_->setWordWrap(true);
    numbers_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    plot_ = new PlotPanel(PlotKind::cartesian, dialogs_, right);
    before_ = new PlanePane("before", right);
    behind_ = new PlanePane("behind", right);
    auto* panes = new QWidget(right);
    auto* pictures = new QHBoxLayout(panes);
    pictures->setContentsMargins(0, 4, 0, 0);
    pictures->setSpacing(10);
    pictures->addWidget(before_, 1);
    pictures->addWidget(behind_, 1);
    auto* both = new QSplitter(Qt::Vertical, right);
    both->setChildrenCollapsible(false);
    plot_->setMinimumSize(260, 220);
    both->addWidget(plot_);
    both->addWidget(panes);
    both->setSizes({300, 260});
    column->addLayout(cards);
    column->addWidget(numbers_);
    column->addWidget(both, 1);
    return right;
}

void SensorPage::fillScenes() {
    const QSignalBlocker quiet(scenes_);
    const int kept = scenes_->currentData().toInt();
    scenes_->clear();
    scenes_->addItem(tr("Test pattern: bars and a point"), 0);
    for (const ResultEntry& entry : workbench_.results())
        if (entry.isImage() && canBeStageScene(*entry.image()))
            scenes_->addItem(entry.title, entry.id);
    const int same = scenes_->findData(kept);
    scenes_->setCurrentIndex(std::max(same, 0));
    if (same < 0)
        takeScene();
}

void SensorPage::takeSensor() {
    const auto& sensor = chooser_->sensor();
    problem_->setText(chooser_->problem());
    problem_->setVisible(!sensor);
    table_ = ResultTable();
    command_->clear();
    if (sensor) {
        numbersOfSensor_ =
            irsg::sensorNumbers(*sensor, background_K, irsg::ConeConvention::exact, 1.0);
        table_ = sensorTransferTable(*sensor, frequenciesOf(*sensor),
                                     direction_->currentData().toBool(), background_K);
        QStringList frequencies;
        for (const double part : {0.0, 0.5, 1.0, 1.5, 2.0})
            frequencies << QString::fromStdString(
                irsg::roundedText(part * nyquist_per_rad(*sensor), 6));
        command_->setText(
            QString("smat-batch sensor mtf %1 --frequencies %2%3 --out mtf.csv")
                .arg(QString::fromStdString(shellQuoted(chooser_->file().string())),
                     frequencies.join(','),
                     direction_->currentData().toBool() ? QString(" --direction vertical") : ""));
        command_->setCursorPosition(0);
        for (std::size_t i = 0; i < cards_.size(); ++i) {
            if (i == electronics) {
                cards_[i]->setCurve({},
                                    tr("%1 mK").arg(rounded(1e3 * numbersOfSensor_.totalNetd_K)));
                cards_[i]->setToolTip(tr(
                    "NETD from all noise, fixed pattern included, against a background of 300 K"));
                continue;
            }
            const std::vector<double> curve = i == wholeChain
                                                  ? table_.find("system")->values
                                                  : productOf(table_, irsg::sensorStages[i]);
            cards_[i]->setCurve(curve, rounded(curve[(curve.size() - 1) / 2]));
            cards_[i]->setToolTip(tr(
                "Transfer function up to twice Nyquist's frequency, and its value at Nyquist's"));
        }
    } else {
        for (StageCard* card : cards_)
            card->setCurve({}, {});
    }
    takeScene();
}

void SensorPage::takeScene() {
    pictures_.reset();
    task_.cancel();
    sceneText_->clear();
    showStage();
    if (!chooser_->sensor())
        return;
    const irsg::SensorDescription sensor = *chooser_->sensor();
    const ResultEntry* entry = workbench_.result(scenes_->currentData().toInt());
    if (entry != nullptr)
        sceneText_->setText(QString::fromStdString(wordsOfPiece(*entry->image(), sensor)));
    else
        sceneText_->setText(tr("Bars with periods of 8, 4 and 2 pixels, 10 K above a background of "
                               "300 K, and a point of 500 K."));
    using Both = std::pair<irsg::StageScene, irsg::StagePictures>;
    const auto image = entry != nullptr ? entry->image() : nullptr;
    task_.run<Both>(
        [sensor, image]() -> Both {
            irsg::StageScene scene = image ? pieceOf(*image, sensor) : testPattern(sensor);
            irsg::StagePictures pictures = irsg::stagePictures(sensor, scene, background_K);
            return {std::move(scene), std::move(pictures)};
        },
        [this](Both both) {
            scene_ = std::move(both.first);
            pictures_ = std::move(both.second);
            showStage();
        });
}

void SensorPage::showStage() {
    drawTransfer();
    showPictures();
    numbers_->setText(chooser_->sensor() ? numbersOf(chosen_) : QString());
}

void SensorPage::drawTransfer() {
    PlotData data;
    data.title = tr("Transfer function");
    data.xTitle = tr("Frequency (cycles/mrad)");
    data.yTitle = tr("Modulation");
    if (!table_.empty()) {
        std::vector<double> x = table_.find("frequency")->values;
        for (double& frequency : x)
            frequency *= 1e-3;
        const auto add = [&](const QString& name, const std::vector<double>& y) {
            data.curves.push_back({.name = name, .x = x, .y = y});
        };
        if (chosen_ >= electronics) {
            for (std::size_t i = 0; i < electronics; ++i)
                add(tr(cardTitles[i]), productOf(table_, irsg::sensorStages[i]));
        } else {
            for (const ResultColumn& column : table_.columns())
                if (!irsg::componentsOf(irsg::sensorStages[chosen_], {{column.key, 1.0}}).empty() &&
                    column.key != "frequency" && column.key != "system")
                    add(wordsOf(column.key), column.values);
            add(tr(cardTitles[chosen_]), productOf(table_, irsg::sensorStages[chosen_]));
        }
        add(tr("Chain"), table_.find("system")->values);
        data.marks = {{1e-3 * nyquist_per_rad(*chooser_->sensor()), tr("Nyquist")}};
    }
    plot_->cartesian()->setData(std::move(data));
    plot_->refresh();
}

void SensorPage::showPictures() {
    const bool isChain = chosen_ == wholeChain;
    const QString before =
        isChain || chosen_ == 0 ? tr("Scene") : tr("After: %1").arg(tr(cardTitles[chosen_ - 1]));
    const QString behind =
        chosen_ >= electronics ? tr("Counts") : tr("After: %1").arg(tr(cardTitles[chosen_]));
    if (!pictures_) {
        for (PlanePane* pane : {before_, behind_})
            pane->clear(task_.isBusy() ? tr("calculating…") : QString());
        return;
    }
    // All but the darkest and the brightest parts in 200: a point and bad pixels outshine the rest.
    const auto limitsOf = [](const std::vector<float>& values) {
        return irsg::percentileLimits(values, 0.5, 99.5);
    };
    const auto captioned = [](const QString& title, const irsg::DisplayLimits& limits,
                              const QString& unit) {
        return tr("%1\n%2 to %3 %4")
            .arg(title, rounded(limits.low), rounded(limits.high), unit)
            .trimmed();
    };
    const int cells = scene_.samples;
    const int width = static_cast<int>(scene_.columns_px),
              height = static_cast<int>(scene_.rows_px);
    const QString radiance = tr("W·m⁻²·sr⁻¹");
    const auto& first = pictures_->radiance_W_m2_sr[isChain ? 0 : chosen_];
    const irsg::DisplayLimits limits = limitsOf(first);
    before_->setPlane(captioned(before, limits, radiance), first, cells * width, cells * height,
                      limits);
    if (chosen_ >= electronics) {
        const irsg::DisplayLimits counts = limitsOf(pictures_->counts);
        QString title = captioned(behind, counts, {});
        if (pictures_->saturated > 0)
            title += tr(" · %1 saturated pixels").arg(pictures_->saturated);
        behind_->setPlane(title, pictures_->counts, width, height, counts);
    } else {
        const auto& second = pictures_->radiance_W_m2_sr[chosen_ + 1];
        const irsg::DisplayLimits own = limitsOf(second);
        behind_->setPlane(captioned(behind, own, radiance), second, cells * width, cells * height,
                          own);
    }
}

QString SensorPage::numbersOf(std::size_t stage) const {
    const irsg::SensorDescription& sensor = *chooser_->sensor();
    const irsg::SensorNumbers& numbers = numbersOfSensor_;
    switch (stage) {
    case 0:
        return tr("Aperture %1 mm, focal length %2 mm, F/%3.")
            .arg(rounded(1e3 * sensor.optics.aperture_m),
                 rounded(1e3 * sensor.optics.focalLength_m), rounded(sensor.optics.fNumber()));
    case 1:
        return tr("Pitch %1 µm, fill factor %2, integration time %3 ms.")
            .arg(rounded(sensor.detector.pitch_um), rounded(sensor.detector.fillFactor),
                 rounded(1e3 * sensor.detector.integrationTime_s));
    case 2:
        return tr("Jitter %1 µrad, drift %2 µrad in an integration time.")
            .arg(rounded(sensor.motion.jitter_urad),
                 rounded(sensor.motion.lineOfSightRate_urad_per_s *
                         sensor.detector.integrationTime_s));
    case electronics:
        if (sensor.detector.isThermal())
            return tr("Noise in NETD against 300 K: temporal %1 mK, with the pattern %2 mK; %3 "
                      "bits.")
                .arg(rounded(1e3 * numbers.netd_K), rounded(1e3 * numbers.totalNetd_K))
                .arg(sensor.electronics.bits);
        return tr("Noise in electrons against 300 K: photons %1, dark current %2, read %3, "
                  "quantisation %4, pattern %5; %6 bits.")
            .arg(rounded(numbers.noise.photon), rounded(numbers.noise.dark),
                 rounded(numbers.noise.read), rounded(numbers.noise.quantisation),
                 rounded(numbers.noise.pattern))
            .arg(sensor.electronics.bits);
    default:
        return tr("NETD %1 mK, NEI %2 W/m² for all of a point's energy, both temporal, against 300 "
                  "K; the well "
                  "is %3 % full.")
            .arg(rounded(1e3 * numbers.netd_K), rounded(numbers.neiWholePoint_W_m2),
                 rounded(100.0 * numbers.wellFill));
    }
}

QStringList SensorPage::exportFilters() const {
    if (table_.empty())
        return {};
    return {tr("Values as text (*.csv)"), tr("All inputs and values (*.json)"),
            tr("Scalable picture (*.svg)"), tr("PDF (*.pdf)"), tr("Picture (*.png)")};
}

void SensorPage::exportTo(const std::filesystem::path& file) const {
    const std::string suffix = file.extension().string();
    if (suffix == ".csv" || suffix == ".json")
        table_.save(file);
    else
        plot_->exportTo(file);
}

} // namespace smat::gui

#include "moc_SensorPage.cpp"
