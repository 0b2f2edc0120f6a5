#include "gui/scenario/ScenarioPage.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/image/ColorBar.h"
#include "gui/image/ImageView.h"
#include "gui/scenario/EditPanel.h"
#include "gui/scenario/FramesPanel.h"
#include "gui/scenario/PlanView.h"
#include "gui/scenario/PresentTable.h"
#include "gui/scenario/RunScenarioDialog.h"
#include "gui/scenario/TimeLine.h"
#include "gui/start/DataFolder.h"
#include "gui/widgets/DisplayUnits.h"
#include "gui/widgets/FlowBar.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/VerticalScrollArea.h"
#include "gui/widgets/Widgets.h"
#include "gui/workbench/Workbench.h"
#include "irsg/core/Errors.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/SimulationOutputs.h"

namespace smat::gui {
namespace {

/// From this width on the panels stand beside the picture, below it before.
constexpr int wide_px = 980;
constexpr int lowestFrames_px = 320;

QStringList scenarioFilters() {
    return {ScenarioPage::tr("Scenarios (*.json)"), ScenarioPage::tr("All files (*)")};
}

} // namespace

ScenarioPage::ScenarioPage(std::unique_ptr<ScenarioDocument> document, Workbench& workbench,
                           Dialogs dialogs, QWidget* parent)
    : QWidget(parent),
      document_(std::move(document)),
      workbench_(workbench),
      dialogs_(std::move(dialogs)),
      pictures_(new ScenarioPictures(workbench.models(), this)) {
    setObjectName("scenarioPage");
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Window);
    makeParts();
    connectParts();
    followDocument();
}

ScenarioPage::~ScenarioPage() = default;

void ScenarioPage::makeParts() {
    image_ = new ImageView(this, dialogs_);
    notice_ = new QLabel(this);
    notice_->setObjectName("scenarioNotice");
    notice_->setWordWrap(true);
    notice_->setAlignment(Qt::AlignCenter);
    notice_->setForegroundRole(QPalette::PlaceholderText);
    notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    notice_->setMinimumSize(200, 160);
    notice_->setText(tr("Reading the models…"));
    image_->hide();
    timeLine_ = new TimeLine(this);
    present_ = new PresentTable(this);
    plan_ = new PlanView(this);
    notes_ = new QLabel(this);
    notes_->setObjectName("scenarioNotes");
    notes_->setWordWrap(true);
    notes_->setForegroundRole(QPalette::PlaceholderText);
    notes_->hide();

    auto* now = new QWidget(this);
    auto* nowColumn = new QVBoxLayout(now);
    nowColumn->setContentsMargins(0, 0, 0, 0);
    nowColumn->setSpacing(0);
    halves_ = new QSplitter(Qt::Vertical, now);
    halves_->setChildrenCollapsible(false);
    halves_->addWidget(plan_);
    nowColumn->addWidget(halves_, 1);
    nowColumn->addWidget(notes_);
    panels_ = new QTabWidget(this);
    panels_->setObjectName("scenarioPanels");
    panels_->setDocumentMode(true);
    panels_->addTab(present_, tr("Entities"));
    panels_->addTab(now, tr("Plan"));
    frames_ = new FramesPanel(dialogs_, this);
    panels_->addTab(frames_, tr("Frames"));
    panels_->addTab(new VerticalScrollArea(new EditPanel(*document_, dialogs_, this), this),
                    tr("Edit"));
    letShownPageAloneAskForRoom(*panels_);

    auto* left = new QWidget(this);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 6, 0, 0);
    column->setSpacing(2);
    auto* bar = makeBar();
    bar->setContentsMargins(10, 0, 10, 0);
    column->addWidget(bar);
    column->addWidget(image_, 1);
    column->addWidget(notice_, 1);
    column->addWidget(timeLine_);
    parts_ = new QSplitter(Qt::Vertical, this);
    parts_->setObjectName("scenarioParts");
    parts_->setChildrenCollapsible(false);
    parts_->addWidget(left);
    parts_->addWidget(panels_);
    parts_->setStretchFactor(0, 3);
    parts_->setStretchFactor(1, 2);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(parts_);
}

