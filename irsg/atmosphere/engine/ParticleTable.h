#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace irsg {

/// One of the tables of particles (resources/atmosphere/particles-*.csv): a header of column names,
/// rows ascending in the first column.
class ParticleTable {
  public:
    /// What the columns after the first may hold.
    enum class Kind {
        optics,     ///< by name: *_ext* > 0, *_abs* from 0 to its *_ext*, *_asym* from -1 to 1;
                    ///< the first column, a wavelength in um, covers 0.2 to 40
        logarithms, ///< from -20 to 20; the first column as above
        profile ///< 0 or more, at least two rows; the first column, an altitude in m, begins at 0
    };

    /// Throws InputError naming every diagnostic: columns that are missing, rows of another length,
    /// cells that are no number or break the rule, a first column that does not ascend.
    static ParticleTable read(const std::filesystem::path& file, Kind kind,
                              const std::vector<std::string>& columns);

    const std::vector<double>& first() const { return columns_.front(); }
    /// LogicError for a name that was not asked for in `read`.
    const std::vector<double>& column(const std::string& name) const;

  private:
    std::vector<std::string> names_; ///< of columns_
    std::vector<std::vector<double>> columns_;
};

} // namespace irsg
