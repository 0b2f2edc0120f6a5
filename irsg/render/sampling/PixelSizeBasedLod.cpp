#include "irsg/render/sampling/PixelSizeBasedLod.h"

#include <utility>

#include "irsg/core/Errors.h"

namespace irsg {

bool PixelSizeBasedLod::usesTexture(int entity, double size_px) {
    const bool uses = size_px <= threshold_px_;
    const auto [place, isNew] = present_.try_emplace(entity, uses);
    if (!isNew && place->second != uses) {
        place->second = uses;
        messages_.push_back("object " + std::to_string(entity + 1) + " is " + numberText(size_px) +
                            " pixels wide and is drawn " +
                            (uses ? "from its texture" : "without antialiasing") +
                            " from now on: the threshold is " + numberText(threshold_px_));
    }
    return uses;
}

std::vector<std::string> PixelSizeBasedLod::takeMessages() {
    return std::exchange(messages_, {});
}

} // namespace irsg
