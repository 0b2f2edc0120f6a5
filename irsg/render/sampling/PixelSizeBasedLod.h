#pragma once

#include <map>
#include <string>
#include <vector>

namespace irsg {

/// Chooses by its size in pixels how an object is drawn, and says so whenever it changes its mind
/// (report section 6, phase 3): up to a threshold from its texture, above it as it is.
class PixelSizeBasedLod {
  public:
    explicit PixelSizeBasedLod(double threshold_px) : threshold_px_(threshold_px) {}

    /// Whether an object of this size is drawn from its texture.
    bool usesTexture(int entity, double size_px);
    /// The switches since the last call, each in a sentence.
    std::vector<std::string> takeMessages();

  private:
    double threshold_px_;
    std::map<int, bool> present_; ///< by entity
    std::vector<std::string> messages_;
};

} // namespace irsg
