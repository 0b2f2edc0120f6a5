#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "irsg/radiance/exchange/LightExchange.h"

namespace irsg {

/// Spheres about the small bright parts of a scene, such as nozzles, to which samples of surfaces
/// with lobes send rays beside those of their facets. Facets alone seldom meet such a part, and a
/// sample whose facet does shows it as a speck.
class LobeAims {
  public:
    /// A set of spheres: a bit each.
    using Set = std::uint32_t;
    static constexpr std::size_t most = 32;
    struct Sphere {
        std::size_t body = 0; ///< of the exchange
        Vec3 centre_m;        ///< in the axes of its mesh
        double radius_m = 0.0;
    };

    LobeAims() = default;
    /// `bright`: by drawn row.
    LobeAims(const LightExchange& exchange, const std::vector<bool>& bright);

    const std::vector<Sphere>& spheres() const { return spheres_; }
    /// Those in which something bright is seen from anywhere near a place, as samples name it.
    Set seenFrom(const LightExchange& exchange, std::uint32_t cell) const;

  private:
    std::vector<Sphere> spheres_;
    std::vector<Set> seen_; // by receiver
};

} // namespace irsg
