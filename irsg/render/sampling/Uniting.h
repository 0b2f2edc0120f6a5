#pragma once

#include <cstddef>
#include <vector>

namespace irsg {

/// Unites pairs of things for which `together` holds until there is none; what has grown is held
/// against all others again, so that the result does not depend on their order.
template <typename Thing, typename Together, typename Unite>
void uniteAll(std::vector<Thing>& things, Together together, Unite unite) {
    for (std::size_t a = 0; a < things.size();) {
        bool grew = false;
        for (std::size_t b = a + 1; b < things.size();) {
            if (!together(things[a], things[b])) {
                ++b;
                continue;
            }
            things[a] = unite(things[a], things[b]);
            things.erase(things.begin() + static_cast<std::ptrdiff_t>(b));
            grew = true;
        }
        a = grew ? 0 : a + 1;
    }
}

} // namespace irsg
