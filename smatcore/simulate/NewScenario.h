#pragma once

#include <functional>
#include <string>

#include "irsg/geometry/view/Vec3.h"
#include "smatcore/project/Project.h"
#include "smatcore/simulate/Scenario.h"

namespace smat {

/// A scenario to begin with: the models of a project where they stand, doing what they do, for ten
/// steps of a second, and one sensor where the camera is, to a millimetre, which looks at the
/// target. Settings are
/// those of the project that a scenario may have; paths are told from the project's file.
/// `targetReference_m` is the reference point of the target in its own axes. Throws InputError for
/// a project without models and for a model without a signature database.
Scenario scenarioOf(const Project& project, const irsg::Vec3& targetReference_m);

/// The name with what no name of a scenario may have replaced by hyphens, and with a number behind
/// it where `isTaken`: "ship-2".
std::string scenarioName(std::string wanted,
                         const std::function<bool(const std::string&)>& isTaken);

} // namespace smat
