#pragma once

#include "irsg/reference/Scenes.h"

namespace irsg::test {

using namespace irsg::reference; // shapes and scenes of closed form, which smat-batch selftest has
                                 // too

} // namespace irsg::test
