#include "irsg/signature/LintFields.h"

#include <algorithm>
#include <cmath>

#include "irsg/core/Utf8.h"

namespace irsg {

namespace {

/// A share above this is a percentage.
constexpr double leastPercent = 2.0;
constexpr double wholePercent = 100.0;
constexpr double halfTurn_deg = 180.0;
constexpr double fullTurn_deg = 360.0;

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most;
}

LookupTable withoutNegatives(const LookupTable& table) {
    std::vector<double> values = table.y();
    for (double& value : values)
        value = std::max(value, 0.0);
    return {table.x(), values, table.loop()};
}

void refuseNegatives(const LintedTable& linted, const TableRules& rules, Findings& findings) {
    const double lowest = std::ranges::min(linted.table.y());
    if (rules.leastValue != 0.0 || lowest >= 0.0)
        return;
    Finding& found = findings.error(linted.place, numberText(lowest),
                                    std::string(rules.value) + "s of at least 0");
    found.remedy = "set what is negative to 0";
    found.repair = linted.repairWith(withoutNegatives);
}

/// A full turn whose halves mirror each other says no more than its first half.
bool mirrorsAtHalfATurn(const LookupTable& table) {
    const auto& angles_deg = table.x();
    return angles_deg.front() == 0.0 && angles_deg.back() == fullTurn_deg &&
           std::ranges::all_of(angles_deg, [&](double angle_deg) {
               return std::abs(table.at(angle_deg) - table.at(fullTurn_deg - angle_deg)) <= 1e-9;
           });
}

LookupTable firstHalf(const LookupTable& table) {
    std::vector<double> angles_deg;
    std::vector<double> values;
    for (const double angle_deg : table.x()) {
        if (angle_deg < halfTurn_deg) {
            angles_deg.push_back(angle_deg);
            values.push_back(table.at(angle_deg));
        }
    }
    angles_deg.push_back(halfTurn_deg);
    values.push_back(table.at(halfTurn_deg));
    return {angles_deg, values};
}

void lintPositions(const LintedTable& linted, const TableRules& rules, Findings& findings) {
    const auto& axis = linted.table.x();
    if (axis.front() >= rules.leastPosition && axis.back() <= rules.mostPosition)
        return;
    const std::string unit = " " + std::string(rules.unit);
    Finding& found = findings.error(
        linted.place, numberText(axis.front()) + " to " + numberText(axis.back()) + unit,
        "angles from " + numberText(rules.leastPosition) + " to " + numberText(rules.mostPosition) +
            unit);
    if (rules.mostPosition == halfTurn_deg && mirrorsAtHalfATurn(linted.table)) {
        found.remedy = "keep the half from 0 to 180 deg: the other mirrors it";
        found.repair = linted.repairWith(firstHalf);
    }
}

} // namespace

void lintText(const std::string& place, const std::string& text, Findings& findings) {
    if (!isUtf8(text))
        findings.error(place, "bytes that are not UTF-8", "text in UTF-8");
}

void lintWord(const std::string& place, const std::string& text,
              const std::vector<std::string>& words, Findings& findings) {
    if (text.empty() || std::ranges::find(words, text) != words.end())
        return;
    std::string expected;
    for (const std::string& word : words)
        expected += "'" + word + "' or ";
    findings.error(place, "'" + text + "'", expected + "nothing");
}

bool lintNumber(const std::string& place, double value, const NumberRules& rules,
                const std::function<Finding::Repair(double)>& repairTo, Findings& findings) {
    if (!std::isfinite(value) || !isWithin(value, rules.least, rules.most)) {
        findings.error(place, numberText(value), rules.expected);
        return false;
    }
    if (!isWithin(value, rules.likelyLeast, rules.likelyMost)) {
        Finding& found = findings.warning(place, numberText(value), rules.likely);
        if (value > leastPercent && value <= rules.mostPercent) {
            found.remedy = "percent taken for a fraction? Divide by 100";
            found.repair = repairTo(value / wholePercent);
        }
    }
    return true;
}

void lintTable(const LintedTable& linted, const TableRules& rules, Findings& findings) {
    if (linted.table.empty())
        return;
    refuseNegatives(linted, rules, findings);
    if (rules.mayLoop)
        lintLoop(linted, findings);
    else
        refuseLoop(linted, findings);
    lintPositions(linted, rules, findings);
    suspectAxis(linted, rules.suspicion, findings);
}

} // namespace irsg
