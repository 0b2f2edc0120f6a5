#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "irsg/geometry/view/Pose.h"

namespace smat {

/// Where something is at a time, and what its engine does.
struct TrajectoryPoint {
    double time_s = 0.0;
    irsg::Pose pose; ///< world; yaw, pitch and roll in radians
    double power = 0.0;
    double mach = 0.0;

    bool operator==(const TrajectoryPoint&) const = default;
};

/// A column of a trajectory: its header, the range of its numbers, and whether it must be there.
struct TrajectoryColumn {
    std::string_view name, unit;
    double minimum, maximum;
    bool isRequired;
    /// "t [s]", "power".
    std::string header() const;
    /// "a number from -360 to 360 deg".
    std::string expectation() const;
};

/// The rows of a trajectory's file, as it has them: the numbers that are edited. Those of power and
/// mach are 0 where there is no such column.
struct TrajectoryTable {
    enum Column { time, x, y, z, yaw, pitch, roll, power, mach, columnCount };
    using Row = std::array<double, columnCount>;

    std::vector<std::string> remarks = {}; ///< lines of the file that begin with #, whole
    std::vector<Row> rows = {};            ///< times ascend strictly; at least one
    bool hasPower = false, hasMach = false;

    static const std::array<TrajectoryColumn, columnCount>& columns();
    bool has(Column column) const;

    /// See Trajectory::read.
    static TrajectoryTable read(const std::filesystem::path& file);
    static TrajectoryTable parse(std::string_view text, const std::string& name);
    /// The text of a file with these rows, the remarks first; reads back equal.
    std::string text() const;

    bool operator==(const TrajectoryTable&) const = default;
};

/// The path of an entity or a sensor. Between two points position, power and mach go linearly; yaw
/// and roll each take the shorter way round, so that 350 to 10 degrees passes 0. The angles are
/// interpolated one by one: near a pitch of 90 degrees points must lie close to each other.
class Trajectory {
  public:
    /// What stands still, forever.
    explicit Trajectory(const irsg::Pose& pose, double power = 0.0, double mach = 0.0);
    /// LogicError for no points and for times that do not ascend.
    Trajectory(std::vector<TrajectoryPoint> points, bool hasPower, bool hasMach);

    /// LogicError as above.
    explicit Trajectory(const TrajectoryTable& table);

    /// Reads a CSV with the columns `t [s]`, `x [m]`, `y [m]`, `z [m]` (east, north, altitude of
    /// the origin), `yaw [deg]`, `pitch [deg]`, `roll [deg]` and, where they are wanted, `power`
    /// and `mach`, in any order; the units may be left out. Lines that begin with # are remarks.
    /// Throws InputError with every diagnostic at its line and column: columns that are missing,
    /// unknown, there twice or in another unit, cells that are no numbers, times that do not
    /// ascend, positions beyond 1e9 m, yaw or roll beyond 360 and pitch beyond 90 degrees, power
    /// outside 0 to 1e6, mach outside 0 to 30.
    static Trajectory read(const std::filesystem::path& file);
    /// The same from memory; `name` stands for the file in diagnostics.
    static Trajectory parse(std::string_view text, const std::string& name);

    /// No value before the first point and after the last, unless `hold` keeps the end there. What
    /// stands still is always there. Times within a millionth of a second of an end are that end.
    std::optional<TrajectoryPoint> at(double time_s, bool hold = false) const;

    bool standsStill() const { return standsStill_; }
    bool hasPower() const { return hasPower_; }
    bool hasMach() const { return hasMach_; }
    const std::vector<TrajectoryPoint>& points() const { return points_; }

  private:
    std::vector<TrajectoryPoint> points_;
    bool standsStill_ = false;
    bool hasPower_ = false;
    bool hasMach_ = false;
};

} // namespace smat
