#include "irsg/core/ProgramVersion.h"

namespace irsg {

std::string programVersion() {
    return SMAT_VERSION;
}

std::string programWithVersion() {
    return "smat " + programVersion();
}

} // namespace irsg
