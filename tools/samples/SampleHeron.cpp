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

} // namespace smat
