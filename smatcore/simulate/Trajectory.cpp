#include "smatcore/simulate/Trajectory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Diagnostics.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/radiometry/Units.h"

namespace smat {

namespace {

constexpr double sameTime_s = 1e-6;

using Column = TrajectoryColumn;
using Table = TrajectoryTable;

std::string allHeaders() {
    std::string text;
    for (const Column& column : Table::columns())
        text += (text.empty() ? "" : ", ") + column.header();
    return text;
}

/// From a towards b the shorter way round.
double mixedAngle_rad(double a_rad, double b_rad, double share) {
    return a_rad + std::remainder(b_rad - a_rad, 2.0 * irsg::pi) * share;
}

/// "# key: value" as it stood, but for blanks.
std::string remarkOf(const irsg::CsvComment& comment) {
    return comment.key.empty() ? "# " + comment.value : "# " + comment.key + ": " + comment.value;
}

/// Reads the rows of one table and collects what is wrong with them.
class TrajectoryReader {
  public:
    explicit TrajectoryReader(const irsg::CsvTable& csv) : csv_(csv) {}

    Table read() {
        if (csv_.rows().empty())
            throw irsg::InputError(csv_.diagnostic("no rows", "a header row " + allHeaders()));
        readHeader(csv_.rows().front());
        throwRefused();
        for (std::size_t row = 1; row < csv_.rows().size(); ++row)
            readRow(csv_.rows()[row]);
        if (csv_.rows().size() < 2)
            diagnostics_.push_back(csv_.diagnostic("no points", "at least one row of numbers"));
        throwRefused();
        for (const irsg::CsvComment& comment : csv_.comments())
            table_.remarks.push_back(remarkOf(comment));
        table_.hasPower = places_[Table::power].has_value();
        table_.hasMach = places_[Table::mach].has_value();
        return std::move(table_);
    }

  private:
    void readHeader(const irsg::CsvRow& header) {
        width_ = header.cells.size();
        for (std::size_t place = 0; place < width_; ++place) {
            const irsg::CsvCell& cell = header.cells[place];
            irsg::ColumnHead head = irsg::columnHead(cell.text);
            if (head.name == "altitude")
                head.name = "z";
            const auto* const column =
                std::find_if(columns_.begin(), columns_.end(), [&](const Column& one) {
                    return irsg::columnHead(one.header()).name == head.name;
                });
            if (column == columns_.end()) {
                diagnostics_.push_back(csv_.diagnostic(cell, "one of " + allHeaders()));
                continue;
            }
            if (!head.unit.empty() && head.unit != column->unit)
                diagnostics_.push_back(csv_.diagnostic(cell, column->header()));
            std::optional<std::size_t>& known =
                places_[static_cast<std::size_t>(column - columns_.begin())];
            if (known)
                diagnostics_.push_back(csv_.diagnostic(cell, "each column once"));
            known = place;
        }
        for (std::size_t i = 0; i < Table::columnCount; ++i) {
            if (!places_[i] && columns_[i].isRequired) {
                diagnostics_.push_back(
                    csv_.diagnostic(header.line, fmt::format("no column {}", columns_[i].name),
                                    "the columns " + allHeaders()));
            }
        }
    }

    void readRow(const irsg::CsvRow& row) {
        irsg::keepFirstDiagnostics(diagnostics_);
        if (row.cells.size() != width_) {
            diagnostics_.push_back(csv_.diagnostic(row.line,
                                                   fmt::format("{} cells", row.cells.size()),
                                                   fmt::format("{} cells", width_)));
            return;
        }
        const std::size_t before = diagnostics_.size();
        Table::Row numbers{};
        for (std::size_t i = 0; i < Table::columnCount; ++i)
            if (places_[i])
                numbers[i] = number(row.cells[*places_[i]], columns_[i]);
        if (diagnostics_.size() > before)
            return;
        constexpr auto time = Table::time;
        if (!table_.rows.empty() && !(numbers[time] > table_.rows.back()[time])) {
            diagnostics_.push_back(csv_.diagnostic(
                row.cells[*places_[time]],
                fmt::format("a time after {} s: times ascend", table_.rows.back()[time])));
            return;
        }
        table_.rows.push_back(numbers);
    }

    double number(const irsg::CsvCell& cell, const Column& column) {
        const std::string expected = column.expectation();
        const std::optional<double> value = csv_.number(cell, diagnostics_, expected);
        if (value && (*value < column.minimum || *value > column.maximum))
            diagnostics_.push_back(csv_.diagnostic(cell, expected));
        return value.value_or(0.0);
    }

    void throwRefused() const {
        if (!diagnostics_.empty())
            throw irsg::InputError(diagnostics_);
    }

