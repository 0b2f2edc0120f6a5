#include "smatcore/tables/SignatureTable.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "irsg/core/Errors.h"
#include "smatcore/data/ColumnName.h"

namespace smat {

namespace {

using irsg::Quantity;

constexpr Quantity others[] = {Quantity::range, Quantity::time, Quantity::power, Quantity::mach,
                               Quantity::altitude};
constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

std::vector<double> distinct(const std::vector<double>& values) {
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    const auto rest = std::ranges::unique(sorted);
    sorted.erase(rest.begin(), rest.end());
    return sorted;
}

std::size_t placeIn(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
}

bool isAxisKey(const std::string& key) {
    if (key == irsg::info(Quantity::azimuth).key || key == irsg::info(Quantity::elevation).key)
        return true;
    return std::ranges::any_of(others,
                               [&](Quantity other) { return key == irsg::info(other).key; });
}

} // namespace

bool SignatureTable::isOne(const ResultTable& table) {
    const auto& columns = table.columns();
    if (columns.size() < 3 || columns[0].key != irsg::info(Quantity::azimuth).key ||
        columns[1].key != irsg::info(Quantity::elevation).key || table.empty())
        return false;
    return std::ranges::any_of(columns, [](const ResultColumn& column) {
        return !isAxisKey(column.key) && !column.key.starts_with("error_");
    });
}

SignatureTable::SignatureTable(const ResultTable& table) : table_(&table) {
    const auto refuse = [&](std::string position, std::string value, std::string expected) {
        throw irsg::InputError(
            {"signature table", std::move(position), std::move(value), std::move(expected)});
    };
    if (!isOne(table))
        refuse("header", "another table",
               "the columns azimuth and elevation first, and one that was measured");
    const std::vector<double>& azimuth = table.columns()[0].values;
    const std::vector<double>& elevation = table.columns()[1].values;
    std::vector<const ResultColumn*> varied;
    for (const ResultColumn& column : table.columns())
        if (!isAxisKey(column.key)) {
            columns_.push_back(&column);
        } else if (&column != table.columns().data() && &column != table.columns().data() + 1) {
            std::vector<double> values = distinct(column.values);
            if (values.size() < 2)
                continue;
            varied.push_back(&column);
            axes_.push_back({column.key, column.unit, std::move(values)});
        }
    azimuths_ = distinct(azimuth);
    elevations_ = distinct(elevation);

    std::map<std::pair<double, double>, std::size_t> known;
    std::vector<std::size_t> ofRow(table.rowCount());
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        const auto [place, isNew] =
            known.try_emplace({azimuth[row], elevation[row]}, directions_.size());
        if (isNew)
            directions_.push_back({azimuth[row], elevation[row]});
        ofRow[row] = place->second;
    }
    if (isGrid())
        for (const double row_deg : elevations_)
            for (const double column_deg : azimuths_)
                grid_.push_back(known.at({column_deg, row_deg}));

    rows_.assign(choices() * directions_.size(), none);
    for (std::size_t row = 0; row < table.rowCount(); ++row) {
        Choice choice;
        for (std::size_t i = 0; i < axes_.size(); ++i)
            choice.push_back(placeIn(axes_[i].values, varied[i]->values[row]));
        std::size_t& cell = rows_[cellOf(ofRow[row], choice)];
        if (cell != none)
            refuse(fmt::format("row {}", row + 1),
                   fmt::format("azimuth {:.6g}, elevation {:.6g} a second time", azimuth[row],
                               elevation[row]),
                   "each direction once under the same conditions");
        cell = row;
    }
    const auto missing = std::ranges::find(rows_, none);
    if (missing != rows_.end()) {
        const auto cell = static_cast<std::size_t>(missing - rows_.begin());
        const Direction& at = directions_[cell % directions_.size()];
        refuse("rows",
               fmt::format("nothing at azimuth {:.6g}, elevation {:.6g} under one of the "
                           "conditions",
                           at.azimuth_deg, at.elevation_deg),
               "a whole table, not a part of one (smat-batch merge)");
    }
}

std::size_t SignatureTable::choices() const {
    std::size_t product = 1;
    for (const Axis& axis : axes_)
        product *= axis.values.size();
    return product;
}

SignatureTable::Choice SignatureTable::choice(std::size_t number) const {
    Choice choice(axes_.size());
    for (std::size_t i = axes_.size(); i-- > 0;) {
        choice[i] = number % axes_[i].values.size();
        number /= axes_[i].values.size();
    }
    return choice;
}

std::size_t SignatureTable::cellOf(std::size_t direction, const Choice& choice) const {
    std::size_t number = 0;
    for (std::size_t i = 0; i < axes_.size(); ++i)
        number = number * axes_[i].values.size() + choice[i];
    return number * directions_.size() + direction;
}

std::size_t SignatureTable::row(std::size_t direction, const Choice& choice) const {
    return rows_[cellOf(direction, choice)];
}

const ResultColumn* SignatureTable::column(const std::string& key) const {
    const auto found = std::ranges::find(columns_, key, &ResultColumn::key);
    return found == columns_.end() ? nullptr : *found;
}

double decibelOf(double value, double floor_dB) {
    const double size = std::abs(value);
    return size > 0.0 ? std::max(10.0 * std::log10(size), floor_dB) : floor_dB;
}

} // namespace smat
