#include <exception>

#if SMAT_HAS_ASSIMP
#include "irsg/geometry/reading/assimp/AssimpReading.h"
#endif
#include "irsg/geometry/reading/sandbox/PluginReading.h"
#include "irsg/geometry/reading/sandbox/ReaderService.h"

/// Reads models and pictures for another process, which asks through standard input (a socket).
int main() {
    try {
#if SMAT_HAS_ASSIMP
        irsg::setAssimpReading(irsg::readWithAssimp);
#endif
        irsg::serveReadings(0);
        return 0;
    } catch (const std::exception&) {
        return 3;
    }
}
