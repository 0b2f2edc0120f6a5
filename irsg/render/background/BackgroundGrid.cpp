#include "irsg/render/background/BackgroundGrid.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"
#include "irsg/render/background/FastAngle.h"
#include "irsg/render/background/FieldExtent.h"

namespace irsg {

namespace {

/// How far from the horizon the rows beside it lie: 6 mm at 1000 km.
constexpr double besideHorizon_rad = 6e-9;

/// Air masses of the sky go with 1 / (angle from the horizon + about this).
constexpr double nearHorizon_rad = 0.02;
/// The ground is smoother than the sky: it needs fewer rows for the same angle.
constexpr double groundWeight = 0.7;

/// Slopes of a curve through values at even steps: those of the parabola through a point and its
/// neighbours, made flatter where a cubic would swing beyond them.
std::vector<double> gentleSlopes(const std::vector<double>& values) {
    const std::size_t last = values.size() - 1;
    const auto step = [&](std::size_t i) { return values[i + 1] - values[i]; };
    std::vector<double> slopes{1.5 * step(0) - 0.5 * step(1)};
    for (std::size_t i = 1; i < last; ++i)
        slopes.push_back(0.5 * (step(i - 1) + step(i)));
    slopes.push_back(1.5 * step(last - 1) - 0.5 * step(last - 2));

    const auto limit = [](double& slope, double secant) {
        slope = slope * secant <= 0.0
                    ? 0.0
                    : std::copysign(std::min(std::abs(slope), 3.0 * std::abs(secant)), slope);
    };
    for (std::size_t i = 0; i < last; ++i) {
        limit(slopes[i], step(i));
        limit(slopes[i + 1], step(i));
    }
    return slopes;
}

/// Fills a row, computing no more of it than is needed: between five even places a polynomial
/// through these, where a parabola through three of them gives the other two to 1e-7.
template <typename ValueAt>
void fillSmoothly(double* row, int count, const ValueAt& valueAt) {
    constexpr double enough = 1e-7;
    constexpr int fewest = 16;
    const auto fill = [&](const auto& self, int first, int last) -> void {
        const int length = last - first;
        if (length < fewest || length % 4 != 0) {
            for (int x = first + 1; x < last; ++x)
                row[x] = valueAt(x);
            return;
        }
        const int step = length / 4;
        for (int i = 1; i < 4; ++i)
            row[first + i * step] = valueAt(first + i * step);
        const double a = row[first], b = row[first + step], c = row[first + 2 * step],
                     d = row[first + 3 * step], e = row[last];
        const double most = enough * std::abs(c);
        if (std::abs(0.375 * a + 0.75 * c - 0.125 * e - b) > most ||
            std::abs(-0.125 * a + 0.75 * c + 0.375 * e - d) > most) {
            self(self, first, first + 2 * step);
            self(self, first + 2 * step, last);
            return;
        }
        // Newton's forward differences.
        const double d1 = b - a, d2 = c - 2.0 * b + a, d3 = d - 3.0 * c + 3.0 * b - a;
        const double d4 = e - 4.0 * d + 6.0 * c - 4.0 * b + a;
        for (int x = first + 1; x < last; ++x) {
            if ((x - first) % step == 0)
                continue;
            const double t = static_cast<double>(x - first) / step;
            row[x] = a + t * (d1 + (t - 1.0) / 2.0 *
                                       (d2 + (t - 2.0) / 3.0 * (d3 + (t - 3.0) / 4.0 * d4)));
        }
    };
    // Even pieces, whose lengths are multiples of four as long as that matters.
    int piece = fewest;
    while (2 * piece < count)
        piece *= 2;
    row[0] = valueAt(0);
    for (int first = 0; first + 1 < count;) {
        while (piece > 1 && first + piece >= count)
            piece /= 2;
        const int last = first + piece;
        row[last] = valueAt(last);
        fill(fill, first, last);
        first = last;
    }
}

} // namespace

BackgroundGrid::BackgroundGrid(const Sensor& sensor, const Viewpoint& viewpoint, double horizon_rad,
                               int rows, int columns, const Radiance& radiance_W_m2_sr)
    : rays_(sensor, viewpoint),
      horizon_(rays_, horizon_rad),
      altitude_m_(std::max(viewpoint.position_m.z, 0.0)),
      middleAzimuth_rad_(azimuthOf_rad(rays_.forward)),
      rows_(rows) {
    if (rows < 0 || columns < 1)
        throw LogicError("a background grid needs a row and a column");
    const FieldExtent extent = FieldExtent::of(rays_, middleAzimuth_rad_);
    fullCircle_ = extent.allAround;
    firstAzimuth_rad_ = extent.left_rad;
    azimuthStep_rad_ = extent.right_rad - extent.left_rad;
    placeColumns(columns);

    const double above_rad = extent.highest_rad - horizon_rad;
    const double below_rad = horizon_rad - extent.lowest_rad;
    if (rows == asManyAsNeeded) {
        if (above_rad > 0.0)
            sky_ = sideAsNeeded(1.0, std::max(-below_rad, 0.0), above_rad, radiance_W_m2_sr);
        if (below_rad > 0.0)
            ground_ = sideAsNeeded(-1.0, std::max(-above_rad, 0.0), below_rad, radiance_W_m2_sr);
        return;
    }

    // Rows in proportion to what each side spans in their coordinate.
    if (below_rad <= 0.0) {
        sky_ = side(1.0, -below_rad, above_rad, rows, radiance_W_m2_sr);
    } else if (above_rad <= 0.0) {
        ground_ = side(-1.0, -above_rad, below_rad, rows, radiance_W_m2_sr);
    } else {
        const int all = std::max(rows, 2);
        const double above = sky_.coordinate(above_rad), below = sky_.coordinate(below_rad);
        const double share = above / (above + groundWeight * below);
        const int ofSky = std::clamp(static_cast<int>(std::lround(share * all)), 1, all - 1);
        sky_ = side(1.0, 0.0, above_rad, ofSky, radiance_W_m2_sr);
        ground_ = side(-1.0, 0.0, below_rad, all - ofSky, radiance_W_m2_sr);
    }
}

void BackgroundGrid::placeColumns(int columns) {
    // One column stands in the middle; around the whole circle the first is the last again.
    if (columns == 1) {
        firstAzimuth_rad_ = azimuthStep_rad_ = 0.0;
        fullCircle_ = false;
    } else {
        azimuthStep_rad_ /= fullCircle_ ? columns : columns - 1;
    }
    for (int c = 0; c < columns; ++c)
        azimuths_rad_.push_back(
            std::remainder(middleAzimuth_rad_ + firstAzimuth_rad_ + c * azimuthStep_rad_, 2 * pi));
}

BackgroundGrid::Side BackgroundGrid::side(double sign, double nearest_rad, double farthest_rad,
                                          int rows, const Radiance& radiance,
                                          const Side* coarser) const {
    Side result;
    result.sign = sign;
    result.first = result.coordinate(nearest_rad);
    const double last = result.coordinate(farthest_rad);
    if (rows > 1)
        result.perRow = std::max((last - result.first) / (rows - 1), 1e-12);
    else if (nearest_rad > 0.0) // a lone row stands in the middle, else beside the horizon
        result.first = 0.5 * (result.first + last);
    for (int r = 0; r < rows; ++r) {
        const double angle_rad =
            std::max(result.angleAt(result.first + r * result.perRow), besideHorizon_rad);
        result.angles.push_back(angle_rad);
        if (coarser && r % 2 == 0) {
            const auto known = coarser->radiance.begin() +
                               static_cast<std::ptrdiff_t>(azimuths_rad_.size()) * (r / 2);
            result.radiance.insert(result.radiance.end(), known,
                                   known + static_cast<std::ptrdiff_t>(azimuths_rad_.size()));
            continue;
        }
        LineOfSight sight;
        sight.sensorAltitude_m = altitude_m_;
        sight.elevation_rad =
            std::clamp(horizon_.elevation_rad() + sign * angle_rad, -0.5 * pi, 0.5 * pi);
        for (const double azimuth_rad : azimuths_rad_) {
            sight.azimuth_rad = azimuth_rad;
            result.radiance.push_back(radiance(sight));
        }
    }
    if (rows > 2)
        fitCurves(result);
    return result;
}

BackgroundGrid::Side BackgroundGrid::sideAsNeeded(double sign, double nearest_rad,
                                                  double farthest_rad,
                                                  const Radiance& radiance) const {
    constexpr int fewest = 3;
    // Over so small a part of the angle from the horizon nothing changes.
    constexpr double narrow = 0.002;
    if (farthest_rad - nearest_rad <= narrow * nearest_rad)
        return side(sign, nearest_rad, farthest_rad, 1, radiance);
    Side coarser = side(sign, nearest_rad, farthest_rad, fewest, radiance);
    for (int rows = 2 * fewest - 1; rows <= mostRows; rows = 2 * rows - 1) {
        Side finer = side(sign, nearest_rad, farthest_rad, rows, radiance, &coarser);
        const double change = changeBy(finer, coarser);
        coarser = std::move(finer);
        if (change <= 0.5 * needed)
            break;
    }
    return coarser;
}

double BackgroundGrid::changeBy(const Side& finer, const Side& coarser) const {
    // What is nearly black beside the rest of its side need not be known as well.
    constexpr double black = 1e-4;
    double brightest = 0.0, change = 0.0;
    for (const double radiance : finer.radiance)
        brightest = std::max(brightest, std::abs(radiance));
    if (brightest == 0.0)
        return 0.0;
    const std::size_t columns = azimuths_rad_.size();
    for (std::size_t r = 1; r < finer.angles.size(); r += 2)
        for (std::size_t c = 0; c < columns; ++c) {
            const double found = finer.radiance[r * columns + c];
            const double promised = valueIn(cellAt(coarser, finer.angles[r]), coarser, c);
            change = std::max(change, std::abs(promised - found) /
                                          std::max(std::abs(found), black * brightest));
        }
    return change;
}

void BackgroundGrid::fitCurves(Side& side) const {
    const std::size_t rows = side.angles.size(), columns = azimuths_rad_.size();
    side.slopes.resize(rows * columns);
    for (std::size_t c = 0; c < columns; ++c) {
        std::vector<double> values;
        for (std::size_t r = 0; r < rows; ++r)
            values.push_back(side.radiance[r * columns + c]);
        const std::vector<double> slopes = gentleSlopes(values);
        for (std::size_t r = 0; r < rows; ++r)
            side.slopes[r * columns + c] = slopes[r];
    }
}

double BackgroundGrid::Side::coordinate(double angle_rad) const {
    const double relative = std::max(angle_rad, 0.0) / nearHorizon_rad;
    return std::log(1.0 + (sign > 0.0 ? relative : std::sqrt(relative)));
}

double BackgroundGrid::Side::angleAt(double coordinate) const {
    const double relative = std::expm1(coordinate);
    return nearHorizon_rad * (sign > 0.0 ? relative : relative * relative);
}

double BackgroundGrid::column(double azimuth_rad) const {
    return azimuthStep_rad_ > 0.0 ? (azimuth_rad - firstAzimuth_rad_) / azimuthStep_rad_ : 0.0;
}

BackgroundGrid::Cell BackgroundGrid::cellAt(const Side& side, double angle_rad) {
    Cell cell;
    if (!side.slopes.empty()) {
        const double place = (side.coordinate(angle_rad) - side.first) / side.perRow;
        cell.row = static_cast<std::size_t>(
            std::clamp(place, 0.0, static_cast<double>(side.angles.size() - 2)));
        const double t = std::clamp(place - static_cast<double>(cell.row), 0.0, 1.0);
        cell.way = t * t * (3.0 - 2.0 * t);
        cell.ofLow = t * (1.0 - t) * (1.0 - t);
        cell.ofHigh = -t * t * (1.0 - t);
    } else if (side.angles.size() > 1) {
        const double width = side.angles[1] - side.angles[0];
        cell.way = width > 0.0 ? std::clamp((angle_rad - side.angles[0]) / width, 0.0, 1.0) : 0.0;
    }
    return cell;
}

double BackgroundGrid::valueIn(const Cell& cell, const Side& side, std::size_t column) const {
    const std::size_t columns = azimuths_rad_.size();
    const std::size_t low = cell.row * columns + column, high = low + columns;
    if (side.angles.size() == 1)
        return side.radiance[low];
    const double straight =
        side.radiance[low] + cell.way * (side.radiance[high] - side.radiance[low]);
    return side.slopes.empty()
               ? straight
               : straight + cell.ofLow * side.slopes[low] + cell.ofHigh * side.slopes[high];
}

double BackgroundGrid::interpolated(const Side& side, double angle_rad, double column) const {
    const Cell cell = cellAt(side, angle_rad);
    const std::size_t columns = azimuths_rad_.size();
    if (columns == 1)
        return valueIn(cell, side, 0);

    const double last = static_cast<double>(fullCircle_ ? columns : columns - 1);
    const double place = std::clamp(column, 0.0, last);
    const std::size_t left =
        std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(last) - 1);
    const double a = valueIn(cell, side, left), b = valueIn(cell, side, (left + 1) % columns);
    return a + (place - static_cast<double>(left)) * (b - a);
}

