#pragma once

#include <filesystem>

namespace smat {

/// The file that comes with the program and that a path means which leads nowhere: a project was
/// copied or moved, and "../../resources/atmospheres/subarctic-winter.xml" or
/// "../turboprop4/turboprop4.flt" lies beside the samples of this machine. What follows the last
/// "resources" or "samples" of the path counts, else what follows its leading "..", in both cases a
/// folder and a name at least: a name alone may be any file. Looked for in $SMAT_DATA, in
/// ../share/smat of the program and in the source tree that it was built from. Empty where there is
/// none.
std::filesystem::path shippedFile(const std::filesystem::path& written);

} // namespace smat