    const irsg::CsvTable& csv_;
    const std::array<Column, Table::columnCount>& columns_ = Table::columns();
    std::array<std::optional<std::size_t>, Table::columnCount> places_;
    std::size_t width_ = 0;
    Table table_;
    std::vector<irsg::Diagnostic> diagnostics_;
};

TrajectoryPoint pointOf(const Table::Row& row) {
    return {.time_s = row[Table::time],
            .pose = {{row[Table::x], row[Table::y], row[Table::z]},
                     {irsg::radians(row[Table::yaw]), irsg::radians(row[Table::pitch]),
                      irsg::radians(row[Table::roll])}},
            .power = row[Table::power],
            .mach = row[Table::mach]};
}

std::vector<TrajectoryPoint> pointsOf(const Table& table) {
    std::vector<TrajectoryPoint> points;
    std::transform(table.rows.begin(), table.rows.end(), std::back_inserter(points), pointOf);
    return points;
}

} // namespace

std::string TrajectoryColumn::header() const {
    return unit.empty() ? std::string(name) : fmt::format("{} [{}]", name, unit);
}

std::string TrajectoryColumn::expectation() const {
    return fmt::format("a number from {} to {}{}{}", minimum, maximum, unit.empty() ? "" : " ",
                       unit);
}

const std::array<TrajectoryColumn, TrajectoryTable::columnCount>& TrajectoryTable::columns() {
    static constexpr std::array<TrajectoryColumn, columnCount> all = {
        {{"t", "s", -1e9, 1e9, true},
         {"x", "m", -1e9, 1e9, true},
         {"y", "m", -1e9, 1e9, true},
         {"z", "m", -1e9, 1e9, true},
         {"yaw", "deg", -360, 360, true},
         {"pitch", "deg", -90, 90, true},
         {"roll", "deg", -360, 360, true},
         {"power", "", 0, 1e6, false},
         {"mach", "", 0, 30, false}}};
    return all;
}

bool TrajectoryTable::has(Column column) const {
    return column == power ? hasPower : column == mach ? hasMach : true;
}

TrajectoryTable TrajectoryTable::read(const std::filesystem::path& file) {
    return TrajectoryReader(irsg::CsvTable::read(file)).read();
}

TrajectoryTable TrajectoryTable::parse(std::string_view text, const std::string& name) {
    return TrajectoryReader(irsg::CsvTable::parse(text, name)).read();
}

std::string TrajectoryTable::text() const {
    std::string text;
    for (const std::string& remark : remarks)
        text += remark + "\n";
    const auto addLine = [&](const auto& cell) {
        std::string line;
        for (std::size_t i = 0; i < columnCount; ++i)
            if (has(static_cast<Column>(i)))
                line += (i == 0 ? "" : ",") + cell(i);
        text += line + "\n";
    };
    addLine([](std::size_t i) { return columns()[i].header(); });
    for (const Row& row : rows)
        addLine([&](std::size_t i) { return fmt::format("{}", row[i]); });
    return text;
}

Trajectory::Trajectory(const TrajectoryTable& table)
    : Trajectory(pointsOf(table), table.hasPower, table.hasMach) {}

Trajectory::Trajectory(const irsg::Pose& pose, double power, double mach)
    : points_({{.time_s = 0.0, .pose = pose, .power = power, .mach = mach}}), standsStill_(true) {}

Trajectory::Trajectory(std::vector<TrajectoryPoint> points, bool hasPower, bool hasMach)
    : points_(std::move(points)), hasPower_(hasPower), hasMach_(hasMach) {
    const bool ascends = std::adjacent_find(points_.begin(), points_.end(),
                                            [](const TrajectoryPoint& a, const TrajectoryPoint& b) {
                                                return !(a.time_s < b.time_s);
                                            }) == points_.end();
    if (points_.empty() || !ascends)
        throw irsg::LogicError("a trajectory needs points whose times ascend");
}

Trajectory Trajectory::read(const std::filesystem::path& file) {
    return Trajectory(TrajectoryTable::read(file));
}

Trajectory Trajectory::parse(std::string_view text, const std::string& name) {
    return Trajectory(TrajectoryTable::parse(text, name));
}

std::optional<TrajectoryPoint> Trajectory::at(double time_s, bool hold) const {
    TrajectoryPoint point = points_.front();
    const TrajectoryPoint& last = points_.back();
    const bool isBefore = time_s < point.time_s, isAfter = time_s >= last.time_s;
    if (standsStill_ || isBefore || isAfter) {
        const double outside_s = isBefore ? point.time_s - time_s : time_s - last.time_s;
        if (!standsStill_ && !hold && outside_s > sameTime_s)
            return std::nullopt;
        point = isAfter ? last : point;
        point.time_s = time_s;
        return point;
    }
    const irsg::Bracket place =
        irsg::bracket(points_, time_s, irsg::Beyond::clamp, &TrajectoryPoint::time_s);
    const TrajectoryPoint &a = points_[place.below], &b = points_[place.above];
    const double share = place.fraction;
    const irsg::Vec3 &left_m = a.pose.position_m, &right_m = b.pose.position_m;
    const irsg::Attitude &from = a.pose.attitude, &to = b.pose.attitude;
    point.time_s = time_s;
    point.pose.position_m = {irsg::lerp(left_m.x, right_m.x, share),
                             irsg::lerp(left_m.y, right_m.y, share),
                             irsg::lerp(left_m.z, right_m.z, share)};
    point.pose.attitude = {mixedAngle_rad(from.yaw_rad, to.yaw_rad, share),
                           irsg::lerp(from.pitch_rad, to.pitch_rad, share),
                           mixedAngle_rad(from.roll_rad, to.roll_rad, share)};
    point.power = irsg::lerp(a.power, b.power, share);
    point.mach = irsg::lerp(a.mach, b.mach, share);
    return point;
}

} // namespace smat
