#pragma once

#include <set>
#include <string>
#include <vector>

#include "irsg/geometry/flight/FlightFile.h"
#include "irsg/geometry/flight/FlightRecords.h"

namespace irsg {

/// What the walk over the records of one OpenFlight file finds and keeps: diagnostics, remarks, and
/// the records that go on to the plug-in.
class FlightLog {
  public:
    /// `file.bytes` must be set and stay where they are.
    explicit FlightLog(FlightFile& file) : file_(file) {}

    FlightFile& file() { return file_; }
    std::vector<Diagnostic>& diagnostics() { return diagnostics_; }

    void report(std::size_t offset, const std::string& value, const std::string& expected);
    void remark(const std::string& text) { file_.remarks.push_back(text); }
    void remarkOnce(const std::string& key, const std::string& text);
    void keep(const FlightRecord& record, FlightTreatment treatment = FlightTreatment::keep);

    /// False, and a diagnostic, for a record of fewer bytes.
    bool atLeast(const FlightRecord& record, std::size_t size);
    /// Three doubles of a position within 1e9 m.
    void coordinate(const FlightRecord& record, std::size_t at);
    /// `count` finite doubles.
    void finite(const FlightRecord& record, std::size_t at, std::size_t count);

  private:
    FlightFile& file_;
    std::vector<Diagnostic> diagnostics_;
    std::set<std::string> remarked_;
};

} // namespace irsg
