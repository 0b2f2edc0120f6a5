#include "gui/scenario/ScenarioDocument.h"

#include <algorithm>

#include "gui/start/DataFolder.h"
#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "smatcore/simulate/ScenarioFile.h"
#include "smatcore/support/TextFile.h"

namespace smat::gui {
namespace {

/// Calls `use` with every path of a trajectory in a scenario.
template <typename Scenario, typename Use>
void eachTrajectory(Scenario& scenario, const Use& use) {
    for (auto& entity : scenario.entities)
        if (!entity.trajectory.empty())
            use(entity.trajectory);
    for (auto& sensor : scenario.sensors)
        if (sensor.mount == MountKind::trajectory)
            use(sensor.trajectory);
}

EditedScenario readAll(const std::filesystem::path& file) {
    EditedScenario read{loadScenario(file), {}};
    std::vector<irsg::Diagnostic> diagnostics;
    eachTrajectory(read.scenario, [&](const std::filesystem::path& path) {
        const std::filesystem::path at = read.scenario.resolve(path);
        if (read.trajectories.contains(at))
            return;
        TrajectoryTable& table = read.trajectories[at]; // empty where it is refused, which is once
        irsg::collect(diagnostics, [&] { table = TrajectoryTable::read(at); });
    });
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
    return read;
}

/// "far.csv", or "far-2.csv" where that holds something else than these rows.
std::filesystem::path freePlace(const std::filesystem::path& wanted, const TrajectoryTable& table,
                                const EditedTrajectories& taken) {
    std::filesystem::path place = wanted;
    for (int number = 2;; ++number) {
        std::error_code failure;
        const bool exists = std::filesystem::exists(place, failure);
        if (!taken.contains(place) && (!exists || readTextFile(place) == table.text()))
            return place;
        place = wanted.parent_path() / (wanted.stem().string() + "-" + std::to_string(number) +
                                        wanted.extension().string());
    }
}

std::optional<irsg::FileStamp>
stampIn(const std::map<std::filesystem::path, irsg::FileStamp>& stamps,
        const std::filesystem::path& file) {
    const auto found = stamps.find(file);
    return found == stamps.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

const TrajectoryTable* EditedScenario::table(const std::filesystem::path& file) const {
    const auto found = trajectories.find(scenario.resolve(file));
    return found == trajectories.end() ? nullptr : &found->second;
}

ScenarioDocument::ScenarioDocument(const std::filesystem::path& file, QUndoStack& undoStack,
                                   QObject* parent)
    : QObject(parent),
      undoStack_(undoStack),
      now_(std::make_shared<const EditedScenario>(
          readAll(std::filesystem::absolute(file).lexically_normal()))),
      saved_(*now_),
      apply_(std::make_shared<DocumentStep<EditedScenario>::Apply>(
          [this](const EditedScenario& state) { apply(state); })) {
    noteStamps();
}

ScenarioDocument::~ScenarioDocument() {
    *apply_ = nullptr;
}

void ScenarioDocument::edit(EditedScenario after, const QString& step, int gesture) {
    if (after == *now_)
        return;
    auto* command = new DocumentStep<EditedScenario>(
        apply_, undoStack_, now_, std::make_shared<const EditedScenario>(std::move(after)),
        gesture);
    command->setText(step);
    undoStack_.push(command);
}

QString ScenarioDocument::change(const QString& step,
                                 const std::function<void(EditedScenario&)>& edit, int gesture) {
    EditedScenario after = *now_;
    edit(after);
    if (after == *now_)
        return {};
    try {
        // The reader has the rules.
        scenarioFromJson(scenarioToJson(after.scenario, file()), file());
    } catch (const irsg::InputError& error) {
        const irsg::Diagnostic& first = error.diagnostics().front();
        return neededInstead(withFormattedUnits(textOf(first.expected)), textOf(first.value));
    }
    this->edit(std::move(after), step, gesture);
    return {};
}

void ScenarioDocument::apply(const EditedScenario& state) {
    take(state.scenario.file == file() ? state : movedTo(state, file()));
}

void ScenarioDocument::take(EditedScenario state) {
    now_ = std::make_shared<const EditedScenario>(std::move(state));
    emit changed();
    emit stateChanged();
}

EditedScenario ScenarioDocument::movedTo(const EditedScenario& state,
                                         const std::filesystem::path& file) const {
    EditedScenario moved;
    moved.scenario = scenarioFromJson(scenarioToJson(state.scenario, file), file);
    for (const auto& [at, table] : state.trajectories) {
        const auto place = moved_.find(at);
        moved.trajectories[place == moved_.end() ? at : place->second] = table;
    }
    eachTrajectory(moved.scenario, [&](std::filesystem::path& path) {
        const auto place = moved_.find(moved.scenario.resolve(path));
        if (place != moved_.end())
            path = place->second.lexically_relative(file.parent_path());
    });
    return moved;
}

bool ScenarioDocument::isChangedOnDisk() const {
    return std::ranges::any_of(stamps_, [](const auto& stamp) {
        const auto now = irsg::stampOf(stamp.first);
        return now && now != stamp.second;
    });
}

void ScenarioDocument::noteStamps() {
    stamps_.clear();
    const auto note = [&](const std::filesystem::path& at) {
        if (const auto stamp = irsg::stampOf(at))
            stamps_[at] = *stamp;
    };
    note(file());
    for (const auto& [at, table] : now_->trajectories)
        note(at);
}

void ScenarioDocument::save() {
    saveAs(file());
}

void ScenarioDocument::saveAs(const std::filesystem::path& file) {
    const auto absolute = std::filesystem::absolute(file).lexically_normal();
    requireOwnPlace(absolute);
    const bool staysHere = absolute.parent_path() == this->file().parent_path();
    const auto movedBefore = moved_;
    EditedTrajectories written;
    for (const auto& [at, table] : now_->trajectories) {
        if (!staysHere) {
            // It comes along.
            const auto place = freePlace(absolute.parent_path() / at.filename(), table, written);
            moved_[at] = place;
            written[place] = table;
        } else if (!saved_.trajectories.contains(at) || saved_.trajectories.at(at) != table) {
            requireOwnPlace(at);
            written[at] = table;
        }
    }
    try {
        EditedScenario moved = movedTo(*now_, absolute);
        for (const auto& [at, table] : written)
            writeTextFile(at, table.text());
        // A file that says the same stays as its writer laid it out.
        if (absolute != this->file() || moved.scenario != saved_.scenario ||
            irsg::stampOf(absolute) != stampIn(stamps_, absolute))
            saveScenario(moved.scenario, absolute);
        saved_ = moved;
        take(std::move(moved));
    } catch (const irsg::InputError&) {
        moved_ = movedBefore;
        throw;
    }
    noteStamps();
    emit stateChanged();
}

} // namespace smat::gui

#include "moc_ScenarioDocument.cpp"
