#include "tools/samples/SampleTern.h"

#include "tools/samples/TernParts.h"

namespace smat {

FlightWriter ternModel(bool isReheat) {
    FlightWriter writer("tern");
    const tern::Nozzle& nozzle = isReheat ? tern::reheat : tern::dry;
    const tern::HotParts hot = tern::hotParts(nozzle.firstHot);
    tern::addBody(writer, hot);
    tern::addWings(writer);
    for (const double side : {1.0, -1.0})
        tern::addNozzle(writer, nozzle, hot, side);
    tern::addPlumes(writer, nozzle, isReheat);
    return writer;
}

irsg::RoundJet ternJet(bool isReheat) {
    irsg::RoundJet jet;
    jet.diameter_m = 2.0 * (isReheat ? tern::reheat : tern::dry).exit_m;
    jet.temperature_K = isReheat ? 1570.0 : 690.0;
    jet.velocity_m_s = isReheat ? 1060.0 : 730.0;
    jet.fuelAirRatio = isReheat ? 0.05 : 0.0165;
    jet.air_K = 292.0;
    jet.coflow_m_s = 170.0;
    jet.airWater = 0.015;
    jet.endsAt = 0.1;
    return jet;
}

} // namespace smat
