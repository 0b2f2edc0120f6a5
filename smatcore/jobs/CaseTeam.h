#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "smatcore/analysis/CaseFile.h"
#include "smatcore/support/Progress.h"

namespace smat {

/// Several processes that draw the cases of one sweep together, each whenever it has nothing else
/// to do. One of them leads: it has the file of the cases, to which the others send theirs.
class CaseTeam {
  public:
    virtual ~CaseTeam() = default;
    virtual bool isLeader() const = 0;
    virtual std::size_t size() const = 0;
    /// Of the leader: its share, and a beginning of listening to the others. `file` outlives it.
    virtual std::unique_ptr<CaseStore> lead(CaseFile& file) = 0;
    /// Of any other, which knows by these inputs that it draws of the same sweep.
    virtual std::unique_ptr<CaseStore> follow(std::map<std::string, std::string> inputs) = 0;
    /// Of the leader: waits until all cases are in the file and tells how many are, now and then.
    /// Throws InputError where a process draws of another sweep.
    virtual void finish(const std::function<void(std::size_t done)>& progress) = 0;
    /// Of all: waits until every process is here, so that a sweep after this one begins with none
    /// still at work on it.
    virtual void meet() = 0;
};

/// Hands out the cases that are not done yet, in ascending runs, since cases that follow each other
/// share drawings and air: long runs first, single cases at the end, so that nobody waits for the
/// last one.
class CaseDispenser {
  public:
    CaseDispenser(std::vector<std::size_t> open, std::size_t takers)
        : open_(std::move(open)), takers_(takers) {}
    /// Ascending, after all that were handed out before; empty where none is left.
    std::vector<std::size_t> next();

  private:
    std::vector<std::size_t> open_;
    std::size_t takers_, given_ = 0;
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
/// makes the result of them. Throws InputError for a part of a sweep.
bool renderedByTeam(const CasePlace& place, CaseTeam& team, const CaseWork& work,
                    const ProgressCallback& progress);

} // namespace smat
