#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {

/// What a result was asked for, as it tells itself: the project, found among `open`, beside the
/// file, beside the folder of results that the file lies in, or in the current folder, with the
/// settings that were in effect; ready to be run again. `loaded` is what loadResult gives of
/// `file`. Throws InputError that says why that is not known: a result of another program or of no
/// analysis of a project, of Monte Carlo, of a bare model, of a project that is not there or has
/// other models now, of edits that were never saved, or of settings that this version does not
/// know. `remarks`, where it is given, gets one sentence for each former name of a setting in the
/// result or the project.
AnalysisData analysisOfResult(const AnalysisData& loaded, const std::filesystem::path& file,
                              const std::vector<Project>& open = {},
                              std::vector<std::string>* remarks = nullptr);

/// The same of an image, which has to be of the size of its sensor. For PixelExplainer.
AnalysisData analysisOfImage(const irsg::RadianceImage& image, const std::filesystem::path& file,
                             const std::vector<Project>& open = {},
                             std::vector<std::string>* remarks = nullptr);

} // namespace smat
