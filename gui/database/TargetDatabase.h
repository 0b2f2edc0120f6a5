#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <vector>

#include <QStringList>

#include "gui/database/DatabaseSession.h"
#include "smatcore/project/SceneBuilder.h"

namespace smat::gui {

/// The signature database of the model of the project that is chosen: the file that the project
/// names for it is the one that is edited, and why it is not. Those of the other models keep what
/// was edited in them.
class TargetDatabase {
  public:
    /// `name` makes a file that of the chosen model, as a step that can be undone.
    TargetDatabase(QUndoStack& undoStack, std::function<void(const std::filesystem::path&)> name);

    /// Open where its file could be read.
    DatabaseSession& session() { return session_; }
    /// Why it is not open, a sentence each; empty where the model names none.
    const QStringList& problem() const { return problem_; }
    /// Whether the problem is nothing but changes of another program.
    bool canAcceptChanges() const { return changedOutside_; }
    /// Throws irsg::InputError.
    void acceptChanges();

    /// What the project names for the model that is chosen, empty for none, and for all of its
    /// models. Read again where it is the same, if `anew` says so; edits of all are left then.
    void follow(const std::filesystem::path& named, const std::vector<std::filesystem::path>& ofAll,
                bool anew);
    /// Make another file, or a new database that is to become a file, that of the model, as a step
    /// that can be undone. Throw irsg::InputError.
    void use(const std::filesystem::path& file);
    void useNew(const std::filesystem::path& file, irsg::SignatureDatabase value);
    /// Saves under another name, which becomes that of the model. Throws irsg::InputError.
    void saveAs(const std::filesystem::path& file);
    /// The databases of all models that have edits that are not saved, by the files that they
    /// stand in for: they take part in view and analyses.
    SceneBuilder::DatabaseOverrides edited() const;

  private:
    DatabaseSession session_;
    std::function<void(const std::filesystem::path&)> name_;
    std::filesystem::path named_;              ///< by the project
    std::vector<std::filesystem::path> ofAll_; ///< the same of all its models
    std::set<std::filesystem::path> kept_;     ///< whose edits stay, absolute
    QStringList problem_;
    bool changedOutside_ = false;
};

} // namespace smat::gui
