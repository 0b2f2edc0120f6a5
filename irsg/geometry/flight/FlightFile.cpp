#include "irsg/geometry/flight/FlightFile.h"

#include <osg/Vec3d>

#include "irsg/geometry/flight/FlightOrigin.h"
#include "irsg/geometry/flight/FlightRecords.h"
#include "irsg/geometry/reading/FarOrigin.h"

namespace irsg {

std::string FlightFile::stream(Purpose purpose) const {
    const bool infrared = purpose == Purpose::infrared;
    std::string out;
    out.reserve(bytes.size());
    for (const auto& step : steps) {
        if (step.treatment == FlightTreatment::appearance && infrared)
            continue;
        if (step.treatment == FlightTreatment::asGroup) {
            // A group record of 44 bytes: opcode 2, the node's own ID, everything else zero.
            std::string record(44, '\0');
            record[1] = static_cast<char>(flight::group);
            record[3] = static_cast<char>(record.size());
            if (step.length >= 12)
                record.replace(4, 7, bytes, step.offset + 4, 7);
            out += record;
            continue;
        }
        if (!step.replacement.empty()) {
            out += step.replacement;
            continue;
        }
        out.append(bytes, step.offset, step.length);
        if (infrared && step.lightModeOffset != 0)
            out[out.size() - step.length + (step.lightModeOffset - step.offset)] =
                static_cast<char>(step.lightMode);
    }
    if (const auto from = origin(); from != std::array<double, 3>{})
        takeOriginFrom(out, from);
    return out;
}

std::array<double, 3> FlightFile::origin() const {
    const auto vec = [](const std::array<double, 3>& v) { return osg::Vec3d(v[0], v[1], v[2]); };
    const auto origin = farOriginOf({vec(least), vec(most)}).value_or(osg::Vec3d());
    return {origin.x(), origin.y(), origin.z()};
}

} // namespace irsg
