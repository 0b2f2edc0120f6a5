#include "gui/database/DatabaseSession.h"

#include <algorithm>

#include <QCoreApplication>
#include <QFile>
#include <QUndoStack>

#include "gui/start/DataFolder.h"
#include "gui/widgets/Sentences.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReading.h"
#include "irsg/core/FileReplacement.h"

namespace smat::gui {
namespace {

namespace fs = std::filesystem;

constexpr int stepId = 0x200;
constexpr int recoveryDelay_ms = 1500;

bool isWriteProtected(const fs::path& file) {
    constexpr auto anyWrite =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    std::error_code failure;
    const auto status = fs::status(file, failure);
    return fs::exists(status) && (status.permissions() & anyWrite) == fs::perms::none;
}

irsg::SignatureDatabase readDraft(const fs::path& file) {
    return irsg::signatureFromJson(irsg::readFile(file), file.string(), irsg::LintErrors::accept);
}

} // namespace

/// One step: what differs, and the session that it belongs to.
class DatabaseSession::Step : public QUndoCommand {
  public:
    Step(DatabaseSession& session, const QString& name, DatabaseChange change, QString mergeKey)
        : QUndoCommand(name),
          session_(session),
          change_(std::move(change)),
          mergeKey_(std::move(mergeKey)),
          gesture_(session.gesture_),
          taken_(session.taken_) {}

    int id() const override { return stepId; }
    void redo() override { apply(true); }
    void undo() override { apply(false); }
    bool mergeWith(const QUndoCommand* command) override {
        const auto& next = static_cast<const Step&>(*command);
        if (mergeKey_.isEmpty() || next.mergeKey_ != mergeKey_ || next.gesture_ != gesture_ ||
            next.taken_ != taken_)
            return false;
        change_.append(next.change_);
        setText(next.text());
        setObsolete(change_.isEmpty());
        return true;
    }

  private:
    void apply(bool forward) {
        if (session_.bring(taken_))
            session_.apply(change_, forward);
        else
            setObsolete(true);
    }

    DatabaseSession& session_;
    DatabaseChange change_;
    QString mergeKey_;
    int gesture_, taken_;
};

DatabaseSession::DatabaseSession(QUndoStack& undoStack, QObject* parent)
    : QObject(parent), undoStack_(undoStack) {
    recoveryTimer_.setSingleShot(true);
    recoveryTimer_.setInterval(recoveryDelay_ms);
    connect(&recoveryTimer_, &QTimer::timeout, this, &DatabaseSession::writeRecoveryNow);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, [this] {
        watch();
        if (isChangedOnDisk())
            emit changedOnDisk();
    });
}

DatabaseSession::~DatabaseSession() {
    // Edits that were not saved stay in their copy: closing asks before it comes to this.
    blockSignals(true);
    if (dirty_)
        writeRecoveryNow(); // the others have theirs
}

void DatabaseSession::open(const fs::path& file, irsg::OutsideChanges outside) {
    if (takeFromOthers(fs::absolute(file).lexically_normal()))
        return;
    // What is physically wrong is shown, to be repaired; only saving refuses it.
    auto loaded = irsg::loadSignatureFile(file, outside, irsg::LintErrors::accept);
    const bool accepted = !loaded.changedOutside.empty();
    take(file, loaded.database, loaded.database);
    acceptedOutside_ = accepted;
    refresh();
    emit opened();
}

void DatabaseSession::create(const fs::path& file, irsg::SignatureDatabase value) {
    take(file, std::move(value), std::nullopt);
    refresh();
    emit opened();
}

void DatabaseSession::close() {
    leaveOrKeepOpen({});
    taken_ = ++lastTaken_;
    value_ = saved_ = nullptr;
    file_.clear();
    left_.clear();
    dirty_ = isNew_ = acceptedOutside_ = false;
    watch();
    emit opened();
    emit stateChanged();
}

void DatabaseSession::take(const fs::path& file, irsg::SignatureDatabase value,
                           std::optional<irsg::SignatureDatabase> saved) {
    const fs::path next = fs::absolute(file).lexically_normal();
    leaveOrKeepOpen(next);
    others_.erase(next);
    taken_ = ++lastTaken_;
    file_ = next;
    value_ = std::make_shared<const irsg::SignatureDatabase>(std::move(value));
    isNew_ = !saved;
    acceptedOutside_ = false;
    saved_ = isNew_ ? std::make_shared<const irsg::SignatureDatabase>() : value_;
    stamp_ = irsg::stampOf(file_);
    access_ = isWriteProtected(file_) ? Access::readOnly : Access::edit;
    dirty_ = false;
    ++gesture_;
    findRecoveries();
    watch();
}

