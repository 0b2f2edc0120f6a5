#pragma once

#include <memory>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "smatcore/analysis/MonteCarlo.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTreeWidget;

namespace smat::gui {

class MonteCarloPlots;
class Workbench;

/// Tools, Monte Carlo: an analysis of the project repeated over its scaling files. Runs in
/// the line of the jobs; a cancel keeps the draws there are. Shows the command that does the same.
/// The run is a result like any other, and goes on where the page is closed.
class MonteCarloPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    MonteCarloPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    /// Or waits in line.
    bool isRunning() const;
    const MonteCarloPlots& plots() const { return *plots_; }
    /// What the fields ask for; throws irsg::InputError for fields that say nothing usable.
    MonteCarloData asked() const;

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  public slots:
    void run();
    /// Answered within a moment: a drawing under way ends by itself, and what was drawn until then
    /// is shown when it has, unless the next run has begun.
    void cancel();

  signals:
    /// After every run, whatever came of it.
    void ended();

  private:
    QWidget* makeForm();
    void addWhat(QFormLayout* form);
    void addDraws(QFormLayout* form);
    void fillAnalyses();
    void fillScales();
    std::shared_ptr<const irsg::SignatureDatabase> databaseOf(const ProjectModel& model) const;
    void writeScalingFiles();
    void refresh();
    void refreshCommand();
    void connectJobs();
    void showRun(const MonteCarloData& data);
    void rest();

    Workbench& workbench_;
    Dialogs dialogs_;

    QComboBox *analysis_ = nullptr, *quantity_ = nullptr, *sequence_ = nullptr,
              *statistic_ = nullptr;
    QSpinBox *samples_ = nullptr, *seed_ = nullptr, *subpixelShifts_ = nullptr, *pairs_ = nullptr;
    QCheckBox *stops_ = nullptr, *ranks_ = nullptr;
    QDoubleSpinBox* standardError_ = nullptr;
    QLineEdit *percentiles_ = nullptr, *command_ = nullptr;
    QTreeWidget* scales_ = nullptr;
    QLabel *scalesNote_ = nullptr, *unsaved_ = nullptr, *problem_ = nullptr, *summary_ = nullptr;
    QPushButton *write_ = nullptr, *run_ = nullptr, *cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    MonteCarloPlots* plots_ = nullptr;

    bool cancelled_ = false;
    int number_ = 0; ///< of the job that is heard of
    QTimer clockTick_;
    QElapsedTimer clock_;
    QString doing_;
};

} // namespace smat::gui
