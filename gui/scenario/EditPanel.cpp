#include "gui/scenario/EditPanel.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
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
#include "gui/widgets/Theme.h"
#include "gui/widgets/ThemeColors.h"
#include "gui/widgets/Widgets.h"

namespace smat::gui {
namespace {

constexpr double newEntityBeside_m = 50.0;

/// The name, or "sphere-2" where another entity has it.
std::string freeName(const Scenario& scenario, const std::string& wanted) {
    std::string name = wanted;
    for (int number = 2; scenario.findEntity(name); ++number)
        name = wanted + "-" + std::to_string(number);
    return name;
}

/// Beside the first of the scenario, where it begins.
irsg::Pose placeOfNew(const EditedScenario& state) {
    const ScenarioEntity& first = state.scenario.entities.front();
    irsg::Pose pose = first.pose;
    if (const TrajectoryTable* table = state.table(first.trajectory);
        !first.trajectory.empty() && table != nullptr)
        pose = Trajectory(*table).points().front().pose;
    pose.position_m.x += newEntityBeside_m;
    return pose;
}

/// Who else follows the same trajectory.
QStringList followersOf(const Scenario& scenario, const std::filesystem::path& trajectory,
                        const QString& but) {
    QStringList names;
    const auto take = [&](const auto& parts) {
        for (const auto& part : parts)
            if (part.trajectory == trajectory && textOf(part.name) != but)
                names << textOf(part.name);
    };
    take(scenario.entities);
    take(scenario.sensors);
    return names;
}

} // namespace

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
    remove_ = textButton(tr("Remove"), "removeEntity", tr("Remove this entity"));
    auto* first = new QHBoxLayout;
    first->addWidget(part_, 1);
    first->addWidget(settings_);
    first->addWidget(add_);
    first->addWidget(remove_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 8);
    column->addLayout(first);
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
    connect(remove_, &QToolButton::clicked, this, &EditPanel::removeEntity);
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
    hold_->setToolTip(tr("Before the first row and after the last one it is there, and not gone"));
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
    connect(name_, &QLineEdit::textEdited, this, &EditPanel::rename);
    connect(name_, &QLineEdit::editingFinished, this, &EditPanel::finish);
    connect(place_, &PlaceFields::finished, this, &EditPanel::finish);
    connect(place_, &PlaceFields::edited, this,
            [this](const irsg::Pose& pose, const QString& what) {
                const Part part = this->part();
                change(tr("Set %1 of %2").arg(what, partName()), [&](EditedScenario& state) {
                    if (part.entity)
                        state.scenario.entities[*part.entity].pose = pose;
                    else if (part.sensor)
                        state.scenario.sensors[*part.sensor].offset = pose;
                });
            });
    connect(hold_, &QCheckBox::clicked, this, [this](bool hold) {
        const Part part = this->part();
        change(tr("Change the ends of %1").arg(partName()), [&](EditedScenario& state) {
            if (part.entity)
                state.scenario.entities[*part.entity].hold = hold;
            else if (part.sensor)
                state.scenario.sensors[*part.sensor].hold = hold;
        });
        finish();
    });
    connect(rows_, &TrajectoryModel::edited, this,
            [this](const TrajectoryTable& table, const QString& step) {
                change(tr("%1: %2").arg(step, partName()), [&](EditedScenario& state) {
                    state.trajectories[state.scenario.resolve(trajectoryOf(state))] = table;
                });
                finish();
            });
    connect(table_, &TrajectoryView::problem, this, &EditPanel::say);
}

EditPanel::Part EditPanel::part() const {
    const int chosen = part_->currentIndex() - 1;
    const int entities = static_cast<int>(document_.scenario().entities.size());
    if (chosen < 0)
        return {};
    if (chosen < entities)
        return {.entity = static_cast<std::size_t>(chosen), .sensor = {}};
    return {.entity = {}, .sensor = static_cast<std::size_t>(chosen - entities)};
}

std::filesystem::path EditPanel::trajectoryOf(const EditedScenario& state) const {
    const Part part = this->part();
    if (part.entity)
        return state.scenario.entities[*part.entity].trajectory;
    return part.sensor ? state.scenario.sensors[*part.sensor].trajectory : std::filesystem::path();
}

QString EditPanel::partName() const {
    const Part part = this->part();
    if (part.entity)
        return textOf(document_.scenario().entities[*part.entity].name);
    return part.sensor ? textOf(document_.scenario().sensors[*part.sensor].name) : QString();
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
    const Part part = this->part();
    const Scenario& scenario = document_.scenario();
    whole_->setVisible(!part.entity && !part.sensor);
    settings_->setEnabled(!part.entity);
    mount_->setVisible(part.sensor.has_value());
    ofPart_->setVisible(part.entity || part.sensor);
    remove_->setEnabled(part.entity.has_value());
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
            words = tr("Rides on %1, here in its axes").arg(textOf(sensor.carrier));
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
    const Part part = this->part();
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
    const std::string name = freeName(document_.scenario(), file.stem().string());
    change(tr("Add %1").arg(textOf(name)), [&](EditedScenario& state) {
        ScenarioEntity entity;
        entity.name = name;
        entity.model = file;
        entity.database = database;
        entity.pose = placeOfNew(state);
        state.scenario.entities.push_back(entity);
    });
    if (const auto place = document_.scenario().findEntity(name))
        part_->setCurrentIndex(static_cast<int>(*place) + 1);
    finish();
}

void EditPanel::removeEntity() {
    const Part part = this->part();
    if (!part.entity)
        return;
    const Scenario& scenario = document_.scenario();
    const std::string name = scenario.entities[*part.entity].name;
    if (scenario.entities.size() == 1)
        return say(tr("A scenario needs at least one entity"));
    for (const ScenarioSensor& sensor : scenario.sensors) {
        if (sensor.carrier == name)
            return say(tr("%1 rides on it").arg(textOf(sensor.name)));
        if (sensor.track == name)
            return say(tr("%1 looks at it").arg(textOf(sensor.name)));
    }
    change(tr("Remove %1").arg(textOf(name)), [&](EditedScenario& state) {
        const std::filesystem::path path = trajectoryOf(state);
        state.scenario.entities.erase(state.scenario.entities.begin() +
                                      static_cast<std::ptrdiff_t>(*part.entity));
        if (followersOf(state.scenario, path, {}).isEmpty())
            state.trajectories.erase(state.scenario.resolve(path));
    });
    finish();
}

} // namespace smat::gui

#include "moc_EditPanel.cpp"
