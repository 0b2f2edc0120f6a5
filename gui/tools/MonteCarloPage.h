#pragma once

#include <memory>

#include "gui/tools/ToolPage.h"
#include "smatcore/analysis/MonteCarlo.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace smat::gui {

class MonteCarloPlots;

/// Tools, Monte Carlo: an analysis of the project repeated over its scaling files.
class MonteCarloPage : public ToolPage {
    Q_OBJECT

  public:
    MonteCarloPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    const MonteCarloPlots& plots() const { return *plots_; }
    /// What the fields ask for; throws irsg::InputError for fields that say nothing usable.
    MonteCarloData asked() const;

  private:
    QStringList problems() const override;
    QString command() const override;
    int start() override;
    QString progressText(const Progress& progress) const override;
    QString cancelText() const override;
    void showResult(const JobResult& result) override;
    void summarize();
    const Exportable& content() const override;
    void reload() override;
    void refreshed(bool isUsable) override;
    QWidget* makeForm();
    void addWhat(QFormLayout* form);
    void addRealisations(QFormLayout* form);
    void fillAnalyses();
    void fillScales();
    std::shared_ptr<const irsg::SignatureDatabase> databaseOf(const ProjectModel& model) const;
    void writeScalingFiles();

    QComboBox *analysis_ = nullptr, *quantity_ = nullptr, *sequence_ = nullptr,
              *statistic_ = nullptr;
    QSpinBox *samples_ = nullptr, *seed_ = nullptr, *subpixelShifts_ = nullptr, *pairs_ = nullptr;
    QCheckBox *stops_ = nullptr, *ranks_ = nullptr;
    QDoubleSpinBox* standardError_ = nullptr;
    QLineEdit* percentiles_ = nullptr;
    QTreeWidget* scales_ = nullptr;
    QWidget* notes_ = nullptr; ///< around the summary, once there is one
    QLabel *scalesNote_ = nullptr, *summary_ = nullptr;
    std::vector<SummaryItem> items_; ///< of the result that is shown
    std::vector<std::string> warnings_;
    QPushButton* write_ = nullptr;
    MonteCarloPlots* plots_ = nullptr;
};

} // namespace smat::gui
