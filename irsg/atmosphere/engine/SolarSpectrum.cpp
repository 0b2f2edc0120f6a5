#include "irsg/atmosphere/engine/SolarSpectrum.h"

#include <algorithm>
#include <vector>

#include "irsg/atmosphere/engine/ResourceFile.h"
#include "irsg/radiometry/CsvTable.h"
#include "irsg/radiometry/Errors.h"

namespace irsg {

namespace {

/// Steps of irradiance between edges, as a running sum: an integral is a difference.
class RunningSum {
  public:
    explicit RunningSum(const std::filesystem::path& file) {
        const CsvTable csv = CsvTable::read(file);
        std::vector<Offence> offences;
        for (std::size_t r = 1; r < csv.rows().size(); ++r) {
            const CsvRow& row = csv.rows()[r];
            if (row.cells.size() != 3) {
                offences.push_back(csv.offence(row.line,
                                               std::to_string(row.cells.size()) + " cells",
                                               "lower and upper wavenumber and irradiance"));
                continue;
            }
            const double lower = csv.number(row.cells[0], offences).value_or(0.0);
            const double upper = csv.number(row.cells[1], offences).value_or(0.0);
            const double value = csv.number(row.cells[2], offences).value_or(0.0);
            if (edges_.empty()) {
                edges_.push_back(lower);
                sums_.push_back(0.0);
            }
            if (lower != edges_.back() || !(upper > lower))
                offences.push_back(csv.offence(
                    row.cells[0], "the upper end of the row before, and less than its own"));
            if (value < 0.0)
                offences.push_back(csv.offence(row.cells[2], "an irradiance >= 0"));
            edges_.push_back(upper);
            sums_.push_back(sums_.back() + value * (upper - lower));
        }
        if (edges_.size() < 2 && offences.empty())
            offences.push_back(csv.offence("no rows", "the sun's spectrum"));
        if (!offences.empty())
            throw InputError(std::move(offences));
    }
    double below(double wavenumber_cm) const {
        const double x = std::clamp(wavenumber_cm, edges_.front(), edges_.back());
        const auto upper =
            std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(edges_, x) - edges_.begin(), 1,
                                       static_cast<std::ptrdiff_t>(edges_.size()) - 1);
        const auto i = static_cast<std::size_t>(upper);
        const double part = (x - edges_[i - 1]) / (edges_[i] - edges_[i - 1]);
        return sums_[i - 1] + part * (sums_[i] - sums_[i - 1]);
    }

  private:
    std::vector<double> edges_, sums_;
};

} // namespace

double solarIrradiance_W_m2_per_cm(double lower_cm, double upper_cm) {
    if (!(lower_cm < upper_cm))
        throw LogicError("the sun was asked for over an interval of no width");
    static const RunningSum sun(atmosphereResource("solar.csv"));
    return (sun.below(upper_cm) - sun.below(lower_cm)) / (upper_cm - lower_cm);
}

} // namespace irsg
