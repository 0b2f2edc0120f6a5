#include "gui/workbench/EditSteps.h"

#include <algorithm>

#include <QUndoCommand>

#include "gui/widgets/NumberFormat.h"
#include "smatcore/settings/SettingInfo.h"

namespace smat::gui {
namespace {

constexpr int stepPause_ms = 1500; ///< after which the same setting begins a new step
constexpr int commandId = 0x100;

/// "Set range to 1200 m".
QString stepOf(const std::string& key, const std::string& value) {
    const SettingInfo& info = settingInfo(key);
    QString label = QString::fromStdString(info.label);
    if (label.size() < 2 || !label.at(1).isUpper())
        label.replace(0, 1, label.left(1).toLower());
    QString text = QString::fromStdString(value.empty() ? "nothing" : value);
    if (info.kind == SettingKind::boolean)
        return (value == "true" ? EditSteps::tr("Switch %1 on") : EditSteps::tr("Switch %1 off"))
            .arg(label);
    if (const QString unit = formattedUnit(info.unit); !unit.isEmpty())
        text += (unit == "°" ? "" : " ") + unit;
    return EditSteps::tr("Set %1 to %2").arg(label, text.size() > 40 ? text.left(39) + "…" : text);
}

} // namespace

std::vector<std::string> keysThatDiffer(const Settings& one, const Settings& other) {
    std::vector<std::string> keys;
    for (const auto& info : settingTable())
        if (one.text(info.key) != other.text(info.key))
            keys.push_back(info.key);
    return keys;
}

bool areOfCamera(const std::vector<std::string>& keys) {
    return std::all_of(keys.begin(), keys.end(),
                       [](const auto& key) { return key.starts_with("camera."); });
}

QString stepBetween(const Settings& before, const Settings& after) {
    const auto keys = keysThatDiffer(before, after);
    return keys.size() == 1    ? stepOf(keys.front(), after.text(keys.front()))
           : areOfCamera(keys) ? EditSteps::tr("Move the camera")
                               : EditSteps::tr("Change %1 settings").arg(keys.size());
}

EditSteps::EditSteps(QUndoStack& stack, std::function<void(const Project&)> apply, QObject* parent)
    : QObject(parent), stack_(stack), apply_(std::move(apply)) {
    pause_.setSingleShot(true);
    pause_.setInterval(stepPause_ms);
    connect(&pause_, &QTimer::timeout, this, [this] { separate(); });
}

/// Everything before and after; the same setting changed again becomes one with the last change.
class EditSteps::Command : public QUndoCommand {
  public:
    Command(EditSteps& steps, Project before, Project after, std::string mergeKey)
        : steps_(steps),
          before_(std::move(before)),
          after_(std::move(after)),
          mergeKey_(std::move(mergeKey)),
          step_(steps.step_) {}
    int id() const override { return commandId; }
    void undo() override {
        steps_.separate();
        steps_.apply_(before_);
    }
    void redo() override { steps_.apply_(after_); }
    bool mergeWith(const QUndoCommand* command) override {
        const auto* later = dynamic_cast<const Command*>(command);
        if (later == nullptr || later->step_ != step_ || later->mergeKey_ != mergeKey_)
            return false;
        after_ = later->after_;
        setText(before_.settings == after_.settings || mergeKey_.starts_with("models")
                    ? later->text()
                    : stepBetween(before_.settings, after_.settings));
        setObsolete(before_ == after_);
        return true;
    }

  private:
    EditSteps& steps_;
    Project before_, after_;
    std::string mergeKey_;
    int step_;
};

void EditSteps::push(const Project& before, const Project& after, const QString& name,
                     const std::string& mergeKey) {
    auto command = std::make_unique<Command>(*this, before, after, mergeKey);
    command->setText(name);
    stack_.push(command.release());
    if (!isHeld_)
        pause_.start();
}

void EditSteps::pushAlone(const Project& before, const Project& after, const QString& name,
                          const std::string& mergeKey) {
    separate();
    push(before, after, name, mergeKey);
    separate();
}

void EditSteps::hold() {
    separate();
    isHeld_ = true;
    pause_.stop();
}

void EditSteps::close() {
    separate();
    isHeld_ = false;
}

} // namespace smat::gui

#include "moc_EditSteps.cpp"
