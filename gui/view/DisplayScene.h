#pragma once

#include <vector>

#include <QString>
#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/ref_ptr>

#include "irsg/scene/Pose.h"
#include "smatcore/project/Project.h"

namespace smat::gui {

/// What the 3-D view shows of a project: copies of its models of their own, with their visible
/// colours, standing where the project puts them. Nothing of it is shared with the infrared
/// renderer.
struct DisplayScene {
    osg::ref_ptr<osg::Group> root;
    osg::ref_ptr<osg::MatrixTransform> target;
    irsg::Vec3 referenceInModel_m; ///< of the target, the one analyses turn about
    irsg::Vec3 referencePoint_m;   ///< the same in the world
    double radius_m = 1.0;         ///< of the target about its reference point
    std::vector<QString> remarks;

    void placeTarget(const irsg::Pose& pose);
};

/// Loads the models of a project and puts them at the poses that `settings` give. Throws
/// irsg::InputError with the offences of all models.
DisplayScene loadDisplayScene(const Project& project, const Settings& settings);

} // namespace smat::gui
