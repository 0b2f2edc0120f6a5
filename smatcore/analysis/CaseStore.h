#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "smatcore/analysis/CaseWarnings.h"

namespace smat {

struct AnalysisData;

/// What one case of a sweep came to: all that it adds to the result.
struct CaseRecord {
    std::string place;       ///< AnalysisPlan::place of the case
    std::vector<double> row; ///< of the table; empty: it has none
    std::vector<std::string> providedBy;
    std::vector<CaseRemark> remarks;
    bool operator==(const CaseRecord&) const = default;
};

/// Where the cases of a sweep come from and go to, for runs in parts: cases that are known are not
/// drawn, and those of others are left out.
class CaseStore {
  public:
    virtual ~CaseStore() = default;
    /// Told before the first case: the result with its columns and provenance, still without rows.
    virtual void begin(const AnalysisData& data, std::size_t cases) = 0;
    /// The same of a run that is only rehearsed: throws as begin() would, and changes nothing.
    virtual void rehearse(const AnalysisData& /*data*/, std::size_t /*cases*/) {}
    /// Case `i`, where it was done before; else null.
    virtual const CaseRecord* known(std::size_t i) const = 0;
    /// False for a case that another run draws. Asked in ascending order by a run, once a case.
    virtual bool isMine(std::size_t i) const = 0;
    virtual void add(std::size_t i, const CaseRecord& record) = 0;
    /// How many of all cases this run comes to, for its progress.
    virtual std::size_t expected(std::size_t cases) const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < cases; ++i)
            count += known(i) != nullptr || isMine(i) ? 1 : 0;
        return count;
    }
};

} // namespace smat