double BackgroundGrid::at(const Vec3& direction) const {
    const double angle_rad = elevationOf_rad(direction) - horizon_.elevation_rad();
    const double azimuth_rad =
        std::remainder(azimuthOf_rad(direction) - middleAzimuth_rad_, 2.0 * pi);
    const bool sky = ground_.angles.empty() || (angle_rad >= 0.0 && !sky_.angles.empty());
    return interpolated(sky ? sky_ : ground_, sky ? angle_rad : -angle_rad, column(azimuth_rad));
}

std::vector<double> BackgroundGrid::pixels() const {
    static const FastAngle angle;
    std::vector<double> result;
    result.reserve(static_cast<std::size_t>(rays_.width_px) *
                   static_cast<std::size_t>(rays_.height_px));
    const bool both = !sky_.angles.empty() && !ground_.angles.empty();
    const bool turns = azimuths_rad_.size() > 1;

    // Directions in axes whose y is the azimuth of the middle, so that azimuths need no wrapping.
    const double sine = std::sin(middleAzimuth_rad_), cosine = std::cos(middleAzimuth_rad_);
    const auto turned = [&](const Vec3& d) {
        return Vec3{d.x * cosine - d.y * sine, d.x * sine + d.y * cosine, d.z};
    };
    const Vec3 right = turned(rays_.right), up = turned(rays_.up), forward = turned(rays_.forward);
    // Within a quarter of so narrow a row the horizon rises by less than a pixel.
    constexpr double narrow = 0.27, rowsOfHorizon = 3.0;
    const double pixel_rad = rays_.u(1.0) - rays_.u(0.0);
    const bool isNarrow = rays_.u(rays_.width_px) < narrow && rays_.v(0.0) < narrow;
    for (int y = 0; y < rays_.height_px; ++y) {
        const double v = rays_.v(y + 0.5);
        const Vec3 start = forward + up * v;
        const auto directionAt = [&](int x) {
            const double u = rays_.u(x + 0.5);
            return Vec3{start.x + u * right.x, start.y + u * right.y, start.z + u * right.z};
        };
        const auto aboveHorizon_rad = [&](const Vec3& d) {
            return angle(d.z, std::sqrt(d.x * d.x + d.y * d.y)) - horizon_.elevation_rad();
        };
        const auto radianceAt = [&](int x) {
            const Vec3 d = directionAt(x);
            const double above_rad = aboveHorizon_rad(d);
            const double place = turns ? column(angle(d.x, d.y)) : 0.0;
            const double sky = both                     ? horizon_.skyFraction(rays_.u(x + 0.5), v)
                               : ground_.angles.empty() ? 1.0
                                                        : 0.0;
            double radiance = 0.0;
            if (sky > 0.0)
                radiance += sky * interpolated(sky_, above_rad, place);
            if (sky < 1.0)
                radiance += (1.0 - sky) * interpolated(ground_, -above_rad, place);
            return radiance;
        };
        result.resize(result.size() + static_cast<std::size_t>(rays_.width_px));
        double* const row = &result[result.size() - static_cast<std::size_t>(rays_.width_px)];
        const auto isAwayFromHorizon = [&] {
            for (int i = 0; i <= 4; ++i)
                if (std::abs(aboveHorizon_rad(directionAt(i * (rays_.width_px - 1) / 4))) <
                    rowsOfHorizon * pixel_rad)
                    return false;
            return true;
        };
        if (!turns && isNarrow && (!both || isAwayFromHorizon()))
            fillSmoothly(row, rays_.width_px, radianceAt);
        else
            for (int x = 0; x < rays_.width_px; ++x)
                row[x] = radianceAt(x);
    }
    return result;
}

