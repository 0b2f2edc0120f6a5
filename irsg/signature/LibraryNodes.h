#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "irsg/radiometry/SpectralHead.h"
#include "irsg/signature/SpectralLibrary.h"

// What the readers of spectral libraries have in common.

namespace irsg {

/// Throws the InputError that a line of a file is; 0 for the whole file.
[[noreturn]] void refuseLibrary(const std::string& file, int line, const std::string& value,
                                const std::string& expected);

/// A row of numbers between blanks or tabs, or commas; empty where the line holds anything else.
std::vector<double> numbersOfLine(std::string_view line);

/// The first lines of a text, in small letters.
std::string beginningOf(std::string_view text, int lines);

/// Nodes as a file lists them, on their way to a column.
struct LibraryNodes {
    std::vector<double> positions, values;
    std::vector<int> lines;

    void add(double position, double value, int line) {
        positions.push_back(position);
        values.push_back(value);
        lines.push_back(line);
    }
};

/// Their column, ascending in um, each value times `factor`. InputError where there are fewer than
/// two, or their axis is not positive or turns back.
LibrarySpectrum::Column libraryColumn(LibraryNodes nodes, SpectralAxis axis,
                                      LibrarySpectrum::Quantity quantity, double factor,
                                      const std::string& file);

} // namespace irsg
