#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "tools/atmosphere-tables/lines/CarbonDioxideBands.h"

namespace irsg::lbl {

/// A line of which only the position and the strength are known.
struct BareLine {
    double wavenumber_per_cm = 0.0, intensity = 0.0;
};

/// Two columns, wavenumber (cm-1) and intensity at 296 K, ascending afterwards. Throws InputError
/// naming the first ten lines that are no such pair.
std::vector<BareLine> readBareLines(const std::filesystem::path& file);

/// Gives bare lines E'', widths and isotopologue of the generated line that is nearest in position
/// (`near_per_cm` counts as one, at most three) and strength (a factor of 1.5 counts as one); where
/// there is none, those of `otherwise`. Both ascending.
std::vector<Line> describedLines(std::span<const BareLine> bare, std::span<const Line> generated,
                                 const Line& otherwise, double near_per_cm = 0.01);

/// The bare lines that a list lacks. A line of the list stands for one bare line, the most alike:
/// first pairs within 1e-4 cm-1 and 2 percent in strength are made, at last those within 2e-3 cm-1
/// and 30 percent or 8e-3 cm-1 and 5 percent. Both ascending.
std::vector<BareLine> missingLines(std::span<const BareLine> bare, std::span<const Line> list);

/// The lines of CO2 from 250 cm-1 on: `CO2.par.gz`, to which are added, from `extra/`, the listed
/// positions of isotopologues 1 to 3 at 2000-3333 cm-1 and, wherever a range or an isotopologue is
/// missing, generated bands. `folder` is the one of the line lists.
LineList completeCarbonDioxide(const std::filesystem::path& folder);

} // namespace irsg::lbl
