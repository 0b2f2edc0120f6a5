#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "smatcore/data/ResultTable.h"

namespace smat {

/// A table over directions as it is looked at and handed on: azimuth and elevation, everything else
/// that varies (range, time, engine power, Mach number, altitude), and the columns that were
/// measured. Holds no numbers of its own: the table must live as long.
class SignatureTable {
  public:
    /// Whether a result is one: it has azimuth and elevation among the axes it was swept over.
    static bool isOne(const ResultTable& table);
    /// Throws InputError for a table that is none, that has no rows, or in which a direction stands
    /// twice under the same conditions or not at all.
    explicit SignatureTable(const ResultTable& table);

    /// Something that varies beside the direction.
    struct Axis {
        std::string key, unit;      ///< "range", "m"
        std::vector<double> values; ///< rising
    };
    const std::vector<Axis>& axes() const { return axes_; } ///< those with several values
    /// One number of each axis: which of its values.
    using Choice = std::vector<std::size_t>;
    std::size_t choices() const; ///< product of the numbers of values
    Choice choice(std::size_t number) const;

    struct Direction {
        double azimuth_deg, elevation_deg;
        bool operator==(const Direction&) const = default;
    };
    const std::vector<Direction>& directions() const { return directions_; }
    /// A grid of azimuths and elevations, or directions of another kind.
    bool isGrid() const { return directions_.size() == azimuths_.size() * elevations_.size(); }
    const std::vector<double>& azimuths_deg() const { return azimuths_; }     ///< rising
    const std::vector<double>& elevations_deg() const { return elevations_; } ///< rising

    /// Columns that were measured.
    const std::vector<const ResultColumn*>& columns() const { return columns_; }
    /// Null where there is none of that key.
    const ResultColumn* column(const std::string& key) const;
    /// The row of a direction under a choice.
    std::size_t row(std::size_t direction, const Choice& choice) const;
    /// Of a grid: the number of the direction at these places of elevations and azimuths.
    std::size_t direction(std::size_t elevation, std::size_t azimuth) const {
        return grid_[elevation * azimuths_.size() + azimuth];
    }

    const ResultTable& table() const { return *table_; }

  private:
    std::size_t cellOf(std::size_t direction, const Choice& choice) const;

    const ResultTable* table_;
    std::vector<Axis> axes_;
    std::vector<Direction> directions_; ///< in the order of the table
    std::vector<double> azimuths_, elevations_;
    std::vector<std::size_t> grid_;
    std::vector<const ResultColumn*> columns_;
    std::vector<std::size_t> rows_; ///< choice after choice, direction after direction
};

/// 10 log10 of the size of a value, dB; `floor_dB` below it and for 0.
double decibelOf(double value, double floor_dB);

} // namespace smat
