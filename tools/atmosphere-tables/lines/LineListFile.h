#pragma once

#include <filesystem>
#include <string>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// Reads a line list in HITRAN's form of 160 columns (Rothman et al. 2005, J. Quant. Spectrosc.
/// Radiat. Transfer 96, 139), plain or compressed with gzip. Lines are put in order of wavenumber.
/// Throws InputError naming the first ten lines that are not records of the gas.
LineList readLineList(Gas gas, const std::filesystem::path& file);

/// A text file, plain or compressed with gzip, line by line. Throws InputError where it cannot be
/// read.
std::vector<std::string> readTextLines(const std::filesystem::path& file);

} // namespace irsg::lbl
