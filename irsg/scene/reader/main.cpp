#include <exception>

#include "irsg/scene/model/apart/ReaderService.h"

/// Reads models and pictures for another process, which asks through standard input (a socket).
int main() {
    try {
        irsg::serveReadings(0);
        return 0;
    } catch (const std::exception&) {
        return 3;
    }
}
