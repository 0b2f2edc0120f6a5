#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>
#include <QStringList>

#include "gui/workbench/DocumentStep.h"
#include "irsg/atmosphere/AtmosphereSmartParameters.h"
#include "irsg/core/FileStamp.h"

namespace smat::gui {

/// What is edited of a file of AtmosphereSmart.
struct EditedAtmosphere {
    irsg::AtmosphereSmartParameters parameters;
    /// Relative to which the ascent of the parameters is told; empty where there is no file yet.
    std::filesystem::path folder;
    bool operator==(const EditedAtmosphere&) const = default;
};

/// Air that is open, as it is edited: the parameters of a file of AtmosphereSmart, or of one that
/// is to be, each edit a step on the undo stack of the window. What else stands in the file is
/// kept. Knows no widget.
class AtmosphereDocument : public QObject {
    Q_OBJECT

  public:
    /// The report's defaults, without a file.
    explicit AtmosphereDocument(QUndoStack& undoStack, QObject* parent = nullptr);
    /// Throws irsg::InputError with all that is wrong with a file.
    AtmosphereDocument(const std::filesystem::path& file, QUndoStack& undoStack,
                       QObject* parent = nullptr);
    ~AtmosphereDocument() override;

    const irsg::AtmosphereSmartParameters& parameters() const { return now_->parameters; }
    /// Empty before the first save.
    const std::filesystem::path& file() const { return file_; }
    QString displayName() const;
    bool isModified() const { return *now_ != saved_; }

    /// A step of this name; nothing where nothing differs.
    void set(const irsg::AtmosphereSmartParameters& after, const QString& step,
             int gesture = noGesture);
    static constexpr int noGesture = -1;

    /// Why these parameters are no air: combinations that cannot be, see irsg::diagnosticsOf.
    std::vector<irsg::Diagnostic> diagnostics() const;
    /// Settings without effect, and what of the file nobody knows.
    QStringList remarks() const;

    /// Whether another program has written the file since it was read or saved.
    bool isChangedOnDisk() const;
    /// Writes the parameters to a file, whose air this becomes: what `smat-batch atmosphere new`
    /// or, with a file that was opened, `set` writes. Throws irsg::InputError, for diagnostics()
    /// too.
    void saveAs(const std::filesystem::path& file);

    /// What saveAs would write into a folder.
    std::string textIn(const std::filesystem::path& folder) const;
    /// Takes the parameters of a copy that was left behind, as a step. Throws irsg::InputError.
    void recover(const std::filesystem::path& copy);

    /// Whether a file is meant to be an AtmosphereSmart; not whether it is a sound one.
    static bool isAtmosphere(const std::filesystem::path& file);

  signals:
    void changed();
    /// isModified() or the file may be another.
    void stateChanged();

  private:
    void take(EditedAtmosphere state);
    irsg::KarmaXml xmlOf(const EditedAtmosphere& state) const;

    QUndoStack& undoStack_;
    std::filesystem::path file_;
    std::optional<irsg::KarmaXml> document_; ///< of the file
    std::vector<std::string> unknown_;       ///< of it, in words
    std::shared_ptr<const EditedAtmosphere> now_;
    EditedAtmosphere saved_;
    std::optional<irsg::FileStamp> stamp_;
    std::shared_ptr<DocumentStep<EditedAtmosphere>::Apply> apply_; ///< of its steps
};

} // namespace smat::gui