FlowBar* ScenarioPage::makeBar() {
    sensor_ = new QComboBox(this);
    sensor_->setObjectName("scenarioSensor");
    sensor_->setToolTip(tr("Sensor whose picture is shown"));
    sensor_->setAccessibleName(tr("Sensor"));
    sensor_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    band_ = new QComboBox(this);
    band_->setObjectName("scenarioBand");
    band_->setToolTip(tr("Band of the sensor"));
    band_->setAccessibleName(tr("Band"));
    band_->hide();
    auto* flow = new FlowBar(this);
    auto* label = new QLabel(tr("Sensor"), this);
    label->setBuddy(sensor_);
    flow->first()->addWidget(label);
    flow->first()->addWidget(sensor_);
    flow->first()->addWidget(band_);
    run_ = textButton(tr("Write frames…"), "runScenario",
                      tr("Write the frames and tables of all sensors into a folder, as smat-batch "
                         "simulate does"));
    flow->second()->addWidget(run_);
    return flow;
}

void ScenarioPage::connectParts() {
    connect(document_.get(), &ScenarioDocument::changed, this, &ScenarioPage::followDocument);
    connect(document_.get(), &ScenarioDocument::stateChanged, this,
            [this] { emit titleChanged(title()); });
    connect(timeLine_, &TimeLine::stepChanged, this, &ScenarioPage::ask);
    connect(timeLine_, &TimeLine::playingChanged, this, [this] {
        if (!pictures_->isBusy())
            timeLine_->shown();
    });
    connect(sensor_, &QComboBox::activated, this, [this] { showSensor(shownSensor()); });
    connect(run_, &QToolButton::clicked, this, &ScenarioPage::run);
    connect(frames_, &FramesPanel::frameChosen, this,
            [this](std::size_t, std::size_t band, std::size_t number) {
                band_->setCurrentIndex(static_cast<int>(band));
                timeLine_->pause();
                timeLine_->setStep(number);
                ask();
            });
    connectJobs();
    connect(band_, &QComboBox::activated, this, &ScenarioPage::ask);
    connect(pictures_, &ScenarioPictures::drawn, this, &ScenarioPage::show);
    connect(&DisplayUnitsWatch::instance(), &DisplayUnitsWatch::changed, present_, [this] {
        if (present_->rowCount() > 0)
            present_->showMoment(document_->scenario(), picture_);
    });
    connect(pictures_, &ScenarioPictures::failed, this, &ScenarioPage::tellProblems);
}

void ScenarioPage::connectJobs() {
    JobQueue& jobs = workbench_.jobs();
    connect(&jobs, &JobQueue::finished, this, [this](int number, const JobResult& result) {
        if (number == job_ && result.simulation)
            takeOutcome(result.simulation);
        if (number == film_ && result.film)
            takeFilm(*result.film);
    });
    connect(&jobs, &JobQueue::failed, this, [this](int number, const QStringList& sentences) {
        if (number == job_ || number == film_)
            frames_->say(sentences.join('\n'));
        toldOfFilm_ = toldOfFilm_ || number == film_;
    });
    connect(frames_, &FramesPanel::filmAsked, this, [this](const FilmOrder& order) {
        toldOfFilm_ = false;
        film_ = workbench_.start(order);
        frames_->setFilming(true);
        frames_->say(tr("The film is being written; the bar below shows the progress."));
    });
    // Whatever became of it; one that was cancelled, or taken out of the line, says nothing more.
    const auto rest = [this] {
        if (film_ == 0 || workbench_.jobs().holds(film_))
            return;
        if (!toldOfFilm_)
            frames_->say(tr("The film was cancelled; nothing was written."));
        film_ = 0;
        frames_->setFilming(false);
    };
    const auto restLater = [this, rest] { QTimer::singleShot(0, this, rest); };
    connect(&jobs, &JobQueue::ended, this, restLater);
    connect(&jobs, &JobQueue::waitingChanged, this, restLater);
}

