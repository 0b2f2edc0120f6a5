#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "smatcore/analysis/AnalysisData.h"

namespace smat {

/// What a result followed from and whether it is still the same: a file by its hash, the build of
/// the program, the renderer, the place of a model.
struct ReplayedInput {
    std::string role;      ///< as in InputFile, or "build", "renderer", "place"
    std::string name;      ///< of the file, or nothing
    std::string then, now; ///< empty where it is not known or not there

    bool hasChanged() const { return then != now && !then.empty(); }
};

/// How far numbers of one name are apart.
struct ReplayedDifference {
    std::string key, unit; ///< of a column, or of a channel of an image
    double largest = 0.0;  ///< of the differences, in the unit
    double scale = 0.0;    ///< the largest magnitude that the first result has
    std::string where;     ///< of the largest: "angle 90 deg", "pixel 12,34"
    /// Of the scale; infinite where that is 0.
    double relative() const;
};

/// An input that changed, and what the change did by itself.
struct ReplayedCause {
    ReplayedInput input;
    bool isKnown = false; ///< whether its effect could be told from that of the others
    std::vector<ReplayedDifference>
        effect; ///< largest first by relative(); none where nothing follows
};

/// A result that was run again from what it says of itself.
struct Replay {
    AnalysisData again;
    std::vector<ReplayedInput> inputs;
    /// Columns whose numbers are not the same to the last bit; the largest first.
    std::vector<ReplayedDifference> differences;
    /// Columns or rows that only one of both has, in words.
    std::vector<std::string> mismatches;
    /// What changed. With one change all that differs is its; of several each is told apart where
    /// its former file is at hand.
    std::vector<ReplayedCause> causes;

    /// One sentence for each former name of a setting that the result or its project has.
    std::vector<std::string> remarks;

    bool isSame() const { return differences.empty() && mismatches.empty(); }
    /// The largest relative difference; 0 where there is none.
    double largestRelative() const;
};

using RunAnalysis = std::function<void(AnalysisData&)>;

/// Runs a result again (analysisOfResult) and holds it against the file: number by number, and
/// input by input. `former` are files as they were then, known by their content: each takes the
/// place of the input that has changed since, one at a time, so that what that change did is seen.
/// `loaded` is what loadResult gives of `file`, `project` that of the result, where it does not lie
/// beside it. Throws InputError where analysisOfResult or `run` do, for a project of another name,
/// and for a former file that is none of those the result knows, or that cannot take the place
/// of the other.
Replay replay(const AnalysisData& loaded, const std::filesystem::path& file,
              const std::vector<std::filesystem::path>& former, const RunAnalysis& run,
              const std::optional<Project>& project = {});

/// Every number of `a` that `b` has, too, and that is not the same there.
std::vector<ReplayedDifference> differencesOf(const AnalysisData& a, const AnalysisData& b);

/// A page of text, and the same as JSON.
std::string replayText(const Replay& replay, const std::string& file);
std::string replayJson(const Replay& replay, const std::string& file);

} // namespace smat
