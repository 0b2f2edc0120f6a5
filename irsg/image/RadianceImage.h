#pragma once

#include <map>
#include <string>
#include <vector>

namespace irsg {

/// One named plane of an image.
struct ImageChannel {
    std::string name;          ///< "L", "alpha", "temperature_index", ...
    std::string unit;          ///< "W m-2 sr-1"
    std::vector<float> values; ///< width x height, top row first

    bool operator==(const ImageChannel&) const = default;
};

/// A picture in physical units that knows what it holds: channels by name, and attributes for band,
/// geometry, settings, versions and renderer. Row 0 is the top row. The first channel is the one
/// that is shown: "L", radiance in W m-2 sr-1, in an image that IRSG rendered.
class RadianceImage {
  public:
    RadianceImage() = default;
    /// `width` and `height` at least 1 (LogicError), values 0.
    RadianceImage(int width, int height, const std::string& firstChannel = "L",
                  const std::string& unit = "W m-2 sr-1");

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return width_ == 0; }
    std::size_t pixelCount() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    }
    std::size_t offset(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    std::vector<ImageChannel> channels;
    std::map<std::string, std::string> attributes;

    /// Adds a plane of zeros, or returns the one of that name.
    ImageChannel& channel(const std::string& name, const std::string& unit = "");
    const ImageChannel* find(const std::string& name) const;
    /// The shown plane; LogicError in an empty image.
    ImageChannel& primary();
    const ImageChannel& primary() const;
    float at(int x, int y) const { return primary().values[offset(x, y)]; }

    bool operator==(const RadianceImage&) const = default;

  private:
    int width_ = 0;
    int height_ = 0;
};

/// Throws LogicError for what no file can hold: an empty image, a plane whose size is not the
/// image's, a name that is empty, repeated, longer than 200 bytes or holds a NUL.
void checkPlanes(const RadianceImage& image);

} // namespace irsg
