#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QWidget>

#include "gui/widgets/Dialogs.h"
#include "gui/widgets/Exportable.h"
#include "gui/widgets/LatestTask.h"
#include "irsg/sensor/SensorNumbers.h"
#include "irsg/sensor/SensorStages.h"
#include "smatcore/data/ResultTable.h"

class QComboBox;
class QLabel;
class QLineEdit;

namespace smat::gui {

class PlanePane;
class PlotPanel;
class SensorChooser;
class StageCard;
class Workbench;

/// Tools, Sensor chain: the stages of a sensor in a row, each with its transfer function, and a
/// test pattern or an image of the project before and behind the stage that is chosen.
class SensorPage : public QWidget, public Exportable {
    Q_OBJECT

  public:
    SensorPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    const PlotPanel& plot() const { return *plot_; }
    /// Transfer functions by component; empty without a sensor.
    const ResultTable& table() const { return table_; }
    /// None until they are worked out.
    const std::optional<irsg::StagePictures>& pictures() const { return pictures_; }
    bool isBusy() const { return task_.isBusy(); }

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  private:
    QWidget* makeSide();
    QWidget* makeRight();
    void fillScenes();
    void takeSensor();
    void takeScene();
    void showStage();
    void drawTransfer();
    void showPictures();
    QString numbersOf(std::size_t stage) const;

    Workbench& workbench_;
    Dialogs dialogs_;
    SensorChooser* chooser_ = nullptr;
    QComboBox *scenes_ = nullptr, *direction_ = nullptr;
    QLabel *sceneText_ = nullptr, *numbers_ = nullptr, *problem_ = nullptr;
    QLineEdit* command_ = nullptr;
    /// The stages, and the whole chain behind them.
    std::array<StageCard*, irsg::sensorStages.size() + 1> cards_{};
    std::size_t chosen_ = irsg::sensorStages.size();
    PlotPanel* plot_ = nullptr;
    PlanePane *before_ = nullptr, *behind_ = nullptr;
    ResultTable table_;
    irsg::SensorNumbers numbersOfSensor_; ///< before 300 K
    irsg::StageScene scene_;
    std::optional<irsg::StagePictures> pictures_;
    LatestTask task_;
};

} // namespace smat::gui
