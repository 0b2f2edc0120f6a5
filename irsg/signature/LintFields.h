#pragma once

#include <functional>
#include <string>

#include "irsg/signature/EntryFields.h"
#include "irsg/signature/LintTables.h"

namespace irsg {

/// Makes a change to an entry, or to a part of one, a repair.
template <typename Part>
using PartRepair = std::function<Finding::Repair(std::function<void(Part&)>)>;

void lintText(const std::string& place, const std::string& text, Findings& findings);

/// A text that is empty or one of some words.
void lintWord(const std::string& place, const std::string& text,
              const std::vector<std::string>& words, Findings& findings);

/// One number against its rules. Returns whether it may be used.
bool lintNumber(const std::string& place, double value, const NumberRules& rules,
                const std::function<Finding::Repair(double)>& repairTo, Findings& findings);

/// A table against its rules: its values, its loop, its axis.
void lintTable(const LintedTable& linted, const TableRules& rules, Findings& findings);

/// Every text, number and table of a part against the rules of its fields, with ".key" behind
/// `place`. Returns whether all numbers may be used.
template <typename Part>
bool lintFields(const std::string& place, const Part& part,
                std::span<const EntryField<Part>> fields, const PartRepair<Part>& repairWith,
                Findings& findings) {
    bool usable = true;
    forEachField<std::string>(fields, [&](const auto& field, auto member) {
        lintText(place + "." + field.key, part.*member, findings);
        if (field.words)
            lintWord(place + "." + field.key, part.*member, field.words(), findings);
    });
    forEachField<double>(fields, [&](const auto& field, auto member) {
        const auto repairTo = [&](double value) {
            return repairWith([member, value](Part& to) { to.*member = value; });
        };
        usable =
            lintNumber(place + "." + field.key, part.*member, field.number, repairTo, findings) &&
            usable;
    });
    forEachField<LookupTable>(fields, [&](const auto& field, auto member) {
        const LintedTable linted{
            place + "." + field.key, part.*member,
            [&](const std::function<LookupTable(const LookupTable&)>& change) {
                return repairWith([member, change](Part& to) { to.*member = change(to.*member); });
            }};
        lintTable(linted, field.table, findings);
    });
    return usable;
}

} // namespace irsg
