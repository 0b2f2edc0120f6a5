#pragma once

#include <string>

#include "apps/smat-batch/Command.h"
#include "smatcore/analysis/CaseFile.h"

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

} // namespace smat::batch
