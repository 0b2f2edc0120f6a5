#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "gui/tools/ToolPage.h"
#include "smatcore/analysis/Detection.h"

class QComboBox;
class QFormLayout;
class QLabel;

namespace smat::gui {

class PlotPanel;
class RealBox;

/// Tools, Detection range: how far a sensor sees the target over the aspects of the project's polar
/// plot, as a rose. Sensors are those that come with the program, or a file.
class DetectionPage : public ToolPage {
    Q_OBJECT

  public:
    DetectionPage(Workbench& workbench, Dialogs dialogs, QWidget* parent = nullptr);

    /// Throws irsg::InputError for fields that say nothing usable.
    DetectionRequest request() const;
    AnalysisData asked() const;
    const PlotPanel& plot() const { return *plot_; }
    /// Takes the sensor of a file into the list and chooses it; tells what is wrong with it.
    void openSensor(const std::filesystem::path& file);

    QStringList exportFilters() const override;
    void exportTo(const std::filesystem::path& file) const override;

  private:
    QStringList problems() const override;
    QString command() const override;
    int start() override;
    QString progressText(const Progress& progress) const override;
    QString cancelText() const override;
    void showResult(const JobResult& result) override;
    const Exportable& content() const override { return *this; }
    void refreshed(bool isUsable) override;
    QWidget* makeForm();
    QWidget* makeSensorBox(QWidget* parent);
    QWidget* makeCriterionBox(QWidget* parent);
    QWidget* makePlaceBox(QWidget* parent);
    QWidget* makeRight();
    void chooseSensor(int index);
    void describeSensor();
    void drawResult();

    QComboBox *sensors_ = nullptr, *criterion_ = nullptr, *task_ = nullptr, *place_ = nullptr,
              *quantity_ = nullptr;
    QLabel *sensorText_ = nullptr, *summary_ = nullptr;
    QFormLayout* criteria_ = nullptr;
    RealBox *snr_ = nullptr, *probability_ = nullptr, *sceneContrast_ = nullptr,
            *nearest_ = nullptr, *farthest_ = nullptr, *background_ = nullptr, *step_ = nullptr;
    PlotPanel* plot_ = nullptr;
    int chosen_ = 0; ///< in the list of sensors
    std::optional<irsg::SensorDescription> sensor_;
    QString sensorProblem_;
    std::shared_ptr<const AnalysisData> result_;
};

} // namespace smat::gui
