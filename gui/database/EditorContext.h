#pragma once

#include <functional>
#include <map>
#include <set>

#include <QObject>

#include "gui/database/DatabaseEdits.h"
#include "gui/database/DatabaseSession.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "gui/workbench/Workbench.h"
#include "irsg/signature/EntityState.h"
#include "irsg/signature/Lint.h"

namespace smat::gui {

/// What the parts of the database editor share: the session, and what the project says about the
/// surroundings of its signature: the faces of the model, the band, the state of the entity.
class EditorContext : public QObject {
    Q_OBJECT

  public:
    EditorContext(Workbench& workbench, DatabaseSession& session, Dialogs dialogs,
                  QObject* parent = nullptr);

    Workbench& workbench() const { return workbench_; }
    DatabaseSession& session() const { return session_; }
    const Dialogs& dialogs() const { return dialogs_; }
    QWidget* window = nullptr; ///< parent of dialogs
    /// Says under this title what a file was refused for.
    void attempt(const QString& title, const std::function<void()>& act) const;

    /// Faces of the chosen model that carry an index; 0 for spectra.
    int facesOf(const EntryKey& key) const;
    /// What the chosen model asks of the database, for the physics to validate.
    const irsg::ModelUse& modelUse() const { return use_; }
    /// Indices of the chosen model's faces that the database has no entry for.
    std::vector<EntryKey> missing() const;
    /// False where the model could not be read, or is not read yet.
    bool knowsModel() const { return knowsModel_; }
    bool isReadingModel() const { return reading_.isBusy(); }
    const irsg::SpectralRange& band() const { return band_; }
    /// Of the chosen model as the project has it, in the air of its atmosphere.
    const irsg::EntityState& state() const { return state_; }

    /// "Material 3", with its name where it has one.
    QString title(const EntryKey& key) const;
    /// Mean over the band of the project.
    double bandMean(const irsg::Spectrum& spectrum) const;

  signals:
    /// Faces, band or state are others.
    void surroundingsChanged();

  private:
    void readModel();
    void read(const ModelKey& key);
    void readSettings();

    Workbench& workbench_;
    DatabaseSession& session_;
    Dialogs dialogs_;
    bool knowsModel_ = false;
    irsg::ModelUse use_;
    std::optional<ModelKey> target_; ///< that use_ is of
    std::string atmosphereKey_, settingsKey_;
    irsg::SpectralRange band_;
    irsg::EntityState state_;
    LatestTask reading_;
};

/// "1 face", "12 faces".
QString counted(long number, const QString& one, const QString& many);

} // namespace smat::gui
