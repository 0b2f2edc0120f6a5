#include "irsg/atmosphere/import/SightTable.h"

#include <algorithm>
#include <utility>

#include "irsg/core/Errors.h"
#include "irsg/radiometry/Units.h"

namespace irsg {

namespace {

constexpr double sameAltitude_m = 0.1;
constexpr double sameElevation_rad = 1e-6;

/// Both ends of an axis of metres or degrees.
std::string extent(double lower, double upper, const char* unit) {
    return lower == upper ? metresText(lower) + unit
                          : metresText(lower) + " to " + metresText(upper) + unit;
}

double rounded_deg(double elevation_rad) {
    return std::round(1e4 * degrees(elevation_rad)) / 1e4;
}

void compare(const std::vector<double>& guess, const std::vector<double>& truth, ErrorSum& sum) {
    const double largest = *std::ranges::max_element(truth);
    for (std::size_t i = 0; i < truth.size() && largest > 0.0; ++i)
        sum.add((guess[i] - truth[i]) / largest);
    sum.endNode();
}

} // namespace

void SightTable::add(double altitude_m, double elevation_rad, std::vector<double> values) {
    if (values.empty() || holds(altitude_m, elevation_rad) ||
        (!rows_.empty() && values.size() != rows_.front().values.front().size())) {
        throw LogicError("a direction does not fit its table");
    }
    auto row = std::ranges::find_if(rows_, [&](const Row& one) {
        return std::abs(one.altitude_m - altitude_m) < sameAltitude_m;
    });
    if (row == rows_.end()) {
        row = rows_.insert(std::ranges::upper_bound(rows_, altitude_m, {}, &Row::altitude_m),
                           Row{altitude_m, {}, {}});
    }
    const auto after = std::ranges::upper_bound(row->elevations_rad, elevation_rad);
    row->values.insert(row->values.begin() + (after - row->elevations_rad.begin()),
                       std::move(values));
    row->elevations_rad.insert(after, elevation_rad);
}

bool SightTable::holds(double altitude_m, double elevation_rad) const {
    return std::ranges::any_of(rows_, [&](const Row& row) {
        return std::abs(row.altitude_m - altitude_m) < sameAltitude_m &&
               std::ranges::any_of(row.elevations_rad, [&](double other) {
                   return std::abs(other - elevation_rad) < sameElevation_rad;
               });
    });
}

bool SightTable::blend(double altitude_m, double elevation_rad, const Row* withoutRow,
                       std::size_t first, std::size_t last, std::vector<double>& out) const {
    std::vector<const Row*> rows;
    std::vector<double> altitudes;
    for (const Row& row : rows_) {
        if (&row != withoutRow) {
            rows.push_back(&row);
            altitudes.push_back(row.altitude_m);
        }
    }
    const auto vertical = bracketOf(altitudes, altitude_m, altitudeTolerance_m);
    if (!vertical)
        return false;
    out.assign(last - first, 0.0);
    for (const auto& [index, weight] : {std::pair{vertical->below, 1.0 - vertical->fraction},
                                        {vertical->above, vertical->fraction}}) {
        if (weight == 0.0)
            continue;
        const Row& row = *rows[index];
        const auto place = bracketOf(row.elevations_rad, elevation_rad, elevationTolerance_rad);
        if (!place)
            return false;
        for (std::size_t i = first; i < last; ++i) {
            out[i - first] += weight * ((1.0 - place->fraction) * row.values[place->below][i] +
                                        place->fraction * row.values[place->above][i]);
        }
    }
    return true;
}

std::vector<double> SightTable::at(double altitude_m, double elevation_rad, std::size_t first,
                                   std::size_t last, const std::string& owner,
                                   const char* what) const {
    std::vector<double> values;
    if (!blend(altitude_m, elevation_rad, nullptr, first, last, values)) {
        throw InputError({owner, what,
                          "altitude " + metresText(altitude_m) + " m, elevation " +
                              numberText(rounded_deg(elevation_rad)) + " deg",
                          "a direction between those of its runs: " + span()});
    }
    return values;
}

RunDistance SightTable::nearest(double altitude_m, double elevation_rad) const {
    std::vector<RunDistance> all;
    for (const Row& row : rows_)
        for (const double node_rad : row.elevations_rad)
            all.push_back({.altitude_m = std::abs(row.altitude_m - altitude_m),
                           .elevation_deg = degrees(std::abs(node_rad - elevation_rad))});
    return *std::ranges::min_element(all, {}, &RunDistance::sum);
}

std::vector<LineOfSight> SightTable::sights() const {
    std::vector<LineOfSight> all;
    for (const Row& row : rows_)
        for (std::size_t i = 0; i < row.elevations_rad.size(); ++i) {
            all.push_back({row.altitude_m, row.elevations_rad[i], 0.0});
            if (i > 0)
                all.push_back({row.altitude_m,
                               0.5 * (row.elevations_rad[i - 1] + row.elevations_rad[i]), 0.0});
        }
    return all;
}

std::string SightTable::span() const {
    if (rows_.empty())
        return "no direction";
    double lowest = rows_.front().elevations_rad.front();
    double highest = lowest;
    std::size_t count = 0;
    for (const Row& row : rows_) {
        lowest = std::min(lowest, row.elevations_rad.front());
        highest = std::max(highest, row.elevations_rad.back());
        count += row.elevations_rad.size();
    }
    return "altitude " + extent(rows_.front().altitude_m, rows_.back().altitude_m, " m") +
           ", elevation " + extent(rounded_deg(lowest), rounded_deg(highest), " deg") + " (" +
           std::to_string(count) + (count == 1 ? " direction)" : " directions)");
}

std::vector<InterpolationError> SightTable::errors(const std::string& quantity) const {
    std::vector<InterpolationError> results;
    ErrorSum elevations;
    ErrorSum altitudes;
    bool severalElevations = false;
    std::vector<double> guess;
    for (const Row& row : rows_) {
        severalElevations = severalElevations || row.elevations_rad.size() > 1;
        for (std::size_t k = 1; k + 1 < row.elevations_rad.size(); ++k) {
            const double weight = (row.elevations_rad[k] - row.elevations_rad[k - 1]) /
                                  (row.elevations_rad[k + 1] - row.elevations_rad[k - 1]);
            guess = row.values[k - 1];
            for (std::size_t i = 0; i < guess.size(); ++i)
                guess[i] = (1.0 - weight) * guess[i] + weight * row.values[k + 1][i];
            compare(guess, row.values[k], elevations);
        }
        if (&row == &rows_.front() || &row == &rows_.back())
            continue;
        for (std::size_t k = 0; k < row.elevations_rad.size(); ++k)
            if (blend(row.altitude_m, row.elevations_rad[k], &row, 0, row.values[k].size(), guess))
                compare(guess, row.values[k], altitudes);
    }
    if (severalElevations)
        results.push_back(elevations.result(quantity, "elevation"));
    if (rows_.size() > 1)
        results.push_back(altitudes.result(quantity, "altitude"));
    return results;
}

} // namespace irsg
