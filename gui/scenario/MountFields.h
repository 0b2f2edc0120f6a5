#pragma once

#include <functional>

#include <QWidget>

#include "gui/scenario/ScenarioDocument.h"

class QComboBox;

namespace smat::gui {

/// What a sensor is fixed to and what it looks at. Whoever changes either sees on from where the
/// sensor is at the start: its place in the axes of what carries it, and its attitude towards what
/// it looked at, follow.
class MountFields : public QWidget {
    Q_OBJECT

  public:
    explicit MountFields(QWidget* parent = nullptr);
    void show(const Scenario& scenario, std::size_t sensor);

  signals:
    /// By the user; `step` is its name.
    void edited(const QString& step, const std::function<void(smat::gui::EditedScenario&)>& edit);

  private:
    void changeMount(int chosen);
    void changeTrack(int chosen);

    QString name_; ///< of the sensor
    std::size_t sensor_ = 0;
    QComboBox *mount_ = nullptr, *track_ = nullptr;
};

} // namespace smat::gui
