#include "gui/tools/TargetPoint.h"

#include "gui/workbench/Workbench.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/tools/ViewerGeometry.h"

namespace smat::gui {

TargetPoint::TargetPoint(Workbench& workbench, QObject* parent)
    : QObject(parent), workbench_(workbench) {
    for (const auto signal : {&Workbench::projectOpened, &Workbench::projectChanged})
        connect(&workbench_, signal, this, &TargetPoint::find);
    find();
}

void TargetPoint::find() {
    if (workbench_.hasProject() && workbench_.project().models != models_) {
        const Project& project = workbench_.project();
        models_ = project.models;
        task_.run<irsg::Vec3>(
            [project, models = workbench_.models()] {
                SceneBuilder scenes(ModelStore::loader(models));
                return targetReferencePoint(project, scenes);
            },
            [this](const irsg::Vec3& point_m) {
                point_m_ = point_m;
                emit changed();
            });
    }
    emit changed();
}

void TargetPoint::take(const std::vector<ProjectModel>& models, const irsg::Vec3& point_m) {
    if (models != models_)
        return;
    point_m_ = point_m;
    emit changed();
}

} // namespace smat::gui

#include "moc_TargetPoint.cpp"
