#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/gas/GasSpectrum.h"
#include "smatcore/tools/GasOutput.h"

namespace smat {

/// What the command `gas` and the page *Hot gas* take, before a file is read.
struct GasInput {
    irsg::GasRequest gas;
    /// Files between gas and sensor, as addAtmosphere() takes them; none: the sensor stands before
    /// the gas.
    std::vector<std::filesystem::path> atmosphere = {};
    std::optional<double> altitude_m = {};       ///< of the gas, needed with an atmosphere
    std::optional<double> range_m = {};          ///< from sensor to gas, likewise
    std::optional<double> sensorAltitude_m = {}; ///< that of the gas where it is not given
};

/// What is wrong with altitudes and range, by the options of the command: missing with an
/// atmosphere, given without one, below 0, a range shorter than the difference of altitudes.
std::vector<irsg::Diagnostic> gasPathDiagnostics(const GasInput& input);
/// The same, and what irsg::gasRequestDiagnostics says.
std::vector<irsg::Diagnostic> gasInputDiagnostics(const GasInput& input);

/// Reads the atmosphere. Throws InputError with every diagnostic of the input, and for files that
/// cannot be read.
GasOutputRequest gasOutputRequest(const GasInput& input);

/// The command that writes the same file: "smat-batch gas --layer T_K=700,... --band 3-5 --out
/// gas.csv".
std::string gasCommand(const GasInput& input, const std::string& outputFile);

} // namespace smat
