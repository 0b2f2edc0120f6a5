#pragma once

#include <filesystem>
#include <vector>

#include "tools/atmosphere-tables/lines/Line.h"

namespace irsg::lbl {

/// The lines of one gas from 250 to 18000 cm-1, as far as it absorbs, ascending, nothing missing:
/// HITRAN where `dataFolder`/lines has it, bands generated for CO2, isotopologues
/// for N2O and CH4, pseudo-lines after LOWTRAN 7
/// (`dataFolder`/lowtran) for the gaps of H2O, O3 and CH4. `origins` says which is which. Throws
/// InputError for files that are missing or damaged, LogicError for a gas without lines.
LineList completeLineList(Gas gas, const std::filesystem::path& dataFolder);

/// The lines of 13CH4 in the nu3 region as those of 12CH4 moved by the distance of the band
/// origins, with HITRAN's abundances: positions to 0.2 cm-1.
std::vector<Line> heavyMethane(const std::vector<Line>& listed);

/// Those of all line gases, in their order.
std::vector<LineList> completeLineLists(const std::filesystem::path& dataFolder);

} // namespace irsg::lbl
