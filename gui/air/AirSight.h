#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "gui/widgets/LatestTask.h"
#include "irsg/atmosphere/AtmosphericQuery.h"
#include "irsg/scene/view/Vec3.h"
#include "smatcore/project/Project.h"
#include "smatcore/tools/PathGeometry.h"

class QCheckBox;

namespace smat::gui {

class NumberField;
class Workbench;

/// The line of sight that an air is shown for: that of the scene, from the camera to its target, as
/// long as the project has one and a person wants it, else one of the fields.
class AirSight : public QWidget {
    Q_OBJECT

  public:
    explicit AirSight(Workbench& workbench, QWidget* parent = nullptr);

    PathGeometryInput path() const;
    /// That of the project; where nothing is open the one of a new project.
    irsg::SunPosition sun() const;
    /// While the model is being read whose middle is looked at.
    bool isBusy() const { return locating_.isBusy(); }

  signals:
    void changed();

  private:
    NumberField* addField(const char* name, const QString& label, double value_m,
                          const QString& tip);
    bool isOfProject() const;
    /// Finds where the camera looks, off this thread.
    void locate();
    void refresh();

    Workbench& workbench_;
    QCheckBox* ofProject_ = nullptr;
    NumberField *sensor_ = nullptr, *target_ = nullptr, *range_ = nullptr;
    irsg::Vec3 referencePoint_m_;
    std::vector<ProjectModel> located_; ///< whose reference point it is
    LatestTask locating_;
};

} // namespace smat::gui
