#pragma once

#include <span>
#include <string>
#include <vector>

#include "irsg/atmosphere/Environment.h"

namespace smat {

/// Which of the atmospheres of an environment answers for a quantity.
struct QuantityProvider {
    std::string quantity;   ///< "path radiance", or "wideband-ck"
    std::string providedBy; ///< name of the atmosphere, "default ..."; empty where none answers
    /// Those that were asked before it, each with why it does not answer; of all where none does.
    std::vector<std::string> refusals;
};

struct BandProviders {
    irsg::SpectralRange band;
    std::vector<QuantityProvider> sources; ///< each quantity, then wideband-ck
};

/// For each band the first atmosphere that has a quantity over the whole of it, as every analysis
/// takes it. The ambient temperature has no band.
std::vector<BandProviders> providersFor(const irsg::Environment& environment,
                                        std::span<const irsg::SpectralRange> bands);

} // namespace smat
