#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <QFileSystemWatcher>
#include <QLockFile>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "gui/database/DatabaseChange.h"
#include "irsg/core/FileStamp.h"
#include "irsg/signature/SignatureFile.h"

class QUndoStack;

namespace smat::gui {

/// The signature database that is being edited: its file, its value, and what its file holds.
/// Edits live in memory until they are saved; each is a named step of the window's undo stack.
/// While there are unsaved edits, a recovery copy of them lies beside the file
/// (`NAME.sigdb.recovery`), and a lock file tells other windows that this one edits. Databases of
/// other models of the project stay open as they are, with their edits and steps. Knows no widget.
class DatabaseSession : public QObject {
    Q_OBJECT

  public:
    /// What stands between the edits and their file.
    enum class Access {
        edit,          ///< nothing
        readOnly,      ///< the file is write-protected
        openElsewhere, ///< another window has unsaved edits of this file
    };
    using Edit = std::function<void(irsg::SignatureDatabase&)>;

    explicit DatabaseSession(QUndoStack& undoStack, QObject* parent = nullptr);
    ~DatabaseSession() override;

    /// Takes a file. Unsaved edits of the one before stay in their recovery copy, and its steps of
    /// the undo stack do nothing any more. Throws irsg::InputError, and then everything is as it
    /// was.
    void open(const std::filesystem::path& file,
              irsg::OutsideChanges outside = irsg::OutsideChanges::refuse);
    /// A new database that is to become this file; all of it is unsaved.
    void create(const std::filesystem::path& file, irsg::SignatureDatabase value);
    void close();
    /// The files, absolute, that stay open when another is taken; all others are left.
    void keepOpen(std::set<std::filesystem::path> files);
    /// What of them is not saved, by file.
    using Values = std::map<std::filesystem::path, std::shared_ptr<const irsg::SignatureDatabase>>;
    Values unsavedOthers() const;
    bool isOpen() const { return value_ != nullptr; }

    const std::filesystem::path& file() const { return file_; }
    /// LogicError where nothing is open, as with the two below.
    const irsg::SignatureDatabase& value() const;
    /// The value as it is now, for others to keep while editing goes on.
    std::shared_ptr<const irsg::SignatureDatabase> snapshot() const;
    const irsg::SignatureDatabase& saved() const;
    /// Whether the value is another than the file's. A database whose changes by another program
    /// were accepted is unsaved, too.
    bool isDirty() const { return dirty_; }

    Access access() const { return access_; }
    /// Why it can be saved under another name only; empty where it can be saved.
    QString accessNote() const;

    /// Changes the value as one step. Steps with an equal `mergeKey` in a row are one until
    /// endGesture(); an edit that changes nothing is no step.
    void edit(const QString& step, const Edit& change, const QString& mergeKey = {});
    /// A drag or the typing in a field is over.
    void endGesture() { ++gesture_; }

    /// Write the value in one transaction. Throw irsg::InputError, and then value and file are as
    /// they were: lint errors, a file that cannot be written, one that changed since it was read,
    /// one that another window edits. `overwrite` does not mind that the file changed.
    void save();
    void overwrite();
    /// The file that it becomes; one that exists is replaced.
    void saveAs(const std::filesystem::path& file);
    /// Whether the file holds something else than when it was read or saved last.
    bool isChangedOnDisk() const;
    /// Takes what the file holds now; edits are lost. Throws irsg::InputError.
    void reload();
    /// Forgets what is not saved.
    void discard();

    /// How many copies of their edits windows that ended without saving have left.
    std::size_t recoveries() const { return left_.size(); }
    /// Takes the newest of them as a step that can be undone; the others stay. Its copy goes once
    /// this window has one of its own. Throws irsg::InputError for a damaged copy, which stays
    /// where it is.
    void recover();
    /// Gives up the newest of them.
    void discardRecovery();
    /// Writes the recovery copy now instead of a moment after the last edit.
    void writeRecoveryNow();
    /// Why unsaved edits have no copy beside the file; empty where they have, or will in a moment.
    const QString& recoveryProblem() const { return recoveryProblem_; }
    /// Where the copy of this window lies; empty before the first.
    const std::filesystem::path& recoveryFile() const { return recovery_; }

  signals:
    /// Entries that have changed: "materials.3", "temperatures.1", "spectra.plume", "title".
    void changed(const QStringList& places);
    /// Another file was taken, or none.
    void opened();
    /// isDirty(), access(), recoveries(), recoveryProblem() or file() may have another answer.
    void stateChanged();
    /// Another program changed the file.
    void changedOnDisk();
    /// A step of another open database is done or undone: it is to be shown.
    void wanted(const std::filesystem::path& file);

  private:
    class Step;
    /// A database with all that belongs to it, as the members below.
    struct OpenDatabase {
        std::shared_ptr<const irsg::SignatureDatabase> value, saved;
        bool isNew = false, acceptedOutside = false, dirty = false;
        Access access = Access::edit;
        QString otherWindow;
        int taken = 0;
        std::optional<irsg::FileStamp> stamp;
        std::unique_ptr<QLockFile> lock;
        std::filesystem::path recovery;
        QString recoveryProblem;
        std::vector<std::filesystem::path> left;
    };
    void keepCurrentOpen();
    bool takeFromOthers(const std::filesystem::path& file);
    /// Shows the database that a step is of; false where it was left.
    bool bring(int taken);
    void leaveOrKeepOpen(const std::filesystem::path& next);

    void take(const std::filesystem::path& file, irsg::SignatureDatabase value,
              std::optional<irsg::SignatureDatabase> saved);
    void apply(const DatabaseChange& change, bool forward);
    void refresh();
    void writeTo(const std::filesystem::path& file);
    void lock();
    void findRecoveries();
    void removeRecovery();
    void setRecoveryProblem(const QString& problem);
    void leave();
    void watch();

    QUndoStack& undoStack_;
    std::filesystem::path file_;
    std::shared_ptr<const irsg::SignatureDatabase> value_, saved_;
    bool isNew_ = false, acceptedOutside_ = false, dirty_ = false;
    Access access_ = Access::edit;
    QString otherWindow_;
    int gesture_ = 0;
    int taken_ = 0; ///< which of those that were opened this is: steps of one that was left do
                    ///< nothing
    int lastTaken_ = 0;
    std::set<std::filesystem::path> keep_;
    std::map<std::filesystem::path, OpenDatabase> others_;
    std::optional<irsg::FileStamp> stamp_;
    std::unique_ptr<QLockFile> lock_;
    QFileSystemWatcher watcher_;
    std::filesystem::path recovery_;
    QString recoveryProblem_;
    std::vector<std::filesystem::path> left_; ///< by windows before, the newest last
    QTimer recoveryTimer_;
};

} // namespace smat::gui
