#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "smatcore/data/ResultTable.h"

namespace smat::test {

/// How wide bins differ from the means of the narrow bins inside them.
struct BinComparison {
    std::size_t bins = 0;
    double rms = 0.0;
    double worst = 0.0;
    double largest = 0.0; ///< of the wide bins
};

/// Compares a column of two radiative outputs over the same band, whose bins are `narrow_per_cm`
/// and `wide_per_cm` wide. Rows at the ends of the band, which are no centres of bins, are left
/// out.
inline BinComparison compareBins(const ResultTable& narrow, double narrow_per_cm,
                                 const ResultTable& wide, double wide_per_cm,
                                 const std::string& column) {
    const auto isCentre = [narrow_per_cm](double wavenumber_per_cm) {
        const double bins = wavenumber_per_cm / narrow_per_cm;
        return std::abs(bins - std::floor(bins) - 0.5) < 1e-6;
    };
    const auto& x = narrow.find("wavenumber")->values;
    const auto& y = narrow.find(column)->values;
    const auto& wideX = wide.find("wavenumber")->values;
    const auto& wideY = wide.find(column)->values;
    BinComparison result;
    double squares = 0.0;
    for (std::size_t i = 0; i < wideX.size(); ++i) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t k = 0; k < x.size(); ++k) {
            if (std::abs(x[k] - wideX[i]) < 0.5 * wide_per_cm && isCentre(x[k])) {
                sum += y[k];
                ++count;
            }
        }
        // A bin at an end of the band is not whole.
        if (count != static_cast<int>(wide_per_cm / narrow_per_cm + 0.5)) {
            continue;
        }
        const double difference = sum / count - wideY[i];
        ++result.bins;
        squares += difference * difference;
        result.worst = std::max(result.worst, std::abs(difference));
        result.largest = std::max(result.largest, std::abs(wideY[i]));
    }
    result.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(result.bins, 1)));
    return result;
}

} // namespace smat::test
