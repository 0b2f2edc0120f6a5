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
    std::vector<double> row; ///< of the table
    std::vector<std::string> answeredBy;
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
    /// Case `i`, where it was done before; else null.
    virtual const CaseRecord* known(std::size_t i) const = 0;
    /// False for a case that another run draws.
    virtual bool isMine(std::size_t i) const = 0;
    virtual void add(std::size_t i, const CaseRecord& record) = 0;
};

} // namespace smat
