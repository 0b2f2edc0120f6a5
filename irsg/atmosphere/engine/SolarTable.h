#pragma once

#include <filesystem>
#include <vector>

namespace irsg {

/// Irradiance in steps between edges, as a running sum: any integral is a difference of two.
class SolarTable {
  public:
    /// Rows of lower and upper wavenumber (cm-1) and mean irradiance (W m-2 per cm-1), each from
    /// where the one before ends. Throws InputError naming every diagnostic.
    static SolarTable read(const std::filesystem::path& file);

    /// W m-2 between two wavenumbers; nothing outside the table.
    double integral(double lower_per_cm, double upper_per_cm) const {
        return below(upper_per_cm) - below(lower_per_cm);
    }

  private:
    double below(double wavenumber_per_cm) const;

    std::vector<double> edges_per_cm_, sums_;
};

} // namespace irsg
