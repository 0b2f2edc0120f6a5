#include "tools/samples/SampleHeron.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tools/samples/HeronParts.h"

namespace smat {

FlightWriter heronModel() {
    FlightWriter writer("heron");
    heron::addFuselage(writer);
    heron::addWings(writer);
    for (const double side : {1.0, -1.0})
        heron::addEngine(writer, side);
    return writer;
}

irsg::RoundJet heronJet() {
    irsg::RoundJet jet;
    jet.diameter_m = 0.37;
    jet.temperature_K = 790.0;
    jet.velocity_m_s = 180.0;
    jet.fuelAirRatio = 0.0185;
    jet.air_K = 286.0;
    jet.coflow_m_s = 102.0;
    jet.endsAt = 0.15;
    return jet;
}

} // namespace smat
