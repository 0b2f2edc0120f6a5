#pragma once

#include <memory>

#include <QWidget>

#include "gui/atmosphere/AtmosphereDocument.h"
#include "gui/widgets/Dialogs.h"
#include "gui/widgets/LatestTask.h"
#include "gui/workbench/DocumentPage.h"

class QLabel;
class QPushButton;

namespace smat::gui {

class AtmospherePlots;
class AtmosphereRecovery;
class AtmosphereSight;
class ParameterForm;
class Workbench;

/// A file of AtmosphereSmart, or one that is to be: its parameters as a form and what its air does
/// along the line of sight of the scene, drawn anew with every letter that is typed.
class AtmospherePage : public QWidget, public DocumentPage {
    Q_OBJECT

  public:
    AtmospherePage(std::unique_ptr<AtmosphereDocument> document, Workbench& workbench,
                   Dialogs dialogs, QWidget* parent = nullptr);

    AtmosphereDocument& document() { return *document_; }
    AtmosphereRecovery& recovery() { return *recovery_; }
    const AtmospherePlots& plots() const { return *plots_; }
    /// Whether what is shown is about to be another.
    bool isBusy() const;
    /// "air.xml", with a mark where it has unsaved edits.
    QString title() const;

    QString noun() const override { return tr("air"); }
    bool save() override;
    bool saveAs() override;
    bool mayClose() override;

  signals:
    void titleChanged(const QString& title);
    void said(const QString& sentence);

  private:
    struct Answer;
    QWidget* makeSide();
    QWidget* makePicture();
    /// Computes what is shown, off this thread.
    void ask();
    void showAnswer(const Answer& answer);
    void tell(const QStringList& problems);
    bool saveTo(const std::filesystem::path& file);
    /// Puts the file first among the atmospheres of the project.
    void useInProject();
    void refreshButtons();

    std::unique_ptr<AtmosphereDocument> document_;
    Workbench& workbench_;
    Dialogs dialogs_;
    AtmosphereRecovery* recovery_ = nullptr;
    ParameterForm* form_ = nullptr;
    AtmosphereSight* sight_ = nullptr;
    AtmospherePlots* plots_ = nullptr;
    QLabel *help_ = nullptr, *problems_ = nullptr, *remarks_ = nullptr;
    QPushButton *save_ = nullptr, *use_ = nullptr;
    LatestTask task_; ///< last: nothing of it is heard once the rest goes
};

} // namespace smat::gui
