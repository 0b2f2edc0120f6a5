#pragma once

#include <functional>
#include <string>

#include "irsg/signature/EntryFields.h"
#include "irsg/signature/Findings.h"
#include "irsg/signature/LookupTable.h"

namespace irsg {

/// Gives a table a new value in whatever database the repair is applied to.
using TableRepair = std::function<Finding::Repair(std::function<LookupTable(const LookupTable&)>)>;

/// A table at `place` of its entry, with the way to change it.
struct LintedTable {
    std::string place;
    const LookupTable& table;
    TableRepair repairWith;
};

/// The nodes of a table with its axis multiplied by a factor above 0 and moved.
LookupTable withAxisChanged(const LookupTable& table, double factor, double offset);

/// A loop over anything but time is an error.
void refuseLoop(const LintedTable& linted, Findings& findings);
/// A loop whose last value is not its first jumps at each turn: a warning.
void lintLoop(const LintedTable& linted, Findings& findings);
/// An axis that was likely meant to be another: a warning.
void suspectAxis(const LintedTable& linted, const AxisSuspicion& suspicion, Findings& findings);

} // namespace irsg
