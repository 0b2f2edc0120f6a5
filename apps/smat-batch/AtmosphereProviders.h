#pragma once

#include <string>
#include <vector>

namespace smat::batch {

struct Context;

/// `smat-batch atmosphere answers`: which of several atmospheres answers for what, for each band
/// ("3-5"). Throws InputError as addAtmosphere does, and for a band that is none.
int printAtmosphereProviders(const std::vector<std::string>& atmospheres,
                             const std::vector<std::string>& bands, const Context& context);

} // namespace smat::batch
