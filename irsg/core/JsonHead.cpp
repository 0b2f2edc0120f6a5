#include "irsg/core/JsonHead.h"

namespace irsg {

void readJsonHead(const JsonReader& root, const std::string& format, int version) {
    root.at("format").word({format});
    root.at("program");
    const JsonReader found = root.at("version");
    if (found.number() != version)
        found.refuse(std::to_string(version));
    root.throwRefused();
}

} // namespace irsg
