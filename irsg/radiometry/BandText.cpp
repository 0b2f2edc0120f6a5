#include "irsg/core/CsvTable.h"
#include "irsg/radiometry/Band.h"

namespace irsg {

Band Band::fromText(const std::string& text) {
    // The dash between two numbers is the one that neither opens the text nor follows an exponent.
    for (std::size_t dash = text.find('-', 1); dash != std::string::npos;
         dash = text.find('-', dash + 1)) {
        const auto min_um = parseNumber(text.substr(0, dash));
        const auto max_um = parseNumber(text.substr(dash + 1));
        if (min_um && max_um && *min_um > 0.0 && *min_um < *max_um)
            return topHat(*min_um, *max_um);
    }
    throw InputError({"band", "", "'" + text + "'",
                      "MINIMUM-MAXIMUM in um with 0 < MINIMUM < MAXIMUM, such as 3-5"});
}

} // namespace irsg
