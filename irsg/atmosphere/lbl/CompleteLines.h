#pragma once

#include <filesystem>
#include <vector>

#include "irsg/atmosphere/lbl/Line.h"

namespace irsg::lbl {

/// The lines of every line gas from a folder of public data (`lines/GAS.par.gz` below it).
std::vector<LineList> completeLineLists(const std::filesystem::path& dataFolder);

} // namespace irsg::lbl
