#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "irsg/radiance/OccluderStacks.h"
#include "irsg/radiance/exchange/LightBalance.h"

namespace irsg {

/// Light from outside that a receiver gets: as parts of its hemisphere, weighted by the cosine,
/// above and below the horizon, and as a factor of the sun.
struct OutsideLight {
    double sky = 0.0, ground = 0.0, sun = 0.0;
};

/// The ground stands for a material: what it reflects passes it.
inline constexpr OccluderMaterial groundMaterial{-1, -1};

/// What surfaces send each other through a set of transparent materials. Of all of it the product
/// of their transmissivities arrives, wavelength by wavelength.
struct LightThrough {
    std::vector<std::size_t> panes; ///< numbers of the materials, each as often as it is passed
    LightBalance balance;           ///< of receivers and senders behind them
    /// By receiver: what it sees of sky and ground through them. Of what the ground reflects, what
    /// shadows take of it: less than 0.
    std::vector<OutsideLight> leaving;
    std::vector<double> sky, ground; ///< by sender, likewise
    std::vector<double> sun;         ///< by sender: factor of the sun
    std::vector<float> sunOnCells;   ///< likewise, by cell; none: it reaches none through them
};

/// What the rays of a patch find behind transparent surfaces, by their materials, sorted.
struct FoundThrough {
    struct Behind {
        std::vector<LightPart> parts, oneWay;
        std::vector<LightPart> sun;        ///< of receivers and drawn rows, beside means
        std::vector<OutsideLight> leaving; ///< by node near the patch
    };
    std::map<std::vector<OccluderMaterial>, Behind> bySet;
};

/// Makes energy close behind transparent surfaces: what goes on through a set of materials is what
/// reached the last of them. Rays of both ends of pairs tell how much that is, so that the sums
/// differ by their scatter. The difference is sky and ground where rays leave, else what is met is
/// scaled. What the ground reflects stays as its rays have it.
class PaneClosure {
  public:
    /// `paneOf`: by sender, the number of its material in `materials`; -1 of what is opaque.
    PaneClosure(const OccluderStacks& passages, const std::vector<OccluderMaterial>& materials,
                std::span<const int> paneOf);

    /// Of receivers: `base` are the pairs through nothing. Changes `leaving` and the pairs behind
    /// materials; `isUp`: by receiver, the part of its hemisphere above the horizon.
    void closeReceivers(const LightPairs& base, std::span<const double> isUp,
                        std::vector<LightThrough>& through) const;
    /// Of senders, whose `sky` and `ground` are those that leave; changes the pairs alone.
    void closeSenders(const LightPairs& base, std::vector<LightThrough>& through) const;

  private:
    /// What reaches the last material of each passage, as parts of the hemisphere.
    void addReaching(std::size_t passage, const LightPairs& pairs, std::size_t receiver,
                     double scale, std::vector<double>& reaching) const;

    std::span<const int> paneOf_;
    std::size_t passages_;
    std::vector<bool> isOfGround_;       // by passage: rays of one end alone tell of it
    std::vector<std::size_t> order_;     // of passages: fewer materials first
    std::vector<std::vector<int>> next_; // by passage and material; -1: none
};

} // namespace irsg
