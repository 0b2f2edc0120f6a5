#include "irsg/signature/EntryPath.h"

namespace irsg {

std::string temperaturePath(int index) {
    return "temperatures." + std::to_string(index);
}

std::string materialPath(int index) {
    return "materials." + std::to_string(index);
}

std::string spectrumPath(const std::string& name) {
    return "spectra." + name;
}

} // namespace irsg
