#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QStringList>

#include "gui/scenario/ScenarioDocument.h"
#include "gui/widgets/LatestTask.h"
#include "smatcore/simulate/SceneGenerator3D.h"

namespace smat::gui {

class ModelStore;

/// What is asked for: a sensor at a step, in one of its bands.
struct ScenarioMoment {
    std::size_t sensor = 0, band = 0;
    std::size_t step = 0;
    double time_s = 0.0;
    bool operator==(const ScenarioMoment&) const = default;
};

/// What a sensor sees at a moment.
struct ScenarioPicture {
    ScenarioMoment moment;
    std::size_t bandCount = 1;
    /// As smat-batch writes it; null where the sensor, its carrier or its target is not there.
    std::shared_ptr<const irsg::RadianceImage> image;
    /// The same with apparent temperatures behind its planes.
    std::shared_ptr<const irsg::RadianceImage> shown;
    Settings settings; ///< in effect for the sensor
    QString title, conditions;
    /// By entity; no value where it is not there.
    std::vector<std::optional<TrajectoryPoint>> entities;
    /// The same; empty where there is no image.
    std::vector<std::optional<irsg::ObjectRadiometry>> objects;
    QStringList notes; ///< tables that hold an end value
};

/// Draws what the sensors of a scenario see, by the code of smat-batch simulate, off the thread of
/// the window: one picture at a time, and the latest question next. Destroying it waits for
/// nothing.
class ScenarioPictures : public QObject {
    Q_OBJECT

  public:
    explicit ScenarioPictures(std::shared_ptr<ModelStore> models, QObject* parent = nullptr);
    ~ScenarioPictures() override;

    /// From now on pictures are of this state.
    void setScenario(std::shared_ptr<const EditedScenario> state);
    /// Returns at once; questions that were not begun yet are dropped.
    void ask(const ScenarioMoment& moment);
    bool isBusy() const { return isDrawing_ || next_.has_value(); }

  signals:
    void drawn(const smat::gui::ScenarioPicture& picture);
    void failed(const QStringList& sentences);
    void busyChanged();

  private:
    struct Engine;
    void begin();

    std::shared_ptr<Engine> engine_;
    std::shared_ptr<const EditedScenario> state_;
    std::optional<ScenarioMoment> next_;
    bool isDrawing_ = false;
    LatestTask task_;
};

} // namespace smat::gui
