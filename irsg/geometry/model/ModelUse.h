#pragma once

#include "irsg/geometry/model/Model.h"
#include "irsg/signature/Lint.h"

namespace irsg {

/// What a model asks of its database: the faces of each code, and what its loader did about levels
/// of detail, whose ranges would empty a picture in programs that obey them (F25), and faces in one
/// plane.
ModelUse useOf(const Model& model);

} // namespace irsg