std::vector<double>
BackgroundGrid::groundPixels(const std::vector<std::optional<double>>& below_rad,
                             const Radiance& radiance_W_m2_sr) const {
    std::vector<double> result(below_rad.size(), 0.0);
    double nearest_rad = 0.5 * pi, farthest_rad = -1.0;
    for (const std::optional<double>& below : below_rad)
        if (below) {
            nearest_rad = std::min(nearest_rad, *below);
            farthest_rad = std::max(farthest_rad, *below);
        }
    if (farthest_rad < 0.0)
        return result;
    const Side ground = rows_ == asManyAsNeeded
                            ? sideAsNeeded(-1.0, nearest_rad, farthest_rad, radiance_W_m2_sr)
                            : side(-1.0, nearest_rad, farthest_rad, rows_, radiance_W_m2_sr);
    const auto width = static_cast<std::size_t>(rays_.width_px);
    for (std::size_t i = 0; i < below_rad.size(); ++i) {
        if (!below_rad[i])
            continue;
        const Vec3 direction = rays_.at(rays_.u(static_cast<double>(i % width) + 0.5),
                                        rays_.v(static_cast<double>(i / width) + 0.5));
        result[i] = interpolated(
            ground, *below_rad[i],
            column(std::remainder(azimuthOf_rad(direction) - middleAzimuth_rad_, 2.0 * pi)));
    }
    return result;
}

std::vector<double> BackgroundGrid::elevations_rad() const {
    std::vector<double> result;
    for (auto angle_rad = ground_.angles.rbegin(); angle_rad != ground_.angles.rend(); ++angle_rad)
        result.push_back(horizon_.elevation_rad() - *angle_rad);
    for (const double angle_rad : sky_.angles)
        result.push_back(horizon_.elevation_rad() + angle_rad);
    return result;
}

} // namespace irsg
