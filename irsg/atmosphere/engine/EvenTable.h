#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace irsg {

/// Columns over an even axis of wavenumbers: one of resources/atmosphere/continuum-*.csv.
class EvenTable {
  public:
    /// The header names the columns, the first of which is `wavenumber [cm-1]`. Throws InputError
    /// naming every diagnostic: columns that are missing, rows of another length, cells that are no
    /// number, an axis that is not even.
    static EvenTable read(const std::filesystem::path& file,
                          const std::vector<std::string>& columns);

    double lower_per_cm() const { return lower_per_cm_; }
    double upper_per_cm() const {
        return lower_per_cm_ + step_per_cm_ * static_cast<double>(rows_ - 1);
    }
    /// The place of a wavenumber in the table, by which all columns are interpolated.
    struct Place {
        std::size_t row = 0;
        double part = 0.0;
        bool inside = false;
    };
    Place place(double wavenumber_per_cm) const;
    /// Linear between rows, 0 outside.
    double at(std::size_t column, const Place& place) const;

  private:
    double lower_per_cm_ = 0.0, step_per_cm_ = 1.0;
    std::size_t rows_ = 0;
    std::vector<std::vector<double>> columns_;
};

} // namespace irsg
