#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "irsg/atmosphere/NearestRun.h"
#include "irsg/atmosphere/import/Interpolation.h"
#include "irsg/atmosphere/path/AtmosphericQuery.h"

namespace irsg {

/// Optical depth, and radiance where there is some, of finite paths over (sensor altitude, target
/// altitude, range) and a spectral axis.
///
/// Over range, for each pair of altitudes: optical depth by monotone cubics through (0, 0) and the
/// nodes, but below the first node as a R / sqrt(1 + b R) through the first two, which is Beer's
/// law near the sensor and the square root law of strong lines farther away (R. M. Goody 1952, Q.
/// J. R. Meteorol. Soc. 78, 165); proportional to range where there is only one node. Radiance
/// through its equivalent source J = L / (1 - tau), by monotone cubics between the nodes and held
/// below the first. Over altitudes: the logarithm of depth, and J, at the asked range bilinearly
/// between the surrounding pairs, or, for horizontal paths, linearly between horizontal ones. A
/// path whose surrounding pairs are not all there is outside the table, also one longer than the
/// longest node of any of them. Nodes are met exactly. Altitudes are clamped to the table within
/// `altitudeTolerance_m`, ranges may be 0.01 % + 1 m longer. Depths of 0 transmittance are unknown:
/// they count as at least 40 and continue the node before in proportion to range.
class PathTable {
  public:
    static constexpr double altitudeTolerance_m = 10.0;

    /// Spectral values of every node have the same length; `radiance` may be empty. Infinite depths
    /// are opaque. LogicError for a node that is there twice or does not fit.
    void add(const AtmosphericPath& path, std::vector<double> depth, std::vector<double> radiance);
    bool holds(const AtmosphericPath& path) const;
    bool isEmpty() const { return nodes_.empty(); }

    struct Answer {
        std::vector<double> depth;
        std::vector<double> radiance; ///< empty where the table has none
    };
    /// Values at spectral indices first to last - 1. Throws InputError that names `owner`, the path
    /// and the table's span for a path outside the table.
    Answer at(const AtmosphericPath& path, std::size_t first, std::size_t last,
              const std::string& owner) const;

    /// How far the nearest node is; the table is not empty.
    RunDistance nearest(const AtmosphericPath& path) const;

    /// The longest path between every pair of altitudes.
    std::vector<AtmosphericPath> longest() const;

    /// "sensor 0 to 2000 m, target 0 m, range up to 5000 m (12 paths)".
    std::string span() const;
    /// Leave-one-out errors over range and over every altitude axis that has more than one node.
    /// `quantity` names the depth: "transmittance" compares exp(-depth); of a scattering depth the
    /// same is compared.
    std::vector<InterpolationError> errors(const std::string& quantity) const;

  private:
    struct Node {
        AtmosphericPath path;
        std::vector<double> depth;
        std::vector<double> source;
    };
    struct Pair {
        double sensor_m = 0.0;
        double target_m = 0.0;
        std::vector<double> ranges_m;   ///< 0 and the nodes', ascending
        std::vector<std::size_t> nodes; ///< of nodes_, one less
    };
    /// Nodes of one curve over range, filled again for every wavenumber.
    struct Curve {
        std::vector<double> x;
        std::vector<double> y;
    };
    struct Corner {
        const Pair* pair = nullptr;
        double weight = 0.0;
    };

    void place(std::size_t node);
    const Pair* pair(double sensor_m, double target_m) const;
    std::vector<Corner> corners(double sensor_m, double target_m, const Pair* without) const;
    std::vector<Corner> between(double sensor_m, double target_m, const Pair* without) const;
    bool reaches(const std::vector<Corner>& corners, double range_m) const;
    double depthAt(const Pair& pair, double range_m, std::size_t index, std::size_t without,
                   Curve& curve) const;
    double sourceAt(const Pair& pair, double range_m, std::size_t index, std::size_t without,
                    Curve& curve) const;
    Answer blend(const std::vector<Corner>& corners, double range_m, std::size_t first,
                 std::size_t last) const;
    void compare(const Answer& guess, const Node& node, ErrorSum& depth, ErrorSum& radiance) const;

    std::vector<Node> nodes_;
    std::vector<Pair> pairs_;
};

} // namespace irsg