const irsg::SignatureDatabase& DatabaseSession::value() const {
    if (!value_)
        throw irsg::LogicError("no signature database is open");
    return *value_;
}

std::shared_ptr<const irsg::SignatureDatabase> DatabaseSession::snapshot() const {
    value();
    return value_;
}

const irsg::SignatureDatabase& DatabaseSession::saved() const {
    value();
    return *saved_;
}

QString DatabaseSession::accessNote() const {
    const QString name = QString::fromStdString(file_.filename().string());
    switch (access_) {
    case Access::edit:
        return {};
    case Access::readOnly:
        return tr("%1 is write-protected. Edits can be saved under another name.").arg(name);
    case Access::openElsewhere:
        return tr("%1 is being edited in another window (%2). Edits made here can be saved under "
                  "another name.")
            .arg(name, otherWindow_);
    }
    return {};
}

void DatabaseSession::edit(const QString& step, const Edit& change, const QString& mergeKey) {
    auto after = value();
    change(after);
    auto difference = DatabaseChange::between(*value_, after);
    if (!difference.isEmpty())
        undoStack_.push(new Step(*this, step, std::move(difference), mergeKey));
}

void DatabaseSession::apply(const DatabaseChange& change, bool forward) {
    auto after = value();
    forward ? change.redo(after) : change.undo(after);
    value_ = std::make_shared<const irsg::SignatureDatabase>(std::move(after));
    refresh();
    emit changed(change.places());
}

/// What follows from a new value or a new saved one.
void DatabaseSession::refresh() {
    dirty_ = isNew_ || acceptedOutside_ || !(*value_ == *saved_);
    if (dirty_) {
        lock();
        recoveryTimer_.start();
    } else {
        recoveryTimer_.stop();
        removeRecovery();
        lock_.reset();
        access_ = isWriteProtected(file_) ? Access::readOnly : Access::edit;
    }
    emit stateChanged();
}

void DatabaseSession::lock() {
    if (lock_ && lock_->isLocked())
        return;
    if (!lock_) {
        lock_ = std::make_unique<QLockFile>(
            QString::fromStdString(placeForUnsaved(file_).string() + ".lock"));
        lock_->setStaleLockTime(0);
    }
    // A folder that takes no file does not take the database either: saving says so.
    if (lock_->tryLock(0) || lock_->error() != QLockFile::LockFailedError) {
        access_ = isWriteProtected(file_) ? Access::readOnly : Access::edit;
        return;
    }
    qint64 process = 0;
    QString host, program;
    lock_->getLockInfo(&process, &host, &program);
    otherWindow_ = tr("process %1 on %2").arg(process).arg(host);
    access_ = Access::openElsewhere;
}

void DatabaseSession::save() {
    value();
    if (isChangedOnDisk())
        throw irsg::InputError({file_.string(), "", "a file that another program has changed",
                                "the content that was read, or a decision whose version stays"});
    lock();
    if (access_ == Access::openElsewhere)
        throw irsg::InputError({file_.string(), "",
                                "edits in another window, " + otherWindow_.toStdString(),
                                "a file that nobody else edits, or "
                                "another name"});
    writeTo(file_);
    refresh();
}

void DatabaseSession::overwrite() {
    value();
    try {
        // What is there now is known, and given up.
        saved_ = std::make_shared<const irsg::SignatureDatabase>(
            irsg::loadSignatureFile(file_, irsg::OutsideChanges::accept, irsg::LintErrors::accept)
                .database);
        isNew_ = false;
    } catch (const irsg::InputError&) {
        // Nothing is there, or nothing that can be read: saving says so.
    }
    save();
}

void DatabaseSession::saveAs(const fs::path& file) {
    value();
    const fs::path target = fs::absolute(file).lexically_normal();
    if (target == file_) {
        overwrite();
        return;
    }
    writeTo(target);
    removeRecovery();
    lock_.reset();
    file_ = target;
    findRecoveries();
    watch();
    refresh();
}

void DatabaseSession::writeTo(const fs::path& file) {
    requireOwnPlace(file);
    // Another program may have saved since the last look at the file: its own then refuses.
    if (file == file_ && !isNew_)
        irsg::saveSignatureFile(*value_, file, *saved_);
    else
        irsg::saveSignatureFile(*value_, file);
    saved_ = value_;
    isNew_ = acceptedOutside_ = false;
    stamp_ = irsg::stampOf(file);
    ++gesture_;
}

