#pragma once

#include <QWidget>

#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "smatcore/tools/PathGeometry.h"

class QCheckBox;

namespace smat::gui {

class NumberField;
class TargetPoint;
class Workbench;

/// The line of sight that an air is shown for: that of the scene, from the camera to its target, as
/// long as the project has one and a person wants it, else one of the fields.
class AtmosphereSight : public QWidget {
    Q_OBJECT

  public:
    explicit AtmosphereSight(Workbench& workbench, QWidget* parent = nullptr);

    PathGeometryInput path() const;
    /// That of the project; where nothing is open the one of a new project.
    irsg::SunPosition sun() const;
    /// While the model is being read whose middle is looked at.
    bool isBusy() const;

  signals:
    void changed();

  private:
    NumberField* addField(const char* name, const QString& label, double value_m,
                          const QString& tip);
    bool isOfProject() const;
    void refresh();

    Workbench& workbench_;
    QCheckBox* ofProject_ = nullptr;
    NumberField *sensor_ = nullptr, *target_ = nullptr, *range_ = nullptr;
    TargetPoint* targetPoint_;
};

} // namespace smat::gui