void ScenarioPage::takeFilm(const FilmOutcome& film) {
    const QString sentence = !film.sentence.empty() ? textOf(film.sentence)
                             : film.files.size() > 1
                                 ? tr("Wrote the pictures %1").arg(textOf(firstToLast(film.files)))
                                 : tr("Wrote the film %1").arg(textOf(firstToLast(film.files)));
    toldOfFilm_ = true;
    frames_->say(sentence);
    emit said(sentence);
}

void ScenarioPage::followDocument() {
    const Scenario& scenario = document_->scenario();
    const int shown = std::max(sensor_->currentIndex(), 0);
    sensor_->clear();
    for (const ScenarioSensor& sensor : scenario.sensors)
        sensor_->addItem(textOf(sensor.name));
    sensor_->setCurrentIndex(std::min(shown, sensor_->count() - 1));
    displayedSensor_.reset();
    pictures_->setScenario(document_->now());
    plan_->setScenario(document_->now());
    timeLine_->setTimes(scenario.times_s());
    ask();
}

std::size_t ScenarioPage::shownSensor() const {
    return static_cast<std::size_t>(std::max(sensor_->currentIndex(), 0));
}

void ScenarioPage::showSensor(std::size_t sensor) {
    sensor_->setCurrentIndex(static_cast<int>(sensor));
    frames_->showSensor(sensor);
    ask();
}

void ScenarioPage::ask() {
    plan_->setMoment(timeLine_->time_s(), shownSensor(), picture_.settings[key::sensorFov]);
    pictures_->ask({.sensor = shownSensor(),
                    .band = static_cast<std::size_t>(std::max(band_->currentIndex(), 0)),
                    .step = timeLine_->step(),
                    .time_s = timeLine_->time_s()});
}

void ScenarioPage::show(const ScenarioPicture& picture) {
    picture_ = picture;
    refreshBands(picture);
    plan_->setMoment(picture.moment.time_s, picture.moment.sensor,
                     picture.settings[key::sensorFov]);
    present_->showMoment(document_->scenario(), picture);
    notes_->setText(picture.notes.join('\n'));
    notes_->setVisible(!picture.notes.isEmpty());
    image_->setVisible(picture.shown != nullptr);
    notice_->setVisible(picture.shown == nullptr);
    if (picture.shown != nullptr) {
        image_->setTitle(picture.title);
        image_->setFrame(picture.shown);
        image_->setConditions(picture.title + "   " + picture.conditions);
        if (displayedSensor_ != picture.moment.sensor)
            useDisplay(picture.settings);
        displayedSensor_ = picture.moment.sensor;
    } else {
        notice_->setText(tr("There is no image at this time: the sensor, its carrier or the entity "
                            "that it tracks is not present."));
    }
    if (picture.moment.step == timeLine_->step())
        timeLine_->shown();
}

void ScenarioPage::useDisplay(const Settings& settings) {
    image_->setColorMap(settings.text(key::displayColorMap));
    image_->setColorScale(irsg::colorScaleNamed(settings.text(key::displayScale)),
                          settings[key::displayMarkOutside]);
    image_->setLimits(settings[key::displayMinimum], settings[key::displayMaximum]);
}

void ScenarioPage::refreshBands(const ScenarioPicture& picture) {
    const int count = static_cast<int>(picture.bandCount);
    if (band_->count() != count || displayedSensor_ != picture.moment.sensor) {
        band_->clear();
        const QStringList names = textOf(picture.settings.text(key::sensorBand)).split(',');
        for (int i = 0; i < count; ++i)
            band_->addItem(i < names.size() && names.size() == count
                               ? tr("%1 µm").arg(names[i].trimmed())
                               : tr("Band %1").arg(i + 1));
        band_->setCurrentIndex(static_cast<int>(picture.moment.band));
    }
    band_->setVisible(count > 1);
}

