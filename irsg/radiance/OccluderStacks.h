#pragma once

#include <map>
#include <utility>
#include <vector>

namespace irsg {

/// A transparent material of an entity: (its number in the scene, the material's index).
using OccluderMaterial = std::pair<int, int>;

/// A component of a directional surface that lobes of others reflect stands for a material of its
/// entity, too: what it reflects passes it. By the drawn row of the component (SurfaceRows).
inline int mirrorMaterial(int lobe) {
    return -2 - lobe;
}
/// That row; -1 for a material that is none of these.
inline int mirrorLobe(int material) {
    constexpr int lowest = -(1 << 30);
    return material <= -2 && material >= lowest ? -2 - material : -1;
}

/// Numbers for what can lie before a surface: sets of transparent materials, each as often as it
/// occurs, because the integral of a product of transmissivities does not factor. Their order does
/// not matter to what they let through. 0 is nothing. A number stays what it is while the object
/// lives.
class OccluderStacks {
  public:
    /// The set with one more material.
    int behind(int stack, const OccluderMaterial& material);
    /// The number of a sorted set.
    int numberOf(const std::vector<OccluderMaterial>& materials);
    /// The same where it has one already, else -1.
    int find(const std::vector<OccluderMaterial>& materials) const;
    /// Sorted.
    const std::vector<OccluderMaterial>& materials(int stack) const {
        return sets_[static_cast<std::size_t>(stack)];
    }
    std::size_t size() const { return sets_.size(); }

  private:
    std::vector<std::vector<OccluderMaterial>> sets_{{}};
    std::map<std::vector<OccluderMaterial>, int> numbers_{{{}, 0}};
    std::map<std::pair<int, OccluderMaterial>, int> longer_;
};

} // namespace irsg
