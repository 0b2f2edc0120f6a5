#pragma once

#include "irsg/reference/RayCaster.h"
#include "tests/support/SceneFixtures.h"
