#pragma once

#include <filesystem>
#include <functional>

#include <QStringList>

#include "gui/database/DatabaseSession.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

/// The signature database of the target of the project that is open: the file that the project
/// names is the one that is edited, and why it is not.
class TargetDatabase {
  public:
    /// `name` makes a file that of the target, as a step that can be undone.
    TargetDatabase(QUndoStack& undoStack, std::function<void(const std::filesystem::path&)> name);

    /// Open where its file could be read.
    DatabaseSession& session() { return session_; }
    /// Why it is not open, a sentence each; empty where the model names none.
    const QStringList& problem() const { return problem_; }
    /// Whether the problem is nothing but changes of another program.
    bool canAcceptChanges() const { return changedOutside_; }
    /// Throws irsg::InputError.
    void acceptChanges();

    /// What the project names for its target; empty for none. Read again where it is the same, if
    /// `anew` says so.
    void follow(const std::filesystem::path& named, bool anew);
    /// Make another file, or a new database that is to become a file, that of the target, as a step
    /// that can be undone. Throw irsg::InputError.
    void use(const std::filesystem::path& file);
    void useNew(const std::filesystem::path& file, irsg::SignatureDatabase value);
    /// Saves under another name, which becomes that of the target. Throws irsg::InputError.
    void saveAs(const std::filesystem::path& file);
    /// It, where it has edits that are not saved, by the file that it stands in for: they take part
    /// in view and analyses.
    SceneBuilder::DatabaseOverrides edited() const;

  private:
    DatabaseSession session_;
    std::function<void(const std::filesystem::path&)> name_;
    std::filesystem::path named_; ///< by the project
    QStringList problem_;
    bool changedOutside_ = false;
};

} // namespace smat::gui
