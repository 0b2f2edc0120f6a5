#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include <QObject>

#include "gui/project/ModelOpening.h"
#include "gui/project/RecoveryCopy.h"
#include "gui/widgets/Dialogs.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileStamp.h"

namespace smat::gui {

class Workbench;
struct Preferences;

/// The part of the window that opens and saves: asks for names and about unsaved changes, offers
/// what a crash left behind, and tells what went wrong. Nothing that is open is lost by an answer
/// of "cancel" or by a file that cannot be read or written.
class ProjectFiles : public QObject {
    Q_OBJECT

  public:
    ProjectFiles(Workbench& workbench, Dialogs& dialogs, const Preferences& preferences,
                 QWidget* window);

    RecoveryCopy& recovery() { return recovery_; }
    /// Saves unsaved changes or gives them up, as the person wants it; false where it is better to
    /// stay.
    bool settle();
    /// Asked by settle() before the project itself: editors of other files.
    void addSettler(std::function<bool()> settle);

    /// Each true where it was done.
    bool newProject();
    bool chooseModel();
    /// True for a large model also while it is being read, beside what is open: it comes, or what
    /// is wrong with it is told, when it was read. Only then unsaved changes are asked about.
    bool open(const std::filesystem::path& file);
    ModelOpening& opening() { return opening_; }
    bool save();
    /// Asks whether files that lie elsewhere are to be copied beside it.
    bool saveAs();
    /// Writes a copy of the project with all files that it needs; what is open stays.
    bool collect();
    /// What a start of the program does, with a file or without one: offers the new projects that
    /// were never saved and that a crash left behind, opens the file, and without one offers the
    /// newest unsaved changes that a crash left behind of a recent project.
    bool begin(const std::filesystem::path& file);
    /// Another file for a model of the project: a step to undo.
    bool chooseModelFile(std::size_t model);

    /// "*.flt *.osgt …".
    static QString modelPatterns();
    static QString modelFilter();

  signals:
    /// Something to say in passing.
    void said(const QString& sentence);
    /// What was taken for granted in a project, to be kept.
    void remarked(const QString& sentence);

  private:
    /// Of a project that is begun with a model, whose extent may not be known yet.
    Settings firstSettings(Settings usual, const std::optional<irsg::BoundingBox>& bounds) const;
    bool load(const std::filesystem::path& file);
    /// Throws irsg::InputError for a damaged model, so that what is open stays; those that take
    /// their time were read beside the window. What was read serves the view.
    void requireReadable(const std::filesystem::path& file) const;
    /// A large model that was read takes the place of what is open.
    void openRead(const std::filesystem::path& file);
    bool saveTo(const std::filesystem::path& file, bool withFiles = false);
    /// Whether copies of the files would have all that is seen; else says what to save first.
    bool mayCopyFiles();
    /// What is painted on the models, beside them; false where it was not.
    bool savePaint();
    /// Offers what a crash left behind of that.
    void recoverPaint();
    /// What became of the copies of a project that a crash left behind.
    enum class Recovery { none, taken, left };
    Recovery recover(const std::filesystem::path& file);
    bool offerRecentProject();
    void adopt(const Project& recovered, const std::filesystem::path& copy);
    void remember();
    QString displayName() const;
    /// What would be lost, a sentence each.
    QStringList unsavedWords() const;

    Workbench& workbench_;
    Dialogs& dialogs_;
    const Preferences& preferences_;
    QWidget* window_;
    RecoveryCopy recovery_;
    ModelOpening opening_;
    std::filesystem::path read_; ///< the large model that may be opened now
    std::vector<std::function<bool()>> settlers_;
    std::optional<irsg::FileStamp> written_; ///< of the project's file, as we know it
};

} // namespace smat::gui
