#pragma once

#include <osgSim/DOFTransform>

#include "irsg/core/Bytes.h"

namespace irsg {

/// A joint with its degrees of freedom: where it stands, and how far and in which steps it turns,
/// moves and stretches. Its children are not part of it.
void putJoint(ByteSink& sink, const osgSim::DOFTransform& joint);
/// The joint again. Throws DamagedBytes where it does not hold together.
osg::ref_ptr<osgSim::DOFTransform> getJoint(ByteSource& source);

} // namespace irsg
