#pragma once

#include <cstdint>
#include <vector>

#include "smatcore/tables/SignatureTable.h"

namespace smat::gui {

/// Which direction of a table lies nearest to any other: on a grid the one in whose cell that is,
/// else the nearest on the sphere. Nothing where the table has none near.
class DirectionLookup {
  public:
    explicit DirectionLookup(const SignatureTable& table);

    static constexpr int nothing = -1;
    int nearest(double azimuth_deg, double elevation_deg) const;

  private:
    int nearestOfGrid(double azimuth_deg, double elevation_deg) const;
    void spread();

    const SignatureTable& table_;
    std::vector<double> azimuthEnds_, elevationEnds_; ///< of the cells of a grid
    std::vector<std::int32_t> ofPlace_; ///< half a degree each, row after row from below; else
};

} // namespace smat::gui
