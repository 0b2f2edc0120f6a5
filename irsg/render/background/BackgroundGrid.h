#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "irsg/atmosphere/path/AtmosphericQuery.h"
#include "irsg/render/background/FieldRays.h"
#include "irsg/render/background/Horizon.h"

namespace irsg {

/// The radiance behind everything as rows x columns of lines of sight over the field of view (F27),
/// each asked for at its true elevation and azimuth and interpolated for every pixel: linearly in
/// azimuth and, in elevation, by a cubic through the rows that does not swing beyond them (Fritsch
/// and Carlson 1980), which with two rows is a straight line.
///
/// Rows lie closer together towards the horizon, where the sky is steepest. No cell reaches over
/// the horizon: where it lies in the field the rows are shared out between sky and ground, at least
/// one to each, with a row beside the horizon on either side; a pixel that holds the horizon gets
/// the mean of both sides weighted with their areas in it.
class BackgroundGrid {
  public:
    using Radiance = std::function<double(const LineOfSight&)>;

    /// In place of a number of rows: on either side of the horizon they are doubled until the rows
    /// between change what the others promised by half of `needed` at most, or there are
    /// `mostRows`.
    static constexpr int asManyAsNeeded = 0;
    static constexpr double needed = 0.005; ///< relative error of the radiance
    static constexpr int mostRows = 257;    ///< of one side

    /// One row or more or `asManyAsNeeded`, one column or more (LogicError). `horizon_rad` is the
    /// apparent elevation of the horizon.
    BackgroundGrid(const Sensor& sensor, const Viewpoint& viewpoint, double horizon_rad, int rows,
                   int columns, const Radiance& radiance_W_m2_sr);

    /// Of every pixel, top row first.
    std::vector<double> pixels() const;
    /// Of ground that the pixels show so far below the horizon, each in its azimuth, top row first;
    /// 0 where there is no angle. As many rows as the grid has.
    std::vector<double> groundPixels(const std::vector<std::optional<double>>& below_rad,
                                     const Radiance& radiance_W_m2_sr) const;
    /// Along a direction of the world; on the horizon, that of the sky.
    double at(const Vec3& direction) const;

    /// Elevations of the rows, ascending, and azimuths of the columns.
    std::vector<double> elevations_rad() const;
    const std::vector<double>& azimuths_rad() const { return azimuths_rad_; }

  private:
    /// The rows on one side of the horizon, from it outwards, even in a coordinate of their own.
    struct Side {
        double sign = 1.0;                ///< 1 sky, -1 ground
        double first = 0.0, perRow = 1.0; ///< coordinate of the rows
        std::vector<double> angles;       ///< from the horizon, by row
        std::vector<double> radiance;     ///< rows x columns
        std::vector<double> slopes;       ///< by row, rows x columns; none for two rows or less

        double coordinate(double angle_rad) const;
        double angleAt(double coordinate) const;
    };
    /// `coarser` has every other row of it already.
    Side side(double sign, double nearest_rad, double farthest_rad, int rows,
              const Radiance& radiance, const Side* coarser = nullptr) const;
    Side sideAsNeeded(double sign, double nearest_rad, double farthest_rad,
                      const Radiance& radiance) const;
    /// What the rows between change, relative to them.
    double changeBy(const Side& finer, const Side& coarser) const;
    void placeColumns(int columns);
    void fitCurves(Side& side) const;
    /// The rows beside an angle, and the way between them as weights of the rows and their slopes.
    struct Cell {
        std::size_t row = 0; ///< the lower of the two
        double way = 0.0, ofLow = 0.0, ofHigh = 0.0;
    };
    static Cell cellAt(const Side& side, double angle_rad);
    double valueIn(const Cell& cell, const Side& side, std::size_t column) const;
    double interpolated(const Side& side, double angle_rad, double column) const;
    /// Column coordinate of a direction whose azimuth is relative to the middle of the field.
    double column(double azimuth_rad) const;

    FieldRays rays_;
    Horizon horizon_;
    double altitude_m_;
    double middleAzimuth_rad_;
    int rows_;
    bool fullCircle_ = false;
    double firstAzimuth_rad_ = 0.0, azimuthStep_rad_ = 0.0; ///< relative to the middle
    std::vector<double> azimuths_rad_;
    Side sky_, ground_;
};

} // namespace irsg
