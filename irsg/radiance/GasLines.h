#pragma once

#include <memory>
#include <vector>

#include "irsg/gas/GasColumnBasis.h"
#include "irsg/geometry/mesh/Mesh.h"

namespace irsg {

/// Lines of sight through the zones of some gases of a mesh, whose places in the list are their
/// gases: through two places each on walls that are chosen at random, some cut off before their
/// end, as by something solid, or begun within. Between nested or crossing zones the gas of the
/// smallest volume counts. The same for equal meshes; computed once a mesh.
std::shared_ptr<const std::vector<GasLine>> gasLines(const std::shared_ptr<const Mesh>& mesh,
                                                     const std::vector<IrCodes>& gases);

} // namespace irsg
