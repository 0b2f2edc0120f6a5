#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "irsg/radiance/exchange/LightPairs.h"

namespace irsg {

/// What is known of a receiver beside its pairs.
struct ReceiverRays {
    double area_m2 = 0.0;
    double rays = 0.0; ///< that began on it; 0 where it sent none
};

/// Who gets what of whom.
struct LightBalance {
    std::shared_ptr<const LightPairs> pairs;   ///< of receivers
    std::shared_ptr<const LightPairs> between; ///< of senders, whose surfaces receive
};

/// The pairs of receivers after each has learnt what the others' rays found. Light goes either way
/// (A_i F_ij = A_j F_ji), so that rays from both ends of a pair count for both: a small hot nozzle
/// is seldom met by the rays of a wing, and well by its own of the wing.
///
/// Where hits are rare their number is Poisson's, and the best that is to be had of A F is all hits
/// of both ends over all rays per area of both. Scales of both ends then bring the sum over the
/// senders of a receiver to what its own rays say, as far as these are the more certain: in a
/// closed room every ray hits something, and the sum stays 1 to the last digit; a wing whose few
/// rays tell little of a small nozzle follows the nozzle. Pairs stay reciprocal (van Leersum, Int.
/// J. Heat and Fluid Flow 10, 83, 1989, has the same aim).
///
/// `oneWay`: what is seen through the backs of facets that have none, from the inside of a body,
/// from where the receiver is not seen; it stays as it is.
LightPairs balanced(const LightPairs& pairs, const LightPairs& oneWay,
                    const std::vector<ReceiverRays>& receivers);

/// The same where some receivers send as one: `senderOf` each, of so many senders, whose numbers
/// pairs have. Senders are balanced, and what that changes between two of them it changes for each
/// receiver of the first alike; each sum follows what the receiver's own rays say as above.
LightBalance balancedOfSenders(const LightPairs& pairs, const LightPairs& oneWay,
                               const std::vector<ReceiverRays>& receivers,
                               std::span<const std::uint32_t> senderOf, std::size_t senders);

} // namespace irsg
