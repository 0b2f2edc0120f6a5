#pragma once

#include "smatcore/data/ResultTable.h"

namespace smat::gui::test {

/// A polar result of 36 angles, contrast intensity 100 + angle, at an elevation of 12 degrees.
inline ResultTable polarTable(const std::string& type = "") {
    ResultTable table;
    if (!type.empty()) {
        table.provenance.add("polar.type", type);
    }
    using irsg::Quantity;
    for (const auto quantity : {Quantity::angle, Quantity::azimuth, Quantity::elevation,
                                Quantity::yaw, Quantity::intensity, Quantity::contrastIntensity}) {
        table.add(quantity);
    }
    for (int angle = 0; angle < 360; angle += 10) {
        table.addRow({1.0 * angle, 1.0 * angle, 12.0, 0.0, 300.0 + angle, 100.0 + angle});
    }
    return table;
}

/// A range result, intensity 1e9 / range².
inline ResultTable rangeTable() {
    ResultTable table;
    using irsg::Quantity;
    for (const auto quantity :
         {Quantity::range, Quantity::intensity, Quantity::contrastIntensity}) {
        table.add(quantity);
    }
    for (double range = 500.0; range <= 8000.0; range += 500.0) {
        table.addRow({range, 1.2e9 / (range * range), 1e9 / (range * range)});
    }
    return table;
}

} // namespace smat::gui::test
