#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/gas/PlumeField.h"
#include "irsg/gas/PlumeTable.h"
#include "irsg/signature/SignatureDatabase.h"

namespace smat {

/// How a plume becomes zones.
struct PlumeRequest {
    irsg::SpectralRange band; ///< of the bound
    double bound = 0.01;      ///< of the radiant intensity, relative
    std::size_t fewest = 1;   ///< zones to begin with
    std::size_t most = 16;    ///< zones that are tried
    int firstIndex = 1;       ///< temperature and material index of the outermost zone
    int sides = 32;           ///< of the surfaces of revolution
};

/// A plume as gas zones for scenes: its nozzle at the origin, downstream towards -y, the tail.
struct PlumeModel {
    std::size_t zones = 0;
    std::vector<irsg::PlumeZonesError> errors;
    irsg::SignatureDatabase database;
    std::string object; ///< Wavefront .obj, materials zone_INDEX
    std::string codes;  ///< the .codes.json beside it
    double largestError() const;
};

/// As many zones as the bound takes. Throws InputError where `most` zones do not reach it, with
/// the error that they leave, and for what plumeZones() refuses.
PlumeModel plumeModel(const irsg::PlumeTable& table, const PlumeRequest& request);
/// The same of a field in space, whose zones end at surfaces of equal temperature. Its first axis
/// goes downstream by so many degrees over the horizon, the second to starboard.
PlumeModel plumeModel(const irsg::PlumeField& field, const PlumeRequest& request,
                      double elevation_deg = 0.0);

/// Writes NAME.obj, NAME.codes.json and NAME.sigdb.
std::vector<std::filesystem::path> savePlume(const PlumeModel& plume,
                                             const std::filesystem::path& object);

} // namespace smat
