#pragma once

#include <cmath>
#include <filesystem>
#include <sstream>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "tools/atmosphere-tables/lines/LineAbsorption.h"
#include "tools/atmosphere-tables/lines/LineListFile.h"

namespace irsg::lbl {

/// Wavenumber and transmittances, line by line, of a published run of MODTRAN with IEMSCT 0.
inline std::vector<std::vector<double>> modtranColumns(const std::filesystem::path& file) {
    std::vector<std::vector<double>> rows;
    for (const std::string& line : readTextLines(file)) {
        std::istringstream words(line);
        std::vector<double> values;
        for (std::string word; words >> word;) {
            values.push_back(parseNumber(word).value_or(-1.0));
        }
        if (values.size() > 30 && values[0] > 600.0) {
            rows.push_back(std::move(values));
        }
    }
    return rows;
}

/// Means of transmittance over boxes and over a triangle of 10 cm-1 at half maximum.
class SlitMean {
  public:
    SlitMean(const WavenumberGrid& grid, const std::vector<double>& cross_cm2,
             double column_per_cm2)
        : grid_(grid), sums_(1, 0.0) {
        for (const double value : cross_cm2) {
            sums_.push_back(sums_.back() + std::exp(-column_per_cm2 * value));
        }
    }
    /// Over 1 cm-1 from `lower_per_cm` on.
    double box(double lower_per_cm) const {
        const auto first =
            static_cast<std::size_t>((lower_per_cm - grid_.first_per_cm) / grid_.step_per_cm + 0.5);
        const auto count = static_cast<std::size_t>(1.0 / grid_.step_per_cm + 0.5);
        return (sums_[first + count] - sums_[first]) / static_cast<double>(count);
    }
    double at(double centre_per_cm) const {
        double mean = 0.0;
        for (int i = -10; i < 10; ++i) {
            mean += (1.0 - std::abs(i + 0.5) / 10.0) / 10.0 * box(centre_per_cm + i);
        }
        return mean;
    }

  private:
    WavenumberGrid grid_;
    std::vector<double> sums_;
};

} // namespace irsg::lbl
