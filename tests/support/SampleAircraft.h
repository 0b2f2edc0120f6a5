#pragma once

#include <filesystem>

#include "irsg/geometry/conversion/ModelLoader.h"
#include "irsg/signature/SignatureFile.h"
#include "tests/support/SceneFixtures.h"

namespace irsg::test {

/// The sample turboprop with its database, at Mach 0.4 and 0.7 of its power: engines, exhaust pipes
/// and plumes are hot.
inline Entity sampleAircraft() {
    const std::filesystem::path folder =
        std::filesystem::path(SMAT_SOURCE_DIR) / "samples" / "turboprop4";
    Entity aircraft = entityOf(Model::load(folder / "turboprop4.flt"),
                               loadSignatureFile(folder / "turboprop4.sigdb").database);
    aircraft.state.mach = 0.4;
    aircraft.state.power = 0.7;
    return aircraft;
}

} // namespace irsg::test
