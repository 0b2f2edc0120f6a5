#pragma once

#include "irsg/gas/RoundJet.h"
#include "tools/samples/FlightWriter.h"

namespace smat {

/// A jet of two engines, 15 m long and 10 m of span, at full power without or with reheat: smooth
/// body with canopy, intakes with ducts, wing with strakes, two fins, nozzles with an inside, and
/// the gas of both engines in zones. Codes as in samples/tern/README.md. Nose +y, starboard +x.
FlightWriter ternModel(bool isReheat);

/// The exhaust of one of its engines.
irsg::RoundJet ternJet(bool isReheat);
/// So many zones stand for it, as `smat-batch plume --jet` finds for a bound of 0.024 without
/// reheat and 0.018 with it.
constexpr std::size_t ternZones(bool isReheat) {
    return isReheat ? 11 : 12;
}

} // namespace smat
