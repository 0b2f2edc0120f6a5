#include "smatcore/data/ResultDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/Interpolation.h"
#include "irsg/core/ProgramVersion.h"
#include "smatcore/data/AkimaInterpolant.h"

namespace smat {

namespace {

using irsg::Quantity;

constexpr double turn_deg = 360.0;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

[[noreturn]] void refuse(const DifferenceSide& b, const std::string& value,
                         const std::string& expected) {
    throw irsg::InputError(
        irsg::Diagnostic{.file = b.name, .position = "", .value = value, .expected = expected});
}

bool varies(const ResultColumn* column) {
    if (column == nullptr || column->values.empty())
        return false;
    const auto [least, most] = std::minmax_element(column->values.begin(), column->values.end());
    return *most - *least > 1e-9;
}

/// One column over an ascending axis; a polar one goes on after a turn, one that is smooth is as it
/// is drawn.
class Sampled {
  public:
    Sampled(const std::vector<double>& axis, const std::vector<double>& values, bool isRound,
            bool isSmooth)
        : axis_(axis), values_(values) {
        if (isSmooth && std::ranges::adjacent_find(axis, std::greater_equal<>()) == axis.end() &&
            std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
            smooth_.emplace(axis, values, isRound ? turn_deg : 0.0);
        if (!std::is_sorted(axis_.begin(), axis_.end())) {
            std::reverse(axis_.begin(), axis_.end());
            std::reverse(values_.begin(), values_.end());
        }
        if (isRound) {
            axis_.push_back(axis_.front() + turn_deg);
            values_.push_back(values_.front());
        }
    }
    /// NaN outside.
    double at(double x) const {
        if (smooth_)
            return x <= axis_.back() ? smooth_->at(x) : missing;
        return irsg::interpolate(axis_, values_, x, irsg::Beyond::notANumber);
    }

  private:
    std::vector<double> axis_, values_;
    std::optional<AkimaInterpolant> smooth_;
};

/// Strictly one way, and finite.
void checkAxis(const DifferenceSide& side, const ResultColumn& axis) {
    const auto& x = axis.values;
    const bool finite =
        std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
    const auto turnsBack = [&](auto order) {
        return std::adjacent_find(x.begin(), x.end(), order) != x.end();
    };
    const bool rises = !turnsBack([](double a, double b) { return !(a < b); });
    const bool falls = !turnsBack([](double a, double b) { return !(a > b); });
    if (x.empty() || !finite || !(rises || falls)) {
        refuse(side, x.empty() ? "no rows" : "an abscissa " + axis.header() + " that turns back",
               "rows whose abscissa only grows or only falls");
    }
}

/// Goes all the way round but for its last step.
bool isRound(const ResultTable& table, const ResultColumn& axis) {
    return !polarTypeOf(table).empty() && goesRound(axis.values, turn_deg);
}

/// Every abscissa of either that both reach.
std::vector<double> commonAxis(const DifferenceSide& a, const ResultColumn& ofA,
                               const DifferenceSide& b, const ResultColumn& ofB) {
    const auto reach = [](const DifferenceSide& side, const ResultColumn& axis) {
        auto [least, most] = std::minmax_element(axis.values.begin(), axis.values.end());
        return std::pair(*least, isRound(*side.table, axis) ? *least + turn_deg : *most);
    };
    const auto [lowA, highA] = reach(a, ofA);
    const auto [lowB, highB] = reach(b, ofB);
    const double low = std::max(lowA, lowB);
    const double high = std::min(highA, highB);
    std::set<double> axis;
    for (const auto* column : {&ofA, &ofB}) {
        for (const double x : column->values)
            if (x >= low && x <= high)
                axis.insert(x);
    }
    if (axis.empty()) {
        const auto span = [](double from, double to, const std::string& unit) {
            return irsg::numberText(from) + " to " + irsg::numberText(to) +
                   (unit.empty() ? "" : " " + unit);
        };
        refuse(b, ofB.key + " from " + span(lowB, highB, ofB.unit),
               "an overlap with " + a.name + ", " + span(lowA, highA, ofA.unit));
    }
    return {axis.begin(), axis.end()};
}

/// What the value of a table at `x` warns of: its row there, or both of those that it lies between.
std::string warningAt(const ResultTable& table, const ResultColumn& axis, double x) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < axis.values.size() && !table.warnings().empty(); ++i) {
        const double from = axis.values[i];
        const bool isLast = i + 1 == axis.values.size();
        const std::size_t next = isLast ? 0 : i + 1;
        // A polar table goes on with its first row after the last.
        const double to = !isLast                ? axis.values[next]
                          : isRound(table, axis) ? axis.values[next] + turn_deg
                                                 : from;
        if (x == from || (x - from) * (x - to) < 0.0)
            irsg::appendUnique(all, table.warnings()[i]);
        if ((x - from) * (x - to) < 0.0)
            irsg::appendUnique(all, table.warnings()[next]);
    }
    std::string text;
    for (const std::string& one : all)
        if (!one.empty())
            text += (text.empty() ? "" : "; ") + one;
    return text;
}

/// The same of both tables, with their names.
std::string warningAt(const DifferenceSide& a, const ResultColumn& axisA, const DifferenceSide& b,
                      const ResultColumn& axisB, double x) {
    std::string text;
    for (const auto& [side, axis] : {std::pair(&a, &axisA), std::pair(&b, &axisB)})
        if (const std::string own = warningAt(*side->table, *axis, x); !own.empty())
            text += (text.empty() ? "" : "; ") + side->name + ": " + own;
    return text;
}

std::string measuredKeys(const ResultTable& table) {
    std::string keys;
    for (const ResultColumn& column : table.columns())
        if (!isAbscissa(table, column))
            keys += (keys.empty() ? "" : ", ") + column.header();
    return keys.empty() ? "nothing measured" : keys;
}

} // namespace

