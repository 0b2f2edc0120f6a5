#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "python/src/Bindings.h"

namespace smat::python {

/// Where the caller puts the sun, deg; what is not set comes from files.
struct SunAngles {
    std::optional<double> azimuth_deg, elevation_deg;
};

/// An environment with the words that made it, from which another process makes it again.
struct NamedEnvironment {
    std::vector<std::filesystem::path> inputs;
    std::optional<int> bins_per_cm = {};
    SunAngles sun = {};
    irsg::Environment environment = {};
};

} // namespace smat::python
