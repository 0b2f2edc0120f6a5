#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stop_token>
#include <string>

#include "apps/smat-batch/Command.h"
#include "smatcore/analysis/CaseFile.h"
#include "smatcore/support/Progress.h"

namespace smat::batch {

/// `--shard` and `--resume` of a command whose work has cases.
class PartOptions {
  public:
    /// `of` is what there are parts of: "the sweep".
    PartOptions(CLI::App& command, const std::string& of);

    CaseShare share() const {
        return shard_.empty() ? CaseShare() : CaseShare::fromText(shard_, "--shard");
    }
    bool resumes() const { return resumes_; }
    bool isGiven() const { return resumes_ || !shard_.empty(); }
    /// Throws InputError where either is given.
    void refuse(const std::string& expected) const;

  private:
    std::string shard_;
    bool resumes_ = false;
};

/// Where the cases of a run are.
struct CasePlace {
    std::filesystem::path result; ///< its first file
    CaseShare share;
    bool resumes = false;
    std::map<std::string, std::string> inputs; ///< as they are before anything is drawn

    CaseFile::Options options() const { return {share, resumes, inputs, 0.0}; }
};

/// Goes through the cases of a store.
using CaseWork =
    std::function<void(CaseStore& store, const ProgressCallback& progress, std::stop_token stop)>;

/// Draws cases with all processes of a team into the file of its leader. True in the leader, who
/// makes the result of them.
bool drawnByTeam(const CasePlace& place, CaseTeam& team, const CaseWork& work);

/// `work` with a line of progress; a stop that was asked for ends it.
void workThrough(CaseStore& store, const CaseWork& work);

} // namespace smat::batch
