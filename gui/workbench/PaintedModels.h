#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QLockFile>
#include <QObject>
#include <QTimer>

#include "gui/workbench/ModelStore.h"

class QUndoStack;

namespace smat::gui {

/// What is painted on the models of a project and not saved yet: surfaces that stand in for those
/// of the file with the codes beside each model, everywhere in the window, until they are saved
/// there. Each edit is a named step of the window's undo stack. While there are unsaved ones a
/// recovery copy lies beside that file (`NAME.codes.json.recovery`). Knows no widget.
class PaintedModels : public QObject {
    Q_OBJECT

  public:
    using Surfaces = std::vector<irsg::PaintedSurface>;

    PaintedModels(QUndoStack& undoStack, std::shared_ptr<ModelStore> models,
                  QObject* parent = nullptr);
    /// What is unsaved stays in its recovery copy.
    ~PaintedModels() override;

    /// What is painted on a model now. Throws irsg::InputError for a damaged file.
    std::shared_ptr<const Surfaces> of(const std::filesystem::path& model);
    /// Another painting as one step; none where nothing changes. Throws as of() does.
    void edit(const std::filesystem::path& model, Surfaces after, const QString& step);

    bool isDirty() const;
    /// Names of the models with unsaved paint.
    QStringList unsaved() const;
    /// Those of them whose painted surfaces another program changed since they were read.
    std::vector<std::filesystem::path> changedOutside() const;
    /// Writes what is unsaved, beside the rules that the files have now. Throws irsg::InputError,
    /// and what could not be written stays unsaved.
    void save();
    /// Gives up what is unsaved.
    void discard();
    /// Forgets all, as another project is opened.
    void clear();

    /// The copy of unsaved paint that a window which ended without saving left, and no other
    /// window is at work on.
    static std::optional<std::filesystem::path> leftBehind(const std::filesystem::path& model);
    /// Takes it as a step that can be undone; it goes once this window has one of its own. Throws
    /// irsg::InputError for a damaged copy, which stays where it is.
    void recover(const std::filesystem::path& model, const std::filesystem::path& copy);
    /// Writes the recovery copies now instead of a moment after the last edit.
    void writeRecoveryNow();

  signals:
    /// A model is painted otherwise.
    void changed(const std::filesystem::path& model);
    /// isDirty() may have another answer.
    void stateChanged();

  private:
    class Step;
    struct Painting {
        std::shared_ptr<const Surfaces> now, saved;
        std::optional<irsg::FileStamp> stamp; ///< of the file, as we know it
        std::unique_ptr<QLockFile> lock;
        std::filesystem::path recovery; ///< written for it; empty for none
        bool isDirty() const { return *now != *saved; }
    };
    Painting& painting(const std::filesystem::path& model);
    void apply(const std::filesystem::path& model, std::shared_ptr<const Surfaces> surfaces);
    void follow(const std::filesystem::path& model, Painting& painting);
    static void removeRecovery(Painting& painting);

    QUndoStack& undoStack_;
    std::shared_ptr<ModelStore> models_;
    std::map<std::filesystem::path, Painting> paintings_;
    QTimer recoveryTimer_;
};

} // namespace smat::gui
