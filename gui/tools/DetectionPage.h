#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gui/tools/ToolPage.h"
#include "smatcore/analysis/Detection.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace smat::gui {

class DetectionCasesBox;
class DetectionPlot;
class PlotPanel;
class RealBox;
class SensorChooser;
class TablePanel;

/// Tools, Detection range: how far a sensor sees the target, over the aspects of the project's
/// polar plot as a rose, over the directions of its signature table, or against wind, hour, band
/// and paint; or its probability over range. Sensors are those that come with the program, or a
/// file.
class DetectionPage : public ToolPage {
    Q_OBJECT

  public:
    DetectionPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    /// Throws irsg::InputError for fields that say nothing usable.
    DetectionRequest request() const;
    AnalysisData asked() const;
    /// The rose, or the curves against what is not an aspect.
    const PlotPanel& plot() const;
    /// Of a result over directions, else null.
    const TablePanel* table() const;

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
    QWidget* makeSensorBox(QWidget* parent);
    QWidget* makeCriterionBox(QWidget* parent);
    QWidget* makePlaceBox(QWidget* parent);
    QWidget* makeRight();
    /// Puts the temperatures and materials of the open database into the menu of what is left out.
    void fillLeftOut();

    SensorChooser* sensors_ = nullptr;
    QComboBox *thresholdBy_ = nullptr, *clutterBy_ = nullptr;
    QToolButton* leftOut_ = nullptr;
    std::vector<std::string> leftOutNames_;
    RealBox *falseAlarms_ = nullptr, *clutter_ = nullptr, *pointProbability_ = nullptr;
    QCheckBox* sensitivity_ = nullptr;
    QComboBox *criterion_ = nullptr, *task_ = nullptr, *place_ = nullptr;
    QLabel* summary_ = nullptr;
    QFormLayout *criteria_ = nullptr, *places_ = nullptr;
    DetectionCasesBox* cases_ = nullptr;
    RealBox *snr_ = nullptr, *probability_ = nullptr, *sceneContrast_ = nullptr,
            *nearest_ = nullptr, *farthest_ = nullptr, *background_ = nullptr, *step_ = nullptr;
    DetectionPlot* plot_ = nullptr;
    std::shared_ptr<const AnalysisData> result_;
};

} // namespace smat::gui
