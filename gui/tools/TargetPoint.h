#pragma once

#include <optional>
#include <vector>

#include <QObject>

#include "gui/widgets/LatestTask.h"
#include "irsg/geometry/view/Vec3.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

class Workbench;

/// Where the camera of the open project looks: the reference point of its target, which needs the
/// model; found off this thread and anew when the models of the project change.
class TargetPoint : public QObject {
    Q_OBJECT

  public:
    explicit TargetPoint(Workbench& workbench, QObject* parent = nullptr);

    /// In world axes, m; none until the first one is found, that of before while isBusy().
    const std::optional<irsg::Vec3>& point_m() const { return point_m_; }
    bool isBusy() const { return task_.isBusy(); }
    /// Takes a point that was found elsewhere, if it is of the models that are open.
    void take(const std::vector<ProjectModel>& models, const irsg::Vec3& point_m);

  signals:
    /// Of the project, or the point: what was shown of them is of before.
    void changed();

  private:
    void find();

    Workbench& workbench_;
    std::optional<irsg::Vec3> point_m_;
    std::vector<ProjectModel> models_; ///< whose point it is
    LatestTask task_;
};

} // namespace smat::gui