bool isAdaptive(const ResultTable& table) {
    return table.provenance.value(table.provenance.value("analysis") + ".steps") == "adaptive";
}

std::string abscissaKey(const ResultTable& table) {
    if (table.columns().empty())
        throw irsg::LogicError("a table without columns has no abscissa");
    const ResultColumn* wavelength = table.find(Quantity::wavelength);
    return wavelength != nullptr ? wavelength->key : table.columns().front().key;
}

bool isAbscissa(const ResultTable& table, const ResultColumn& column) {
    static constexpr std::array known = {
        Quantity::angle,      Quantity::azimuth,    Quantity::elevation, Quantity::yaw,
        Quantity::wavenumber, Quantity::wavelength, Quantity::time,      Quantity::range,
        Quantity::altitude,   Quantity::power,      Quantity::mach};
    return &column == &table.columns().front() ||
           std::any_of(known.begin(), known.end(),
                       [&](Quantity quantity) { return column.key == irsg::info(quantity).key; });
}

std::string polarTypeOf(const ResultTable& table) {
    if (table.columns().empty() || table.columns().front().key != irsg::info(Quantity::angle).key)
        return "";
    const std::string stated = table.provenance.value("polar.type");
    if (!stated.empty())
        return stated;
    if (varies(table.find(Quantity::yaw)))
        return "model-yaw";
    return varies(table.find(Quantity::elevation)) ? "camera-elevation" : "camera-azimuth";
}

ResultTable differenceOf(const DifferenceSide& a, const DifferenceSide& b) {
    for (const DifferenceSide* side : {&a, &b})
        if (side->table->columns().empty())
            refuse(*side, "a table without columns", "a plot");
    const ResultColumn& axisA = *a.table->find(abscissaKey(*a.table));
    const ResultColumn& axisB = *b.table->find(abscissaKey(*b.table));
    if (axisA.header() != axisB.header())
        refuse(b, "abscissa " + axisB.header(), axisA.header() + ", as in " + a.name);
    const std::string type = polarTypeOf(*a.table);
    if (type != polarTypeOf(*b.table))
        refuse(b, "a polar plot of type " + polarTypeOf(*b.table), type + ", as in " + a.name);
    checkAxis(a, axisA);
    checkAxis(b, axisB);
    const std::vector<double> axis = commonAxis(a, axisA, b, axisB);

    ResultTable result;
    std::vector<std::vector<double>> columns = {axis};
    result.add(axisA.key, axisA.unit);
    // Where the camera or the target stood stays with the angle.
    for (const ResultColumn& column : a.table->columns()) {
        if (&column != &axisA && isAbscissa(*a.table, column) && !type.empty()) {
            result.add(column.key, column.unit);
            const Sampled sampled(axisA.values, column.values, false, false);
            columns.emplace_back();
            for (const double x : axis)
                columns.back().push_back(sampled.at(x));
        }
    }
    bool any = false;
    for (const ResultColumn& column : a.table->columns()) {
        const ResultColumn* other = b.table->find(column.key);
        if (isAbscissa(*a.table, column) || other == nullptr || other->unit != column.unit ||
            column.key.rfind("error_", 0) == 0) {
            continue;
        }
        any = true;
        const Sampled ofA(axisA.values, column.values, isRound(*a.table, axisA),
                          isAdaptive(*a.table));
        const Sampled ofB(axisB.values, other->values, isRound(*b.table, axisB),
                          isAdaptive(*b.table));
        std::vector<double> differences, relative;
        for (const double x : axis) {
            const double reference = ofB.at(x);
            differences.push_back(ofA.at(x) - reference);
            relative.push_back(reference == 0.0 ? missing
                                                : 100.0 * differences.back() / std::abs(reference));
        }
        result.add("difference_" + column.key, column.unit);
        columns.push_back(std::move(differences));
        result.add("relative_difference_" + column.key, "%");
        columns.push_back(std::move(relative));
    }
    if (!any) {
        refuse(b, measuredKeys(*b.table),
               "a column in common with " + a.name + ", which has " + measuredKeys(*a.table));
    }
    for (std::size_t row = 0; row < axis.size(); ++row) {
        std::vector<double> values;
        for (const auto& column : columns)
            values.push_back(column[row]);
        result.addRow(values, warningAt(a, axisA, b, axisB, axis[row]));
    }

    result.provenance.add("program", irsg::programWithVersion());
    result.provenance.add("analysis", "difference");
    result.provenance.add("name", a.name + " - " + b.name);
    if (!type.empty())
        result.provenance.add("polar.type", type);
    for (const DifferenceSide* side : {&a, &b}) {
        const std::string which = side == &a ? "a" : "b";
        result.provenance.add(which, side->name);
        for (const auto& [key, value] : side->table->provenance.entries)
            result.provenance.add(which + "." + key, value);
    }
    return result;
}

} // namespace smat
