#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/image/RadianceImage.h"
#include "irsg/signature/SignatureDatabase.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/Project.h"
#include "smatcore/support/StageTimer.h"

namespace smat {

enum class AnalysisState { notRun, complete, partial };

/// A number worth saying about a result: "peak contrast intensity", 12.3, "W sr-1".
struct SummaryItem {
    std::string label;
    double value = 0.0;
    std::string unit;
    std::optional<double> error = {}; ///< in the same unit, see docs/errors.md
};

/// One analysis: what it is asked, and, once AnalysisGenerator has run it, what came out.
struct AnalysisData {
    // What is asked.
    std::string name;
    AnalysisKind kind = AnalysisKind::image;
    Project project;
    Settings settings;       ///< all in effect: those of the project with the overrides on top
    std::string commandLine; ///< goes into the provenance where it is not empty

    // What came out.
    AnalysisState state = AnalysisState::notRun;
    irsg::RadianceImage image; ///< of an image analysis, else empty
    ResultTable table;         ///< of every kind; an image gives one row of sums
    std::vector<SummaryItem> summary;
    /// Of a spectrum: the sums of the same view over the band, as an image has them, without error
    /// once they were saved.
    std::vector<SummaryItem> inBand;
    /// The signature databases of the models as they were, edits that are not saved included; empty
    /// where that is not known.
    std::vector<std::shared_ptr<const irsg::SignatureDatabase>> databases;
    std::vector<std::string> providedBy; ///< "transmittance: vacuum"
    std::vector<std::string> warnings;   ///< each said once
    std::string renderer;
    double elapsed_s = 0.0;
    /// Where the time went, with a sum of elapsed_s or a little more; empty where nobody took it.
    /// Never saved.
    std::vector<StageTimer::Stage> stages;

    /// The analysis `name` of a project, ready to run. Throws InputError listing the names there
    /// are.
    static AnalysisData of(const Project& project, const std::string& name);
    /// An analysis of a kind with the project's own settings and `overrides` on top.
    static AnalysisData of(const Project& project, AnalysisKind kind,
                           const Settings& overrides = {});
    /// The command that does the same from a terminal.
    std::string equivalentCommand(const std::string& outputFile) const;
};

/// The extensions a result of this kind can be saved with: images in every format of
/// irsg::imageFormats() and their row of sums as .json, tables as .csv and .json.
std::vector<std::string> resultExtensions(AnalysisKind kind);
/// Of these the ones that `smat-batch run` writes: .exr, .csv, .png and .json of an image.
std::vector<std::string> usualResultExtensions(AnalysisKind kind);
/// Throws InputError naming the extensions there are, so that a wrong name is refused before the
/// work begins.
void checkResultFile(AnalysisKind kind, const std::filesystem::path& file);
/// The same of a result that is there: a frame of a simulation is written as other images are.
void checkResultFile(const AnalysisData& data, const std::filesystem::path& file);
/// Writes a result in the form of its extension. Throws InputError where checkResultFile does and
/// for a file that cannot be written.
void saveResult(const AnalysisData& data, const std::filesystem::path& file);

} // namespace smat
