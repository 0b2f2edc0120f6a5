#include "gui/workbench/PaintedModels.h"

#include <algorithm>

#include <QCoreApplication>
#include <QUndoStack>

#include "gui/start/DataFolder.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

constexpr int paintStepId = 0x300;
constexpr int paintRecovery_ms = 1500;

fs::path recoveryOf(const fs::path& model) {
    return placeForUnsaved(irsg::codesFileOf(model)).string() + ".recovery";
}

std::unique_ptr<QLockFile> paintLockOf(const fs::path& model) {
    auto lock = std::make_unique<QLockFile>(
        QString::fromStdString(placeForUnsaved(irsg::codesFileOf(model)).string() + ".lock"));
    lock->setStaleLockTime(0); // only that of a process that is gone
    return lock;
}

} // namespace

/// One painting before and after.
class PaintedModels::Step : public QUndoCommand {
  public:
    Step(PaintedModels& models, const QString& name, fs::path model,
         std::shared_ptr<const Surfaces> before, std::shared_ptr<const Surfaces> after)
        : QUndoCommand(name),
          models_(models),
          model_(std::move(model)),
          before_(std::move(before)),
          after_(std::move(after)) {}
    int id() const override { return paintStepId; }
    void undo() override { models_.apply(model_, before_); }
    void redo() override { models_.apply(model_, after_); }

  private:
    PaintedModels& models_;
    fs::path model_;
    std::shared_ptr<const Surfaces> before_, after_;
};

PaintedModels::PaintedModels(QUndoStack& undoStack, std::shared_ptr<ModelStore> models,
                             QObject* parent)
    : QObject(parent), undoStack_(undoStack), models_(std::move(models)) {
    recoveryTimer_.setSingleShot(true);
    recoveryTimer_.setInterval(paintRecovery_ms);
    connect(&recoveryTimer_, &QTimer::timeout, this, &PaintedModels::writeRecoveryNow);
}

PaintedModels::~PaintedModels() {
    blockSignals(true);
    writeRecoveryNow();
}

PaintedModels::Painting& PaintedModels::painting(const fs::path& model) {
    const auto known = paintings_.find(model);
    const auto stamp = irsg::stampOf(irsg::codesFileOf(model));
    if (known != paintings_.end() && (known->second.stamp == stamp || known->second.isDirty()))
        return known->second;
    auto read = std::make_shared<const Surfaces>(irsg::readModelCodes(model).painted);
    Painting& painting = paintings_[model];
    painting.now = painting.saved = std::move(read);
    painting.stamp = stamp;
    return painting;
}

std::shared_ptr<const PaintedModels::Surfaces> PaintedModels::of(const fs::path& model) {
    return painting(model).now;
}

void PaintedModels::edit(const fs::path& model, Surfaces after, const QString& step) {
    const auto before = of(model);
    if (*before != after)
        undoStack_.push(new Step(*this, step, model, before,
                                 std::make_shared<const Surfaces>(std::move(after))));
}

void PaintedModels::apply(const fs::path& model, std::shared_ptr<const Surfaces> surfaces) {
    Painting& of = paintings_[model];
    if (!of.saved)
        of.saved = std::make_shared<const Surfaces>();
    of.now = std::move(surfaces);
    follow(model, of);
}

/// What follows from another painting, or another one that is saved.
void PaintedModels::follow(const fs::path& model, Painting& painting) {
    if (painting.isDirty()) {
        models_->setPainted(model, painting.now);
        recoveryTimer_.start();
    } else {
        models_->setPainted(model, nullptr);
        removeRecovery(painting);
    }
    emit changed(model);
    emit stateChanged();
}

bool PaintedModels::isDirty() const {
    return std::ranges::any_of(paintings_, [](const auto& one) { return one.second.isDirty(); });
}

QStringList PaintedModels::unsaved() const {
    QStringList names;
    for (const auto& [model, painting] : paintings_)
        if (painting.isDirty())
            names << QString::fromStdString(model.filename().string());
    return names;
}

