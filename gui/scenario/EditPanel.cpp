#include "gui/scenario/EditPanel.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/project/ProjectFiles.h"
#include "gui/scenario/MountFields.h"
#include "gui/scenario/PlaceFields.h"
#include "gui/scenario/ScenarioFields.h"
#include "gui/scenario/ScenarioSettings.h"
#include "gui/scenario/TrajectoryModel.h"
#include "gui/scenario/TrajectoryView.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/widgets/Widgets.h"
#include "irsg/core/Errors.h"

namespace smat::gui {

EditPanel::EditPanel(ScenarioDocument& document, Dialogs dialogs, QWidget* parent)
    : QWidget(parent), document_(document), dialogs_(std::move(dialogs)) {
    setObjectName("scenarioEdit");
    part_ = new QComboBox(this);
    part_->setObjectName("editedPart");
    part_->setAccessibleName(tr("Edited part of the scenario"));
    part_->setToolTip(tr("What the fields below are about"));
    part_->setMinimumWidth(120);
    settings_ = textButton(tr("Settings…"), "scenarioSettings",
                           tr("Settings of all sensors, or of the sensor that is edited"));
    add_ = textButton(tr("Add entity…"), "addEntity",
                      tr("Choose a model and its signature database; it stands beside the first "
                         "entity and can be moved from there"));
    addSensor_ = textButton(tr("Add sensor"), "addSensor",
                            tr("Add a copy of the sensor that is edited, or of the first one, "
                               "under another name"));
    remove_ = textButton(tr("Remove"), "removeEntity", tr("Remove this entity or sensor"));
    auto* first = new QHBoxLayout;
    first->addWidget(part_, 1);
    first->addWidget(settings_);
    auto* second = new QHBoxLayout;
    second->addWidget(add_);
    second->addWidget(addSensor_);
    second->addWidget(remove_);
    second->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->addLayout(first);
    column->addLayout(second);
    makeWhole(column);
    makePart(column);
    message_ = new QLabel(this);
    message_->setObjectName("editMessage");
    message_->setWordWrap(true);
    message_->hide();
    column->addWidget(message_);
    column->addStretch(0);

    connect(part_, &QComboBox::activated, this, [this] {
        finish();
        say({});
        followPart();
    });
    connect(settings_, &QToolButton::clicked, this, [this] {
        finish();
        editScenarioSettings(document_, part().sensor, dialogs_, this);
    });
    connect(add_, &QToolButton::clicked, this, &EditPanel::addEntity);
    connect(addSensor_, &QToolButton::clicked, this, &EditPanel::addSensor);
    connect(remove_, &QToolButton::clicked, this, &EditPanel::removeChosen);
    connect(&document_, &ScenarioDocument::changed, this, &EditPanel::follow);
    follow();
}

void EditPanel::makeWhole(QVBoxLayout* column) {
    whole_ = new ScenarioFields(this);
    connect(whole_, &ScenarioFields::edited, this,
            [this](const QString& step, const std::function<void(Scenario&)>& edit) {
                change(step, [&](EditedScenario& state) { edit(state.scenario); });
            });
    connect(whole_, &ScenarioFields::finished, this, &EditPanel::finish);
    column->addWidget(whole_);
}

QToolButton* EditPanel::tableButton(const char* drawing, const char* name, const QString& tip) {
    auto* made = new QToolButton(this);
    made->setObjectName(name);
    made->setIcon(icon(drawing));
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setAutoRaise(true);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

void EditPanel::makePart(QVBoxLayout* column) {
    ofPart_ = new QWidget(this);
    auto* form = new QFormLayout(ofPart_);
    form->setContentsMargins(0, 0, 0, 0);
    name_ = new QLineEdit(ofPart_);
    name_->setObjectName("partName");
    form->addRow(tr("Name"), name_);
    mount_ = new MountFields(ofPart_);
    form->addRow(mount_);
    newTrajectory_ = textButton(tr("New trajectory"), "newTrajectory",
                                tr("A trajectory of its own, which begins where it is now: a file "
                                   "beside the scenario"));
    trajectoryFile_ =
        textButton(tr("Trajectory file…"), "trajectoryFile", tr("Follow the rows of a file"));
    standStill_ = textButton(tr("Stand still"), "standStill",
                             tr("Remove the trajectory and stand still where it begins"));
    auto* motion = new QHBoxLayout;
    for (QToolButton* button : {newTrajectory_, trajectoryFile_, standStill_})
        motion->addWidget(button);
    motion->addStretch(1);
    form->addRow(tr("Motion"), motion);
    where_ = new QLabel(ofPart_);
    where_->setObjectName("partPlace");
    where_->setWordWrap(true);
    where_->setForegroundRole(QPalette::PlaceholderText);
    form->addRow(where_);
    place_ = new PlaceFields(ofPart_);
    form->addRow(place_);
    column->addWidget(ofPart_);

    ofTable_ = new QWidget(this);
    rows_ = new TrajectoryModel(this);
    table_ = new TrajectoryView(*rows_, ofTable_);
    hold_ = new QCheckBox(tr("Stays at its ends"), ofTable_);
    hold_->setObjectName("holdEnds");
    hold_->setToolTip(
        tr("It is present before the first row and after the last one, rather than absent"));
    follows_ = new QLabel(ofTable_);
    follows_->setObjectName("partTrajectory");
    follows_->setForegroundRole(QPalette::PlaceholderText);
    follows_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(2);
    const auto add = [&](const char* drawing, const char* name, const QString& tip,
                         void (TrajectoryView::*does)()) {
        QToolButton* made = tableButton(drawing, name, tip);
        connect(made, &QToolButton::clicked, table_, does);
        bar->addWidget(made);
    };
    add("row-insert", "insertRow", tr("Insert a row before the current one (Insert)"),
        &TrajectoryView::insertRow);
    add("row-remove", "removeRows", tr("Remove the chosen rows (Delete)"),
        &TrajectoryView::removeRows);
    QToolButton* copy = tableButton("copy-table", "copyTable",
                                    tr("Copy all rows for a spreadsheet (Ctrl+C in the table "
                                       "copies the chosen cells)"));
    connect(copy, &QToolButton::clicked, table_, &TrajectoryView::copyAll);
    bar->addWidget(copy);
    add("paste-table", "pasteTable",
        tr("Paste rows from a spreadsheet in place of all rows (Ctrl+V in the table pastes at the "
           "current cell)"),
        &TrajectoryView::pasteAll);
    bar->addSpacing(6);
    bar->addWidget(follows_, 1);
    bar->addWidget(hold_);
    auto* rows = new QVBoxLayout(ofTable_);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addLayout(bar);
    rows->addWidget(table_, 1);
    column->addWidget(ofTable_, 1);

    connect(mount_, &MountFields::edited, this,
            [this](const QString& step, const std::function<void(EditedScenario&)>& edit) {
                change(step, edit);
                const QString problem = message_->text();
                finish();
                say(problem);
            });
    connect(newTrajectory_, &QToolButton::clicked, this, [this] { takeTrajectory(false); });
    connect(trajectoryFile_, &QToolButton::clicked, this, [this] { takeTrajectory(true); });
    connect(standStill_, &QToolButton::clicked, this, &EditPanel::letEntityStand);
    connect(name_, &QLineEdit::textEdited, this, &EditPanel::rename);
    connect(name_, &QLineEdit::editingFinished, this, &EditPanel::finish);
    connect(place_, &PlaceFields::finished, this, &EditPanel::finish);
    connect(place_, &PlaceFields::edited, this,
            [this](const irsg::Pose& pose, const QString& what) {
                const ScenarioPart part = this->part();
                change(tr("Set %1 of %2").arg(what, partName()), [&](EditedScenario& state) {
                    if (part.entity)
                        state.scenario.entities[*part.entity].pose = pose;
                    else if (part.sensor)
                        state.scenario.sensors[*part.sensor].offset = pose;
                });
            });
    connect(hold_, &QCheckBox::clicked, this, [this](bool hold) {
        const ScenarioPart part = this->part();
        change(tr("Change the ends of %1").arg(partName()), [&](EditedScenario& state) {
            if (part.entity)
                state.scenario.entities[*part.entity].hold = hold;
            else if (part.sensor)
                state.scenario.sensors[*part.sensor].hold = hold;
        });
        finish();
    });
    connect(
        rows_, &TrajectoryModel::edited, this,
        [this](const TrajectoryTable& table, const QString& step) {
            change(tr("%1: %2").arg(step, partName()), [&](EditedScenario& state) {
                state.trajectories[state.scenario.resolve(trajectoryOf(state.scenario, part()))] =
                    table;
            });
            finish();
        });
    connect(table_, &TrajectoryView::problem, this, &EditPanel::say);
}

ScenarioPart EditPanel::part() const {
    const int chosen = part_->currentIndex() - 1;
    const int entities = static_cast<int>(document_.scenario().entities.size());
    if (chosen < 0)
        return {};
    if (chosen < entities)
        return {.entity = static_cast<std::size_t>(chosen), .sensor = {}};
    return {.entity = {}, .sensor = static_cast<std::size_t>(chosen - entities)};
}

QString EditPanel::partName() const {
    return nameOf(document_.scenario(), part());
}

void EditPanel::follow() {
    const Scenario& scenario = document_.scenario();
    const QSignalBlocker quiet(part_);
    QStringList names{tr("Scenario")};
    for (const ScenarioEntity& entity : scenario.entities)
        names << textOf(entity.name);
    for (const ScenarioSensor& sensor : scenario.sensors)
        names << tr("%1 (sensor)").arg(textOf(sensor.name));
    const int chosen = std::clamp(part_->currentIndex(), 0, static_cast<int>(names.size()) - 1);
    while (part_->count() > names.size())
        part_->removeItem(part_->count() - 1);
    for (int i = 0; i < names.size(); ++i)
        if (i < part_->count())
            part_->setItemText(i, names[i]);
        else
            part_->addItem(names[i]);
    part_->setCurrentIndex(chosen);
    whole_->show(scenario);
    followPart();
}

void EditPanel::followPart() {
    const ScenarioPart part = this->part();
    const Scenario& scenario = document_.scenario();
    whole_->setVisible(!part.entity && !part.sensor);
    settings_->setEnabled(!part.entity);
    mount_->setVisible(part.sensor.has_value());
    ofPart_->setVisible(part.entity || part.sensor);
    remove_->setEnabled(part.entity || part.sensor);
    standStill_->setVisible(part.entity.has_value());
    standStill_->setEnabled(!trajectoryOf(scenario, part).empty());
    if (name_->text() != partName())
        name_->setText(partName());
    if (part.entity) {
        const ScenarioEntity& entity = scenario.entities[*part.entity];
        showPlace(entity.trajectory, entity.hold, entity.pose);
        place_->setVisible(entity.trajectory.empty());
        place_->showAttitude(true);
        where_->setVisible(entity.trajectory.empty());
        where_->setText(tr("Stands still here"));
    } else if (part.sensor) {
        const ScenarioSensor& sensor = scenario.sensors[*part.sensor];
        mount_->show(scenario, *part.sensor);
        showPlace(sensor.trajectory, sensor.hold, sensor.offset);
        place_->setVisible(true);
        place_->showAttitude(sensor.track.empty());
        QString words = tr("Stands still here");
        if (sensor.mount == MountKind::entity)
            words = tr("Carried by %1; positions are in its axes").arg(textOf(sensor.carrier));
        else if (sensor.mount == MountKind::trajectory)
            words = tr("Follows its trajectory, here in its axes");
        if (!sensor.track.empty())
            words += tr("; looks at %1").arg(textOf(sensor.track));
        where_->setVisible(true);
        where_->setText(words);
    } else {
        ofTable_->hide();
    }
}

void EditPanel::showPlace(const std::filesystem::path& trajectory, bool hold,
                          const irsg::Pose& pose) {
    place_->setPose(pose);
    ofTable_->setVisible(!trajectory.empty());
    if (trajectory.empty())
        return;
    QString words = tr("Follows %1").arg(textOf(trajectory));
    const QStringList others = followersOf(document_.scenario(), trajectory, partName());
    if (!others.isEmpty())
        words += tr(", and so does %1").arg(others.join(", "));
    follows_->setText(words);
    follows_->setToolTip(words);
    hold_->setChecked(hold);
    if (const TrajectoryTable* table = document_.now()->table(trajectory))
        rows_->setTable(*table);
}

void EditPanel::change(const QString& step, const std::function<void(EditedScenario&)>& edit) {
    if (gesture_ == ScenarioDocument::noGesture) {
        gesture_ = newGesture();
        before_ = document_.now();
    }
    say(document_.change(step, edit, gesture_));
}

void EditPanel::say(const QString& sentence) {
    message_->setStyleSheet(QStringLiteral("color: %1").arg(colors::errorText(palette()).name()));
    message_->setText(sentence);
    message_->setVisible(!sentence.isEmpty());
}

void EditPanel::finish() {
    if (before_ != nullptr && !message_->text().isEmpty())
        document_.edit(*before_, {}, gesture_);
    before_.reset();
    gesture_ = ScenarioDocument::noGesture;
    follow();
}

void EditPanel::rename(const QString& text) {
    const ScenarioPart part = this->part();
    const std::string name = text.trimmed().toStdString();
    if (name.empty())
        return say(tr("A name is needed"));
    change(tr("Rename %1").arg(part.entity ? tr("an entity") : tr("a sensor")),
           [&](EditedScenario& state) {
               Scenario& scenario = state.scenario;
               if (part.sensor)
                   scenario.sensors[*part.sensor].name = name;
               if (!part.entity)
                   return;
               // Those that know it by its name go along.
               const std::string before = scenario.entities[*part.entity].name;
               scenario.entities[*part.entity].name = name;
               for (ScenarioSensor& sensor : scenario.sensors)
                   for (std::string* known : {&sensor.carrier, &sensor.track})
                       if (*known == before)
                           *known = name;
           });
}

void EditPanel::choosePart(const ScenarioPart& part) {
    const auto entities = document_.scenario().entities.size();
    const std::size_t row = part.entity ? *part.entity + 1 : *part.sensor + entities + 1;
    part_->setCurrentIndex(static_cast<int>(row));
    followPart();
}

void EditPanel::addEntity() {
    const QString model = dialogs_.openFile(this, tr("Model of the entity"),
                                            {ProjectFiles::modelFilter(), tr("All files (*)")});
    if (model.isEmpty())
        return;
    const std::filesystem::path file = model.toStdString();
    std::filesystem::path database = file;
    database.replace_extension(".sigdb");
    std::error_code failure;
    if (!std::filesystem::exists(database, failure)) {
        const QString chosen =
            dialogs_.openFile(this, tr("Signature database of the entity"),
                              {tr("Signature databases (*.sigdb)"), tr("All files (*)")});
        if (chosen.isEmpty())
            return;
        database = chosen.toStdString();
    }
    std::size_t added = 0;
    change(tr("Add %1").arg(textOf(file.stem().string())),
           [&](EditedScenario& state) { added = smat::gui::addEntity(state, file, database); });
    const QString problem = message_->text();
    finish();
    if (problem.isEmpty())
        choosePart({.entity = added, .sensor = {}});
}

void EditPanel::addSensor() {
    const std::size_t like = part().sensor.value_or(0);
    std::size_t added = 0;
    change(tr("Add a sensor like %1").arg(textOf(document_.scenario().sensors[like].name)),
           [&](EditedScenario& state) { added = smat::gui::addSensor(state, like); });
    finish();
    choosePart({.entity = {}, .sensor = added});
    name_->setFocus();
    name_->selectAll();
}

void EditPanel::removeChosen() {
    const ScenarioPart part = this->part();
    if (!part.entity && !part.sensor)
        return;
    if (const QString why = whyNotRemoved(document_.scenario(), part); !why.isEmpty())
        return say(why);
    change(tr("Remove %1").arg(partName()),
           [&](EditedScenario& state) { removePart(state, part); });
    finish();
}

void EditPanel::takeTrajectory(bool fromFile) {
    const ScenarioPart part = this->part();
    QString problem;
    if (!fromFile) {
        change(tr("Give %1 a trajectory").arg(partName()),
               [&](EditedScenario& state) { giveTrajectory(state, part); });
        problem = message_->text();
    } else if (const QString file = dialogs_.openFile(this, tr("Trajectory of %1").arg(partName()),
                                                      {tr("Trajectories (*.csv)")});
               !file.isEmpty()) {
        try {
            change(tr("Let %1 follow %2").arg(partName(), QFileInfo(file).fileName()),
                   [&](EditedScenario& state) { followFile(state, part, file.toStdString()); });
            problem = message_->text();
        } catch (const irsg::InputError& error) {
            problem = sentencesOf(error).join('\n');
        }
    }
    finish();
    say(problem);
}

void EditPanel::letEntityStand() {
    const ScenarioPart part = this->part();
    if (!part.entity)
        return;
    change(tr("Let %1 stand still").arg(partName()),
           [&](EditedScenario& state) { letStand(state, *part.entity); });
    finish();
}

} // namespace smat::gui

#include "moc_EditPanel.cpp"
