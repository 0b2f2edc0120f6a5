#pragma once

#include <string>
#include <vector>

#include "irsg/image/ImageComparison.h"

namespace irsg {

/// One number of a comparison as a table, a text or a file has it.
struct ComparisonFigure {
    std::string key;   ///< "rms_error"
    std::string label; ///< "RMS error"
    double value = 0.0;
    std::string unit;   ///< "W m-2 sr-1"; "" where it has none
    std::string detail; ///< what belongs to it: the pixel and both values, a peak, an epsilon
};

/// All the numbers of a comparison in the order in which people read them. The command line, the
/// window and the attributes of a difference image show these and no others.
std::vector<ComparisonFigure> comparisonFigures(const Comparison& comparison,
                                                const ComparisonOptions& options);

/// Six significant digits: "1.23457e-05", "nan", "inf".
std::string shortNumber(double value);

/// A difference image with what is known of it as attributes ("compare.KEY"): the plane of
/// differencePlane, then A and B. LogicError for images of different size.
RadianceImage differenceImage(const RadianceImage& a, const RadianceImage& b,
                              const Comparison& comparison, const ComparisonOptions& options,
                              DifferenceMode mode = DifferenceMode::signedDifference);

} // namespace irsg
