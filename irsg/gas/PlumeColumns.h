#pragma once

#include <functional>
#include <string>
#include <vector>

#include "irsg/core/CsvTable.h"
#include "irsg/gas/GasLayer.h"
#include "irsg/gas/GasVector.h"

namespace irsg {

/// A number of a gas that a table of a plume may have.
struct PlumeColumn {
    const char* name; ///< without its unit
    const char* unit;
    bool isNeeded;
    double& (*of)(GasLayer&);
};
/// `T [K]`, `p [atm]`, `CO2`, `H2O`, `CO`, `CH4`, `O2`, `soot [ppmv]`.
const std::vector<PlumeColumn>& plumeGasColumns();

/// A row of a plume.
struct PlumeRow {
    GasVector place_m{}; ///< by the names of its places
    GasLayer gas;        ///< of no length
    int line = 0;
};

/// Whether the head of a table has a column of that name in metres.
bool hasPlumePlace(const CsvTable& csv, const std::string& name);

/// Calls visit(row) for each row of a table with columns of these places, such as x and r [m], and
/// of the gas: T is needed, p is 1 atm where it is missing, others 0. Throws InputError with every
/// diagnostic by file, line and column: of head and rows, of rows that are not in the limits of
/// gases, and those that check(row) adds.
void readPlumeRows(const CsvTable& csv, const std::vector<std::string>& places,
                   const std::function<void(const PlumeRow&)>& visit,
                   const std::function<std::vector<Diagnostic>(const PlumeRow&)>& check = {});

} // namespace irsg
