#pragma once

#include "gui/tools/ToolPage.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/analysis/Frontier.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace smat::gui {

class FrontierPanel;

/// Tools, Time against error: the view of the project in many configurations. Says before how many
/// there are and about how long that takes.
class FrontierPage : public ToolPage {
    Q_OBJECT

  public:
    FrontierPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    FrontierPanel& panel() const { return *panel_; }
    Frontier::Options options() const;
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
    void countWays();

    QComboBox* which_ = nullptr;
    QSpinBox* repeats_ = nullptr;
    QLineEdit* target_ = nullptr;
    QLabel* count_ = nullptr;
    FrontierPanel* panel_ = nullptr;
    LatestTask counting_;
};

} // namespace smat::gui
