#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/conversion/TextureImage.h"
#include "irsg/render/background/FieldRays.h"
#include "irsg/render/values/TextureScale.h"

namespace irsg {

/// Six square pictures around the eye, at infinity (F30): north is +y, east +x. Each side is as
/// seen from the middle of the cube with the zenith above; `up` has north at its lower edge, `down`
/// at its upper edge, east at the right of both.
///
/// Between texels values are linear, also over edges and corners of the cube; where texels are
/// smaller than pixels they are averaged first (a pyramid of means, linear between its levels).
class Skybox {
  public:
    static constexpr std::array<const char*, 6> faceNames{"north", "south", "east",
                                                          "west",  "up",    "down"};

    /// In the order of `faceNames`. Throws InputError, naming each face that offends by `names`
    /// (files, or the face names where empty): not square, another size than the first, empty.
    explicit Skybox(std::array<TextureImage, 6> faces,
                    const std::array<std::string, 6>& names = {});
    /// A folder with one picture a face, whose names without extension are those of `faceNames` or
    /// their first letters, in any case. Throws InputError naming every face that is missing, there
    /// twice or unreadable.
    static std::shared_ptr<const Skybox> load(const std::filesystem::path& folder);
    static std::array<std::filesystem::path, 6> filesIn(const std::filesystem::path& folder);
    static std::shared_ptr<const Skybox> load(const std::array<std::filesystem::path, 6>& files);

    int faceSize() const { return levels_.front().size; }
    /// Texel value along a direction of any length, of the pictures as they are.
    double at(const Vec3& direction) const;
    /// Radiance of every pixel, top row first.
    std::vector<double> pixels(const FieldRays& rays, const TextureScale& scale) const;

    /// The angle that the brightest texels span where they are a lone spot smaller than one degree,
    /// as a sun would be: nothing else in the sky is brighter than half way between the median and
    /// the maximum.
    std::optional<double> brightSpot_rad() const { return brightSpot_rad_; }

  private:
    /// One level of the pyramid: six faces with a border of one texel from their neighbours.
    struct Level {
        int size = 0;
        std::vector<float> texels;

        std::size_t stride() const { return static_cast<std::size_t>(size) + 2; }
        std::size_t index(std::size_t face, int x, int y) const {
            return (face * stride() + static_cast<std::size_t>(y + 1)) * stride() +
                   static_cast<std::size_t>(x + 1);
        }
        void fillBorders();
        double at(std::size_t face, double right, double down) const;
    };
    Level halved(const Level& finer) const;
    std::optional<double> findBrightSpot() const;

    std::vector<Level> levels_; ///< finest first
    std::optional<double> brightSpot_rad_;
};

} // namespace irsg
