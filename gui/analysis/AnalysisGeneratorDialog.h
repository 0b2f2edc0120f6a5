#pragma once

#include <vector>

#include <QDialog>

#include "gui/settings/SettingForm.h"
#include "smatcore/analysis/AnalysisData.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QTabWidget;

namespace smat::gui {

/// Gathers what an analysis is asked into an AnalysisData, and nothing else: it does not run. Every
/// setting that takes part has its field; what is wrong, with one of them or between them, is said
/// as one types, else how many cases there will be. Shows the command that does the same from a
/// terminal.
class AnalysisGeneratorDialog : public QDialog {
    Q_OBJECT

  public:
    /// Begins with `settings`; what they change of the project's own is in the command.
    AnalysisGeneratorDialog(const Project& project, const Settings& settings, AnalysisKind kind,
                            FileChooser chooseFile, QWidget* parent = nullptr);

    void setName(const QString& name);
    /// A sentence under the command; none where it is empty.
    void setUnsavedNote(const QString& note);

    /// What the forms say now; only while acceptable.
    AnalysisData data() const;
    bool isAcceptable() const;

  private:
    QStringList problems() const;
    void addPage(const QString& title, const std::vector<std::string>& sections, QTabWidget* tabs);
    void refresh();
    void showIgnored();

    Project project_;
    Settings settings_;
    AnalysisKind kind_;
    FileChooser chooseFile_;
    std::vector<SettingForm*> forms_;
    QLineEdit* name_ = nullptr;
    QLineEdit* command_ = nullptr;
    QLabel* problems_ = nullptr;
    QLabel* plan_ = nullptr;
    QLabel* ignored_ = nullptr; ///< what the analysis does not take from the view
    QLabel* unsaved_ = nullptr;
    QDialogButtonBox* buttons_ = nullptr;
};

} // namespace smat::gui
