#pragma once

#include <vector>

#include "irsg/atmosphere/Environment.h"
#include "irsg/radiometry/Band.h"
#include "irsg/scene/Entity.h"

namespace irsg {

/// What the wideband mode would cost a scene in a band.
enum class TermsAtHand {
    unavailable, ///< no one air has wideband terms and answers all that a scene asks
    untrained,   ///< they take seconds
    kept         ///< a program before this one has trained them
};
/// Entities whose model is not loaded count as none.
TermsAtHand termsAtHand(const Environment& environment, const Band& band,
                        const std::vector<Entity>& entities);

} // namespace irsg
