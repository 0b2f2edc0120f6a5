#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "irsg/gas/RoundJet.h"
#include "tools/samples/ModelWriter.h"

namespace smat {

/// The exhaust of an engine as zones of gas, the outermost first.
std::vector<irsg::PlumeZone> gasPlume(const irsg::RoundJet& jet, std::size_t zones);

/// A place by its distance behind the nozzle, its distance from the axis and the angle about it.
using PlumePlace = std::function<irsg::Vec3(double x_m, double r_m, double angle)>;

/// Writes the walls of zones as closed surfaces whose fronts are outside, where x grows, and x, r
/// and the angle are right-handed, as addPatch() has it; temperature and material indices go on
/// from the first.
void addGasPlume(ModelWriter& writer, const std::vector<irsg::PlumeZone>& zones,
                 const irsg::IrCodes& first, const Look& look, const PlumePlace& place);

/// Writes what the entries of a database have to be: one zone in each row.
void writePlumeZones(const std::vector<irsg::PlumeZone>& zones, const irsg::IrCodes& first,
                     const std::filesystem::path& file);

} // namespace smat
