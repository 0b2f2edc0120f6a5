#pragma once

#include "gui/tools/ToolPage.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/analysis/CostAccuracyStudy.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace smat::gui {

class CostAccuracyPanel;

/// Tools, Time against error: the view of the project in many configurations. Says before how many
/// there are and about how long that takes.
class CostAccuracyPage : public ToolPage {
    Q_OBJECT

  public:
    CostAccuracyPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    CostAccuracyPanel& panel() const { return *panel_; }
    CostAccuracyStudy::Options options() const;
    AnalysisData asked() const;

  private:
    QStringList problems() const override;
    QString command() const override;
    int start() override;
    QString progressText(const Progress& progress) const override;
    QString cancelText() const override;
    void showResult(const JobResult& result) override;
    const Exportable& content() const override;
    void refreshed(bool isUsable) override;
    QWidget* makeForm();
    void countConfigurations();

    QComboBox* which_ = nullptr;
    QSpinBox* repeats_ = nullptr;
    QLineEdit* target_ = nullptr;
    QLabel* count_ = nullptr;
    CostAccuracyPanel* panel_ = nullptr;
    LatestTask counting_;
};

} // namespace smat::gui
