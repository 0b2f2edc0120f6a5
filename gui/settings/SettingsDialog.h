#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "gui/settings/SettingForm.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QListWidget;

namespace smat::gui {

class Workbench;

/// One page of a dialog of settings. Settings for experts are hidden until asked for, unless they
/// are among `always` or were changed.
struct SettingsPage {
    QString title;
    QString icon;
    std::vector<std::string> keys;
    std::vector<std::string> always = {};
};

/// Settings of the project by pages, each field with unit, range and help from its description.
/// Apply and OK are one step to undo each; Cancel changes nothing.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    SettingsDialog(Workbench& workbench, const QString& title, const QString& step,
                   const std::vector<SettingsPage>& pages, FileChooser chooseFile,
                   QWidget* parent = nullptr);
    /// Antialiasing, background, skybox, terrain, atmosphere, scattering, scalings.
    static std::vector<SettingsPage> optionPages();
    /// Sun and fluxes, background source, calculation mode, band and response.
    static std::vector<SettingsPage> analysisPages();

    void showPage(int page);
    bool isAcceptable() const;
    bool apply();
    void accept() override;

  private:
    void refresh();
    /// Adds what is to be told below a form: the header of its MTF database.
    void addNotes(SettingForm* form);
    void showExperts(bool visible);
    Settings edited() const;

    Workbench& workbench_;
    QString step_;
    std::vector<SettingsPage> pages_;
    std::vector<SettingForm*> forms_;
    QListWidget* list_ = nullptr;
    QLabel* problems_ = nullptr;
    QCheckBox* experts_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
