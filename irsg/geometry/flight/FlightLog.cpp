#include "irsg/geometry/flight/FlightLog.h"

#include <cmath>

namespace irsg {

void FlightLog::keep(const FlightRecord& record, FlightTreatment treatment) {
    if (treatment != FlightTreatment::drop)
        file_.steps.push_back({record.offset, record.fileLength, treatment, 0, 0, {}});
}

bool FlightLog::atLeast(const FlightRecord& record, std::size_t size) {
    if (record.size() >= size)
        return true;
    report(record.offset,
           "a " + flightRecordName(record.opcode) + " record of " + std::to_string(record.size()) +
               " bytes",
           "at least " + std::to_string(size));
    return false;
}

void FlightLog::coordinate(const FlightRecord& record, std::size_t at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = record.f64(at + 8 * axis);
        file_.least[axis] = std::min(file_.least[axis], value);
        file_.most[axis] = std::max(file_.most[axis], value);
        if (!(std::abs(value) * file_.unit_m <= 1e9))
            report(record.offset + at + 8 * axis, "coordinate " + std::to_string(value),
                   "a finite number within 1e9 m");
    }
}

void FlightLog::finite(const FlightRecord& record, std::size_t at, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(record.f64(at + 8 * i)))
            return report(record.offset + at + 8 * i,
                          std::to_string(record.f64(at + 8 * i)) + " in a " +
                              flightRecordName(record.opcode) + " record",
                          "a finite number");
}

void FlightLog::report(std::size_t offset, const std::string& value, const std::string& expected) {
    diagnostics_.push_back(
        {file_.path.string(), "byte " + std::to_string(offset), value, expected});
}

void FlightLog::remarkOnce(const std::string& key, const std::string& text) {
    if (remarked_.insert(key).second)
        file_.remarks.push_back(text);
}

} // namespace irsg
