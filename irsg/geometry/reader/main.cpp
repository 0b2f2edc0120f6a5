#include <exception>
#include <filesystem>
#include <string>

#include "irsg/geometry/flight/FlightScanner.h"
#if SMAT_HAS_ASSIMP
#include "irsg/geometry/reading/assimp/AssimpReading.h"
#endif
#include "irsg/geometry/reading/sandbox/FlightReading.h"
#include "irsg/geometry/reading/sandbox/FlightStreams.h"
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/sandbox/ReaderService.h"

namespace {

std::string scannedStreams(const std::filesystem::path& file, bool withPictures) {
    using Purpose = irsg::FlightFile::Purpose;
    irsg::ByteSink streams;
    irsg::putFlightStreams(streams, irsg::scanFlight(file).streams(
                                        withPictures ? Purpose::visible : Purpose::infrared));
    return streams.take();
}

} // namespace

/// Reads models and pictures for another process, which asks through standard input (a socket).
int main() {
    try {
#if SMAT_HAS_ASSIMP
        irsg::setAssimpReading(irsg::readWithAssimp);
#endif
        irsg::setFlightScanning(scannedStreams);
        irsg::serveReadings(0);
        return 0;
    } catch (const std::exception&) {
        return 3;
    }
}
