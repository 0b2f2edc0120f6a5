#pragma once

#include "irsg/signature/SignatureDatabase.h"

namespace irsg {

/// Common materials and paints with grey or coarse spectral emissivities from 0.4 to 14 um, each
/// with its origin and how sure it is in its notes: resources/materials/library.json, which is part
/// of the library. A damaged one is a LogicError.
const SignatureDatabase& materialLibrary();

} // namespace irsg
