#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {

/// What made a result, by what it tells: Monte Carlo where it tells of draws, whose table names the
/// analysis that was repeated; else what it names (resultKindFromName). A difference is of the kind
/// of its first side.
AnalysisKind resultKindOf(const Provenance& provenance);
/// Reads back what saveResult wrote, or any result table, OpenEXR image or matrix of numbers (.csv,
/// .txt, .dat; an image by what the file holds): the table or the image with its provenance, and
/// with what that says of kind, name, state, renderer, answers and warnings; the summary is made
/// anew. A table of another program is of AnalysisKind::other: curves over an axis. A frame of a
/// simulation is an image of AnalysisKind::simulation.
/// What was asked is not in a file: project and settings stay empty.
///
/// Throws InputError for a file that is missing, damaged, or of another extension than
/// readableResultExtensions(), for a .txt or .dat that is no matrix, and for a table without rows.
AnalysisData loadResult(const std::filesystem::path& file);
/// Of files that loadResult reads: irsg::readableImageExtensions() and ".json".
std::vector<std::string> readableResultExtensions();
/// The same of a table that was read from a file of that name.
AnalysisData resultOf(ResultTable table, const std::string& file);

} // namespace smat