std::vector<fs::path> PaintedModels::changedOutside() const {
    std::vector<fs::path> changed;
    for (const auto& [model, painting] : paintings_) {
        const auto file = irsg::codesFileOf(model);
        if (!painting.isDirty() || painting.stamp == irsg::stampOf(file))
            continue;
        try {
            if (irsg::readModelCodes(model).painted != *painting.saved)
                changed.push_back(file);
        } catch (const irsg::InputError&) {
            changed.push_back(file);
        }
    }
    return changed;
}

void PaintedModels::save() {
    for (auto& [model, painting] : paintings_) {
        if (!painting.isDirty())
            continue;
        // A damaged file is refused here: its rules would be lost.
        irsg::ModelCodes codes = irsg::readModelCodes(model);
        codes.painted = *painting.now;
        irsg::saveModelCodes(codes, model);
        painting.saved = painting.now;
        painting.stamp = irsg::stampOf(irsg::codesFileOf(model));
        models_->setPainted(model, nullptr);
        removeRecovery(painting);
    }
    emit stateChanged();
}

void PaintedModels::discard() {
    for (auto& [model, painting] : paintings_)
        if (painting.isDirty()) {
            painting.now = painting.saved;
            follow(model, painting);
        }
}

void PaintedModels::clear() {
    writeRecoveryNow();
    for (const auto& [model, painting] : paintings_)
        if (painting.isDirty())
            models_->setPainted(model, nullptr);
    paintings_.clear();
    emit stateChanged();
}

void PaintedModels::removeRecovery(Painting& painting) {
    std::error_code ignored;
    if (!painting.recovery.empty())
        fs::remove(painting.recovery, ignored);
    painting.recovery.clear();
    painting.lock.reset();
}

std::optional<fs::path> PaintedModels::leftBehind(const fs::path& model) {
    const fs::path first = recoveryOf(model);
    const auto lock = paintLockOf(model);
    if (!lock->tryLock(0) && lock->error() == QLockFile::LockFailedError)
        return std::nullopt;
    std::optional<fs::path> newest;
    std::error_code ignored;
    const std::string beginning = first.filename().string();
    for (const auto& entry : fs::directory_iterator(first.parent_path(), ignored))
        if (entry.is_regular_file(ignored) &&
            entry.path().filename().string().starts_with(beginning) &&
            (!newest ||
             fs::last_write_time(*newest, ignored) < fs::last_write_time(entry.path(), ignored)))
            newest = entry.path();
    return newest;
}

void PaintedModels::recover(const fs::path& model, const fs::path& copy) {
    auto codes = irsg::modelCodesFromJson(irsg::readFile(copy), copy.string());
    edit(model, std::move(codes.painted), tr("Recover what was painted"));
    // At no moment is it without a copy.
    writeRecoveryNow();
    const auto own = paintings_.find(model);
    std::error_code ignored;
    if (own == paintings_.end() || !own->second.isDirty() ||
        (!own->second.recovery.empty() && own->second.recovery != copy))
        fs::remove(copy, ignored);
}

void PaintedModels::writeRecoveryNow() {
    recoveryTimer_.stop();
    for (auto& [model, painting] : paintings_) {
        if (!painting.isDirty())
            continue;
        if (!painting.lock) {
            painting.lock = paintLockOf(model);
            painting.lock->tryLock(0);
        }
        if (painting.recovery.empty()) {
            // Neither that of another window nor one that waits for a decision is written over.
            const fs::path first = recoveryOf(model);
            std::error_code none;
            const bool free = painting.lock->isLocked() && !fs::exists(first, none);
            painting.recovery = free ? first
                                     : fs::path(first.string() + "-" +
                                                std::to_string(QCoreApplication::applicationPid()));
        }
        try {
            irsg::writeFileDurably(painting.recovery, irsg::modelCodesToJson({{}, *painting.now}));
        } catch (const irsg::InputError&) {
            // The copy of the project says why its folder cannot be written to.
            painting.recovery.clear();
        }
    }
}

} // namespace smat::gui

#include "moc_PaintedModels.cpp"
