#pragma once

#include <filesystem>
#include <string>

namespace irsg {

/// A file of the atmosphere's tables by name ("gases.gastable"). Looked for in
/// $SMAT_RESOURCES/atmosphere, beside the running program in ../share/smat/atmosphere, beside this
/// library in the same folder or in ../../share/smat/atmosphere, and where the project was built
/// from. Throws InputError naming the places.
std::filesystem::path atmosphereResource(const std::string& name);

} // namespace irsg