void ScenarioPage::tellProblems(const QStringList& sentences) {
    timeLine_->pause();
    image_->hide();
    notice_->show();
    notice_->setText(tr("This cannot be drawn:") + "\n" + sentences.join('\n'));
    emit said(sentences.join("   "));
}

void ScenarioPage::run() {
    const auto state = document_->now();
    RunScenarioDialog dialog(*state, !document_->isModified(), dialogs_, this);
    if (!dialogs_.run(dialog))
        return;
    timeLine_->pause();
    frames_->say(tr("The frames are being written; the bar below shows the progress."));
    panels_->setCurrentWidget(frames_);
    job_ = workbench_.start(dialog.order());
}

void ScenarioPage::takeOutcome(const std::shared_ptr<const SimulationFrames>& outcome) {
    frames_->setOutcome(outcome, textOf(image_->colorMap().name()));
    frames_->showSensor(shownSensor());
    panels_->setCurrentWidget(frames_);
    // Below the picture curves need more room than what stood there before.
    if (parts_->orientation() == Qt::Vertical && panels_->height() < lowestFrames_px)
        parts_->setSizes({parts_->height() - lowestFrames_px, lowestFrames_px});
    emit said(
        tr("Wrote %1 frames to %2").arg(outcome->frames.size()).arg(textOf(outcome->order.folder)));
}

QString ScenarioPage::title() const {
    return textOf(document_->scenario().displayName()) + (document_->isModified() ? " *" : "");
}

bool ScenarioPage::save() {
    if (isOfSample(document_->file()))
        return saveAs();
    if (document_->isModified() && document_->isChangedOnDisk() &&
        dialogs_.ask(this, tr("The file has changed"),
                     tr("Another program has changed the scenario or one of its trajectories since "
                        "it was read."),
                     {tr("&Replace it with mine")}) != 0)
        return false;
    return saveTo(document_->file());
}

bool ScenarioPage::saveAs() {
    const QString file = dialogs_.saveFile(this, tr("Save the scenario"), scenarioFilters(),
                                           textOf(ownPlaceOf(document_->file())));
    return !file.isEmpty() && saveTo(file.toStdString());
}

/// By value: what the document calls its file goes with the state that is saved.
bool ScenarioPage::saveTo(
    std::filesystem::path file) { // NOLINT(performance-unnecessary-value-param)
    try {
        document_->saveAs(file);
        emit said(tr("Saved %1").arg(textOf(file)));
        rememberFile(document_->file());
        return true;
    } catch (const irsg::InputError& error) {
        dialogs_.tell(this, tr("This scenario cannot be saved"), sentencesOf(error));
        return false;
    }
}

bool ScenarioPage::mayClose() {
    if (!document_->isModified())
        return true;
    const int answer = dialogs_.ask(
        this, tr("Unsaved scenario"),
        tr("%1 has edits that are not saved.").arg(textOf(document_->scenario().displayName())),
        {tr("&Save"), tr("&Discard")});
    return answer == 1 || (answer == 0 && save());
}

QStringList ScenarioPage::exportFilters() const {
    return picture_.shown != nullptr ? image_->exportFilters() : QStringList();
}

void ScenarioPage::exportTo(const std::filesystem::path& file) const {
    image_->exportTo(file);
}

void ScenarioPage::keyPressEvent(QKeyEvent* event) {
    // What the parts leave is for the line of time.
    if (event->modifiers() != Qt::NoModifier || !timeLine_->takesKey(event->key()))
        QWidget::keyPressEvent(event);
}

void ScenarioPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const auto wanted = width() >= wide_px ? Qt::Horizontal : Qt::Vertical;
    if (parts_->orientation() == wanted)
        return;
    parts_->setOrientation(wanted);
    // Below the plan where there is room, else beside it.
    if (wanted == Qt::Horizontal) {
        halves_->addWidget(present_);
        halves_->setStretchFactor(0, 3);
        halves_->setStretchFactor(1, 1);
        present_->show();
    } else {
        panels_->insertTab(0, present_, tr("Entities"));
    }
}

} // namespace smat::gui

#include "moc_ScenarioPage.cpp"
