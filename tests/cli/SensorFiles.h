#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "irsg/sensor/SensorFile.h"
#include "smatcore/data/ResultTable.h"
#include "tests/cli/PlainScene.h"
#include "tests/cli/Program.h"
#include "tests/support/SmallSensor.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {

/// The small sensor as a file.
inline std::string sensorFile(const TemporaryFolder& folder,
                              const irsg::SensorDescription& sensor = smallSensor()) {
    saveSensor(sensor, folder / "small.smatsensor");
    return folder / "small.smatsensor";
}

/// NaN where there is no such column.
inline double valueOf(const ResultTable& table, const std::string& column, std::size_t row) {
    const ResultColumn* found = table.find(column);
    return found == nullptr ? std::nan("") : found->values.at(row);
}

} // namespace smat::test
