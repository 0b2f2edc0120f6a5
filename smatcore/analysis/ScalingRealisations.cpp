#include "smatcore/analysis/ScalingRealisations.h"

#include "irsg/core/Errors.h"
#include "irsg/signature/random/Philox.h"

namespace smat {

namespace {

/// Sets the random sequences of companions apart from those of the draws.
constexpr std::uint32_t companionPurpose = 0x10;

} // namespace

const char* name(RealisationSequence sequence) {
    return sequence == RealisationSequence::plain ? "plain" : "sobol";
}

ScalingRealisations::ScalingRealisations(std::vector<SceneScaling> scalings,
                                         RealisationSequence sequence, std::uint64_t seed,
                                         bool companions)
    : scalings_(std::move(scalings)), sequence_(sequence), seed_(seed) {
    for (const SceneScaling& scaling : scalings_)
        dimensions_.push_back(scaling.isFixed() ? -1 : free_++);
    if (sequence == RealisationSequence::plain || free_ == 0)
        return;
    const int needed = companions ? 2 * free_ : free_;
    if (needed > irsg::SobolSequence::mostDimensions) {
        throw irsg::InputError({.file = "",
                                .position = "sequence",
                                .value = std::to_string(free_) + " scales that vary",
                                .expected = std::string("at most ") +
                                            (companions ? "64 with a ranking" : "128") +
                                            ", or the plain sequence"});
    }
    for (std::uint32_t replicate = 0; replicate < sobolReplicates; ++replicate)
        replicates_.emplace_back(needed, seed, replicate);
}

std::vector<double> ScalingRealisations::valuesOf(std::size_t draw, bool companion) const {
    std::vector<double> values;
    values.reserve(scalings_.size());
    for (std::size_t i = 0; i < scalings_.size(); ++i) {
        const SceneScaling& scaling = scalings_[i];
        double unit = 0.5;
        if (dimensions_[i] >= 0 && sequence_ == RealisationSequence::sobol) {
            unit = replicates_[replicateOf(draw)].at(
                static_cast<std::uint32_t>(draw / sobolReplicates),
                dimensions_[i] + (companion ? free_ : 0));
        } else if (dimensions_[i] >= 0) {
            const auto purpose =
                static_cast<std::uint32_t>(scaling.input.kind) + (companion ? companionPurpose : 0);
            unit = irsg::unitOf(
                seed_,
                {purpose, static_cast<std::uint32_t>(scaling.input.entity), scaling.input.index},
                draw);
        }
        values.push_back(scaling.distribution.at(unit));
    }
    return values;
}

} // namespace smat
