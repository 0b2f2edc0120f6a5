#pragma once

#include <optional>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/render/values/RenderReport.h"
#include "smatcore/settings/Settings.h"

namespace smat {

/// Errors that a table has beside its numbers.
enum class ErrorColumns { none, sum, causes };

/// What the setting `render.errors` asks for.
ErrorColumns errorColumnsOf(const Settings& settings);

/// What stands before the names of the quantities: "error_", "error_sampling_", ...
std::vector<const char*> errorPrefixes(ErrorColumns columns);

/// The numbers of these columns, in the same order.
void appendError(std::vector<double>& row, const irsg::ErrorParts& error, ErrorColumns columns);
/// Of intensity, contrast and irradiance; not a number where nobody knows them.
void appendErrors(std::vector<double>& row, const std::optional<irsg::RadiometryErrors>& errors,
                  ErrorColumns columns);
/// Errors that nobody knows.
irsg::ErrorParts unknownError();

/// The errors of an image's sums as its attributes, by cause: `error_contrast_intensity_W_sr`.
void describeErrors(const irsg::RadiometryErrors& errors, irsg::RadianceImage& image);

} // namespace smat
