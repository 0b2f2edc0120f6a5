#pragma once

#include <map>
#include <utility>
#include <vector>

namespace irsg {

/// A transparent material of an entity: (its number in the scene, the material's index).
using FrontMaterial = std::pair<int, int>;

/// Numbers for what can lie before a surface: sets of transparent materials, each as often as it
/// occurs, because the integral of a product of transmissivities does not factor. Their order does
/// not matter to what they let through. 0 is nothing. A number stays what it is while the object
/// lives.
class Fronts {
  public:
    /// The set with one more material.
    int behind(int front, const FrontMaterial& material);
    /// The number of a sorted set.
    int numberOf(const std::vector<FrontMaterial>& materials);
    /// The same where it has one already, else -1.
    int find(const std::vector<FrontMaterial>& materials) const;
    /// Sorted.
    const std::vector<FrontMaterial>& materials(int front) const {
        return sets_[static_cast<std::size_t>(front)];
    }
    std::size_t size() const { return sets_.size(); }

  private:
    std::vector<std::vector<FrontMaterial>> sets_{{}};
    std::map<std::vector<FrontMaterial>, int> numbers_{{{}, 0}};
    std::map<std::pair<int, FrontMaterial>, int> longer_;
};

} // namespace irsg
