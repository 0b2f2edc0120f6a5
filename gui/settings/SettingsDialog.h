#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QDialog>

#include "gui/settings/SettingForm.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
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

/// Whose settings a dialog is about.
struct SettingsSubject {
    QString title;
    std::function<Settings()> settings; ///< all in effect
    /// One step to undo. Says why it cannot be; empty where it was done.
    std::function<QString(const Settings& edited)> set;
    std::function<std::filesystem::path(const std::filesystem::path&)> resolve;
};

/// All settings of the project but those of one kind of analysis, by pages, each field with unit,
/// range and help from its description, to be found by any of its words. Apply and OK are one step
/// to undo each; Cancel changes nothing.
class SettingsDialog : public QDialog {
    Q_OBJECT

  public:
    SettingsDialog(Workbench& workbench, FileChooser chooseFile, QWidget* parent = nullptr);
    /// Those of something else, on pages of its own.
    SettingsDialog(SettingsSubject subject, std::vector<SettingsPage> pages, FileChooser chooseFile,
                   QWidget* parent = nullptr);
    /// Every setting of the table stands on the one that its row names. The first ones are those of
    /// every analysis: band and mode, sensor, sun, background.
    static std::vector<SettingsPage> pages();

    /// By its title; another one than there is changes nothing.
    void showPage(const QString& title);
    void showPage(int page);
    /// Pages and fields with these words alone; all of them for none.
    void search(const QString& words);
    bool isAcceptable() const;
    bool apply();
    void accept() override;

  private:
    void refresh();
    /// Adds what is to be told below a form: the header of its MTF database.
    void addNotes(SettingForm* form);
    void showExperts(bool visible);
    Settings edited() const;

    SettingsSubject subject_;
    std::vector<SettingsPage> pages_;
    std::vector<SettingForm*> forms_;
    QListWidget* list_ = nullptr;
    QLineEdit* search_ = nullptr;
    QLabel* problems_ = nullptr;
    QCheckBox* experts_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