bool DatabaseSession::isChangedOnDisk() const {
    const auto now = irsg::stampOf(file_);
    // A file that is gone is made again by the next save.
    if (!isOpen() || !now || now == stamp_)
        return false;
    if (isNew_)
        return true;
    try {
        return !(
            irsg::loadSignatureFile(file_, irsg::OutsideChanges::accept, irsg::LintErrors::accept)
                .database == *saved_);
    } catch (const irsg::InputError&) {
        return true;
    }
}

void DatabaseSession::reload() {
    auto loaded =
        irsg::loadSignatureFile(file_, irsg::OutsideChanges::refuse, irsg::LintErrors::accept);
    dirty_ = false; // given up: no copy of the edits stays
    take(fs::path(file_), loaded.database, loaded.database);
    refresh();
    emit opened();
}

/// Edits that nobody gave up stay in their copy and are offered again with their file.
void DatabaseSession::leave() {
    if (isOpen() && dirty_) {
        writeRecoveryNow();
        recovery_.clear();
    }
    removeRecovery();
    lock_.reset();
}

void DatabaseSession::discard() {
    if (isNew_) {
        dirty_ = false;
        close();
        return;
    }
    taken_ = ++lastTaken_;
    acceptedOutside_ = false;
    const auto change = DatabaseChange::between(value(), *saved_);
    value_ = saved_;
    refresh();
    emit changed(change.places());
}

void DatabaseSession::watch() {
    if (!watcher_.files().isEmpty())
        watcher_.removePaths(watcher_.files());
    if (const QString name = QString::fromStdString(file_.string()); QFile::exists(name))
        watcher_.addPath(name);
}

void DatabaseSession::findRecoveries() {
    left_.clear();
    recovery_.clear();
    // Copies that an open window is keeping are not left ones.
    const fs::path place = placeForUnsaved(file_);
    QLockFile probe(QString::fromStdString(place.string() + ".lock"));
    probe.setStaleLockTime(0);
    if (!probe.tryLock(0) && probe.error() == QLockFile::LockFailedError)
        return;
    const std::string beginning = place.filename().string() + ".recovery";
    std::error_code failure;
    for (const auto& entry : fs::directory_iterator(place.parent_path(), failure))
        if (entry.is_regular_file(failure) &&
            entry.path().filename().string().starts_with(beginning))
            left_.push_back(entry.path());
    std::ranges::sort(left_, {}, [](const fs::path& file) {
        std::error_code ignored;
        return fs::last_write_time(file, ignored);
    });
}

void DatabaseSession::recover() {
    if (left_.empty())
        throw irsg::LogicError("there is no recovery copy");
    const auto draft = readDraft(left_.back());
    edit(tr("Recover unsaved edits"), [&](irsg::SignatureDatabase& database) { database = draft; });
    // At no moment are these edits without a copy.
    writeRecoveryNow();
    if (recoveryProblem_.isEmpty()) {
        discardRecovery();
    } else {
        left_.pop_back();
        emit stateChanged();
    }
}

void DatabaseSession::discardRecovery() {
    if (left_.empty())
        return;
    std::error_code ignored;
    fs::remove(left_.back(), ignored);
    left_.pop_back();
    emit stateChanged();
}

void DatabaseSession::writeRecoveryNow() {
    recoveryTimer_.stop();
    if (!dirty_)
        return;
    // A copy that waits for a decision, and that of another window, stay as they are.
    if (recovery_.empty()) {
        const bool free = left_.empty() && access_ != Access::openElsewhere;
        recovery_ = placeForUnsaved(file_).string() + ".recovery" +
                    (free ? "" : "-" + std::to_string(QCoreApplication::applicationPid()));
    }
    // A crash leaves the copy before or this one.
    try {
        irsg::writeFileDurably(recovery_, irsg::draftToJson(*value_));
        setRecoveryProblem(QString());
    } catch (const irsg::InputError& error) {
        setRecoveryProblem(sentencesOf(error).join(' '));
    }
}

void DatabaseSession::setRecoveryProblem(const QString& problem) {
    if (problem == recoveryProblem_)
        return;
    recoveryProblem_ = problem;
    emit stateChanged();
}

void DatabaseSession::removeRecovery() {
    recoveryTimer_.stop();
    std::error_code ignored;
    if (!recovery_.empty())
        fs::remove(recovery_, ignored);
    recovery_.clear();
    recoveryProblem_.clear();
}

} // namespace smat::gui

#include "moc_DatabaseSession.cpp"
