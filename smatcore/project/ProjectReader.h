#pragma once

#include <string>

#include "smatcore/project/Project.h"

namespace smat {

/// The parts of a `.smat` file (used by ProjectFile alone). Keys nobody asks for end up in the
/// `unknownKeys` of the part they stand in. Throws InputError with everything that is wrong.
/// `remarks`, where it is given, gets a sentence for each former name.
Project readProject(const std::string& text, const std::string& file,
                    std::vector<std::string>* remarks = nullptr);

} // namespace smat
