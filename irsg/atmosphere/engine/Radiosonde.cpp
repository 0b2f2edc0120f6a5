#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "irsg/atmosphere/engine/Hydrostatics.h"
#include "irsg/atmosphere/engine/Profile.h"
#include "irsg/core/BoundedValues.h"
#include "irsg/core/ColumnWords.h"
#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double blending_m = 5000.0;
constexpr double highestStart_m = 1000.0;
constexpr double greatestPressureStep = 0.2;
constexpr std::size_t water = static_cast<std::size_t>(Gas::H2O);

struct ProfileColumn {
    std::string_view header;
    double least;
    double most;
    std::string_view unit;
};
constexpr std::array columns = {ProfileColumn{"altitude [m]", 0.0, 120000.0, "m"},
                                ProfileColumn{"pressure [hPa]", 1e-6, 1200.0, "hPa"},
                                ProfileColumn{"temperature [K]", 100.0, 400.0, "K"},
                                ProfileColumn{"temperature [C]", -173.15, 126.85, "C"},
                                ProfileColumn{"relative_humidity [%]", 0.0, 100.0, "%"},
                                ProfileColumn{"dew_point [C]", -150.0, 100.0, "C"},
                                ProfileColumn{"h2o [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"co2 [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"o3 [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"n2o [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"co [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"ch4 [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"o2 [ppmv]", 0.0, 1e6, "ppmv"},
                                ProfileColumn{"hno3 [ppmv]", 0.0, 1e6, "ppmv"}};
/// Columns of one group say the same thing: exactly one of them is wanted.
const std::array<std::vector<std::string_view>, 4> groups = {
    {{"altitude [m]"},
     {"pressure [hPa]"},
     {"temperature [K]", "temperature [C]"},
     {"relative_humidity [%]", "dew_point [C]", "h2o [ppmv]"}}};
constexpr std::array<std::string_view, gasCount> gasHeaders = {
    "h2o [ppmv]", "co2 [ppmv]", "o3 [ppmv]", "n2o [ppmv]",
    "co [ppmv]",  "ch4 [ppmv]", "o2 [ppmv]", "hno3 [ppmv]"};

/// Names of columns in the tables of soundings that weather services print (University of Wyoming),
/// and ours; "" for those that no profile needs.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> printedNames = {
    {{"pres", "pressure"},
     {"hght", "altitude"},
     {"temp", "temperature"},
     {"dwpt", "dew_point"},
     {"relh", "relative_humidity"},
     {"mixr", ""},
     {"drct", ""},
     {"sknt", ""},
     {"sped", ""},
     {"thta", ""},
     {"thte", ""},
     {"thtv", ""}}};

/// The name of ours for that of a printed table; no value for other names.
std::optional<std::string_view> printedName(const ColumnHead& head) {
    const auto found = std::ranges::find(printedNames, head.name,
                                         &std::pair<std::string_view, std::string_view>::first);
    return found == printedNames.end() ? std::nullopt : std::optional(found->second);
}

/// The column that a head means.
const ProfileColumn* columnOf(std::string_view header) {
    ColumnHead head = columnHead(header);
    if (const auto printed = printedName(head))
        head.name = *printed;
    const auto found = std::ranges::find_if(
        columns, [&](const ProfileColumn& one) { return columnHead(one.header) == head; });
    return found == columns.end() ? nullptr : &*found;
}

std::string quoted(const std::vector<std::string_view>& words, std::string_view joint) {
    std::string text;
    for (const std::string_view word : words)
        text += (text.empty() ? "'" : std::string(joint) + "'") + std::string(word) + "'";
    return text;
}

/// One ascent on its way from cells to levels; gathers the diagnostics as it goes.
class Ascent {
  public:
    Ascent(const std::filesystem::path& file, const Profile& background, double ground_m)
        : table_(CsvTable::read(file)), background_(background), ground_m_(ground_m) {
        readHeader();
        refuse();
        const std::span<const CsvRow> rows = rowsOfAscent();
        for (const CsvRow& row : rows)
            readRow(row);
        if (rows.size() < 2)
            diagnostics_.push_back(table_.diagnostic(
                std::to_string(rows.size()) + " rows of numbers", "at least two"));
        refuse();
        humidities_.remark(table_.file());
        remarkOnFractions();
        checkTop();
        refuse();
        cutAtGround();
    }

    /// The rows, from the ground up, with the other gases of the background.
    const std::vector<AtmosphericState>& levels() const { return levels_; }
    bool has(std::size_t gas) const { return gas == water || cells_.contains(gasHeaders[gas]); }

  private:
    void refuse() {
        if (!diagnostics_.empty())
            throw InputError(std::move(diagnostics_));
    }

    /// Air whose whole humidity is 1 % and less is rather one whose fractions stand under percent.
    void remarkOnFractions() const {
        if (mostHumid_percent_ > 0.0 && mostHumid_percent_ <= 1.0)
            remarkOn(table_.file(), "no relative humidity is above " +
                                        numberText(mostHumid_percent_) +
                                        " %: fractions taken for percent? Multiply by 100");
    }

    void readHeader() {
        if (table_.rows().empty()) {
            diagnostics_.push_back(table_.diagnostic("no rows", "a header and at least two rows"));
            return;
        }
        const CsvRow& header = table_.rows().front();
        isPrinted_ = std::ranges::any_of(
            header.cells, [](const CsvCell& cell) { return columnHead(cell.text).name == "hght"; });
        std::string leftOut;
        for (std::size_t i = 0; i < header.cells.size(); ++i) {
            const CsvCell& cell = header.cells[i];
            if (isPrinted_ && printedName(columnHead(cell.text)) == "") {
                leftOut += (leftOut.empty() ? "'" : ", '") + cell.text + "'";
                continue;
            }
            const ProfileColumn* column = columnOf(cell.text);
            if (column == nullptr) {
                std::vector<std::string_view> known;
                for (const ProfileColumn& each : columns)
                    known.push_back(each.header);
                diagnostics_.push_back(table_.diagnostic(cell, "one of " + quoted(known, ", ")));
            } else if (!cells_.emplace(column->header, i).second) {
                diagnostics_.push_back(table_.diagnostic(cell, "each column once"));
            }
        }
        if (cells_.contains("dew_point [C]") && isPrinted_)
            if (const auto humidity = cells_.find("relative_humidity [%]");
                humidity != cells_.end()) {
                leftOut +=
                    (leftOut.empty() ? "'" : ", '") + header.cells[humidity->second].text + "'";
                cells_.erase(humidity);
            }
        if (!leftOut.empty())
            remarkOn(table_.file(), "leaves out " + leftOut);
        for (const auto& group : groups) {
            const auto count = std::ranges::count_if(
                group, [&](std::string_view name) { return cells_.contains(name); });
            if (count != 1)
                diagnostics_.push_back(table_.diagnostic(header.line,
                                                         std::to_string(count) + " such columns",
                                                         "one column " + quoted(group, " or ")));
        }
    }

    /// The rows of numbers, from the first level on. Of a printed table without levels that lack
    /// values (below the ground, say), and up to the text behind it.
    std::span<const CsvRow> rowsOfAscent() const {
        std::span<const CsvRow> rows = std::span(table_.rows()).subspan(1);
        if (!isPrinted_)
            return rows;
        const std::size_t width = table_.rows().front().cells.size();
        const auto end = std::ranges::find_if(
            rows, [](const CsvRow& row) { return !parseNumber(row.cells.front().text); });
        rows = rows.first(static_cast<std::size_t>(end - rows.begin()));
        std::size_t incomplete = 0;
        while (!rows.empty() && rows.front().cells.size() < width) {
            rows = rows.subspan(1);
            ++incomplete;
        }
        while (!rows.empty() && rows.back().cells.size() < width) {
            rows = rows.first(rows.size() - 1);
            ++incomplete;
        }
        if (incomplete > 0)
            remarkOn(table_.file(), "leaves out " + std::to_string(incomplete) +
                                        " levels that lack values at the ends of the ascent");
        return rows;
    }

    void readRow(const CsvRow& row) {
        const std::size_t width = table_.rows().front().cells.size();
        if (row.cells.size() != width) {
            diagnostics_.push_back(
                table_.diagnostic(row.line, std::to_string(row.cells.size()) + " cells",
                                  std::to_string(width) + " cells as in the header"));
            return;
        }
        bool isUsable = true;
        for (const auto& [header, place] : cells_) {
            const ProfileColumn& column =
                *std::ranges::find(columns, header, &ProfileColumn::header);
            const CsvCell& cell = row.cells[place];
            const std::string expected = numberText(column.least) + " to " +
                                         numberText(column.most) + " " + std::string(column.unit);
            auto value = table_.number(cell, diagnostics_, expected);
            if (value && column.unit == "%")
                value = humidities_
                            .take(*value, "line " + std::to_string(cell.line) + ", column " +
                                              std::to_string(cell.column))
                            .value_or(*value);
            if (value && column.unit == "%")
                mostHumid_percent_ = std::max(mostHumid_percent_, *value);
            if (value && !(*value >= column.least && *value <= column.most))
                diagnostics_.push_back(table_.diagnostic(cell, expected));
            isUsable = isUsable && value && *value >= column.least && *value <= column.most;
            values_[header] = value.value_or(0.0);
        }
        if (isUsable)
            addLevel(row);
    }

    const CsvCell& cell(const CsvRow& row, std::string_view header) const {
        return row.cells[cells_.at(header)];
    }

    void addLevel(const CsvRow& row) {
        AtmosphericState level = background_.at(values_["altitude [m]"] - ground_m_);
        level.pressure_hPa = values_["pressure [hPa]"];
        level.temperature_K = cells_.contains("temperature [K]")
                                  ? values_["temperature [K]"]
                                  : kelvinFromCelsius(values_["temperature [C]"]);
        for (std::size_t gas = 0; gas < gasCount; ++gas)
            if (cells_.contains(gasHeaders[gas]))
                level.moleFraction[gas] = 1e-6 * values_[gasHeaders[gas]];
        readHumidity(row, level);

        if (levels_.empty()) {
            if (level.altitude_m > highestStart_m)
                diagnostics_.push_back(table_.diagnostic(
                    cell(row, "altitude [m]"), "a first altitude of at most " +
                                                   numberText(ground_m_ + highestStart_m) +
                                                   " m, 1000 m above GroundAltitude"));
        } else {
            if (level.altitude_m <= levels_.back().altitude_m)
                diagnostics_.push_back(table_.diagnostic(
                    cell(row, "altitude [m]"),
                    "more than " + numberText(levels_.back().altitude_m + ground_m_) +
                        " m: altitudes ascend strictly"));
            if (level.pressure_hPa >= levels_.back().pressure_hPa)
                diagnostics_.push_back(
                    table_.diagnostic(cell(row, "pressure [hPa]"),
                                      "less than " + numberText(levels_.back().pressure_hPa) +
                                          " hPa: pressure falls with altitude"));
        }
        levels_.push_back(level);
    }

    void readHumidity(const CsvRow& row, AtmosphericState& level) {
        double vapour_hPa = 0.0;
        if (cells_.contains("h2o [ppmv]"))
            return;
        if (cells_.contains("dew_point [C]")) {
            const double dewPoint_K = kelvinFromCelsius(values_["dew_point [C]"]);
            if (dewPoint_K > level.temperature_K + 0.05)
                diagnostics_.push_back(table_.diagnostic(
                    cell(row, "dew_point [C]"),
                    "at most the temperature, " +
                        numberText(celsiusFromKelvin(level.temperature_K)) + " C"));
            vapour_hPa = saturationPressure_hPa(std::min(dewPoint_K, level.temperature_K));
        } else {
            vapour_hPa = 0.01 * values_["relative_humidity [%]"] *
                         saturationPressure_hPa(level.temperature_K);
        }
        // High and warm, vapour at saturation may exceed the pressure.
        level.moleFraction[water] = std::min(vapour_hPa / level.pressure_hPa, 1.0);
    }

    void checkTop() {
        const AtmosphericState& last = levels_.back();
        if (last.altitude_m <= 0.0) {
            diagnostics_.push_back(table_.diagnostic(cell(table_.rows().back(), "altitude [m]"),
                                                     "a last altitude above GroundAltitude, " +
                                                         numberText(ground_m_) + " m"));
            return;
        }
        if (last.altitude_m >= background_.top_m())
            return;
        const double expected_hPa = background_.at(last.altitude_m).pressure_hPa;
        if (std::abs(std::log(last.pressure_hPa / expected_hPa)) > greatestPressureStep)
            diagnostics_.push_back(table_.diagnostic(
                cell(table_.rows().back(), "pressure [hPa]"),
                "about " + numberText(std::round(expected_hPa * 100.0) / 100.0) +
                    " hPa, the pressure of the atmosphere above (" + background_.name() + ") at " +
                    numberText(last.altitude_m + ground_m_) + " m, within a fifth"));
    }

    /// Between two rows the air at the ground is that of a profile.
    void cutAtGround() {
        const double below_m = -levels_.front().altitude_m;
        if (!(below_m > 0.0))
            return;
        for (AtmosphericState& level : levels_)
            level.altitude_m += below_m;
        levels_ = Profile(levels_).withGroundAt(below_m).levels();
    }

    CsvTable table_;
    BoundedValues humidities_{0.0, 100.0, 100.0 * boundTolerance};
    const Profile& background_;
    double ground_m_; ///< above sea level, of which altitudes of the levels are
    std::map<std::string_view, std::size_t> cells_;
    std::map<std::string_view, double> values_;
    double mostHumid_percent_ = 0.0;
    bool isPrinted_ = false; ///< a table as weather services print it
    std::vector<AtmosphericState> levels_;
    std::vector<Diagnostic> diagnostics_;
};

double stepDown(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

/// The background moved towards what the ascent last measured.
AtmosphericState blended(const AtmosphericState& background,
                         const AtmosphericState& backgroundAtLast, const AtmosphericState& last,
                         double weight) {
    AtmosphericState air = background;
    air.temperature_K += weight * (last.temperature_K - backgroundAtLast.temperature_K);
    air.pressure_hPa *= std::pow(last.pressure_hPa / backgroundAtLast.pressure_hPa, weight);
    for (std::size_t gas = 0; gas < gasCount; ++gas)
        air.moleFraction[gas] =
            (1.0 - weight) * background.moleFraction[gas] + weight * last.moleFraction[gas];
    return air;
}

} // namespace

Profile Profile::fromRadiosonde(const std::filesystem::path& file, const Profile& background,
                                double ground_m) {
    const Ascent ascent(file, background, ground_m);
    std::vector<AtmosphericState> measured = ascent.levels();
    if (measured.front().altitude_m > 0.0) {
        AtmosphericState ground = measured.front();
        ground.altitude_m = 0.0;
        ground.pressure_hPa = hydrostaticPressure_hPa(measured.front(), ground);
        measured.insert(measured.begin(), ground);
    }
    const Profile lower(measured, file.filename().string());
    const double last_m = lower.top_m();

    // Between the rows stand the background's levels, where gases bend that were not measured.
    std::vector<double> altitudes;
    for (const AtmosphericState& level : measured)
        altitudes.push_back(level.altitude_m);
    for (const AtmosphericState& level : background.levels())
        altitudes.push_back(level.altitude_m);
    if (last_m < background.top_m())
        for (const double part : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0})
            altitudes.push_back(std::min(last_m + part * blending_m, background.top_m()));
    std::ranges::sort(altitudes);
    const auto close = [](double a, double b) { return b - a < 1e-3; };
    altitudes.erase(std::unique(altitudes.begin(), altitudes.end(), close), altitudes.end());

    const AtmosphericState backgroundAtLast = background.at(last_m);
    std::vector<AtmosphericState> levels;
    for (const double altitude_m : altitudes) {
        const AtmosphericState outside = background.at(altitude_m);
        if (altitude_m > last_m) {
            if (last_m < background.top_m())
                levels.push_back(blended(outside, backgroundAtLast, lower.levels().back(),
                                         stepDown((altitude_m - last_m) / blending_m)));
            continue;
        }
        AtmosphericState inside = lower.at(altitude_m);
        for (std::size_t gas = 0; gas < gasCount; ++gas)
            if (!ascent.has(gas))
                inside.moleFraction[gas] = outside.moleFraction[gas];
        levels.push_back(inside);
    }
    return Profile(std::move(levels), file.filename().string());
}

} // namespace irsg
