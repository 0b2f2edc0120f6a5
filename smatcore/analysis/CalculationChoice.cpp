#include "smatcore/analysis/CalculationChoice.h"

#include <algorithm>

#include <fmt/format.h>

#include "irsg/scene/radiance/TermsAtHand.h"

namespace smat {

namespace {

constexpr std::size_t fewestWithTerms = 4; ///< cases that pay for reading them
constexpr std::size_t fewestToTrain = 400; ///< cases that pay for training them

} // namespace

CalculationChoice chooseCalculation(const SceneDescription& scene, std::size_t cases) {
    using irsg::CalculationMode;
    using irsg::TermsAtHand;
    // What the dearest band costs decides for all: a sweep's bands have one mode.
    TermsAtHand all = TermsAtHand::kept;
    for (const irsg::Band& band : scene.allBands()) {
        all = std::min(all, irsg::termsAtHand(scene.environment, band, scene.entities));
        if (all == TermsAtHand::unavailable) {
            return {};
        }
    }
    if (cases >= fewestToTrain && all == TermsAtHand::untrained) {
        return {CalculationMode::wideband,
                fmt::format("mode auto: wideband-ck, as {} cases pay for training its terms "
                            "(from {} on)",
                            cases, fewestToTrain)};
    }
    if (cases >= fewestWithTerms && all == TermsAtHand::kept) {
        return {CalculationMode::wideband,
                "mode auto: wideband-ck, as its terms are kept from before"};
    }
    const std::size_t needed = all == TermsAtHand::kept ? fewestWithTerms : fewestToTrain;
    return {CalculationMode::spectral,
            fmt::format("mode auto: spectral, as {} cases are fewer than the {} that {} "
                        "wideband terms pays for",
                        cases, needed, all == TermsAtHand::kept ? "reading" : "training")};
}

} // namespace smat
