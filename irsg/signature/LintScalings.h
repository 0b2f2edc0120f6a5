#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/signature/Lint.h"
#include "irsg/signature/ScalingXml.h"

namespace irsg {

/// What the two scaling files beside a model hold, and what keeps them from being read.
struct ScalingUse {
    std::string temperatureFile, emissivityFile; ///< their names, for messages
    Scalings scalings;
    std::vector<Diagnostic> diagnostics;
};

/// Reads the files beside a model; those that are not there scale nothing.
ScalingUse scalingUseOf(const std::filesystem::path& model);

/// Checks the scales beside a model against its database.
///
/// Errors: what keeps a file from being read. Warnings: scales that take an emissivity beyond one
/// less transmissivity, or a temperature at rest in air of 288.15 K out of 100 to 4000 K, with
/// percent named where it is suspected; scales that have no effect; distributions of which nine
/// draws in ten lie within a hundredth of [min, max]. No finding repairs a database.
std::vector<Finding> lintScalings(const SignatureDatabase& database, const ModelUse& model,
                                  const ScalingUse& use);

} // namespace irsg
