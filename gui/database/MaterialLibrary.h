#pragma once

#include "irsg/signature/SignatureDatabase.h"

namespace smat::gui {

/// Common materials and paints with grey or coarse spectral emissivities from 0.4 to 14 um, each
/// with its origin and how sure it is in its notes: resources/materials/library.json. A damaged
/// resource is a LogicError.
const irsg::SignatureDatabase& materialLibrary();

} // namespace smat::gui
