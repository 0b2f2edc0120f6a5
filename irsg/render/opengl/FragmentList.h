#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "irsg/render/opengl/GlFunctions.h"

namespace irsg {

/// The GPU's list of fragments of transparent surfaces: every fragment in front of the opaque
/// surfaces is appended, in whatever order it is drawn; who reads the list sorts it. One drawing
/// finds all layers of all samples. Lives and dies on the context's thread.
class FragmentList {
  public:
    FragmentList() = default;
    ~FragmentList();
    FragmentList(const FragmentList&) = delete;
    FragmentList& operator=(const FragmentList&) = delete;

    /// Memory of its entries.
    std::size_t bytes() const { return static_cast<std::size_t>(bytes_); }
    /// Empties the list and binds it for appending; room for `entries` of `vectorsPerEntry` uvec4.
    void begin(std::uint32_t entries, int vectorsPerEntry);
    /// How many fragments were appended, also those that found no room.
    std::uint32_t count() const;
    /// Shows the first `entries`, each 4 `vectorsPerEntry` words, where they lie.
    void read(std::uint32_t entries, int vectorsPerEntry,
              const std::function<void(std::span<const float>)>& take) const;

  private:
    GLuint counter_ = 0;
    GLuint fragments_ = 0;
    GLsizeiptr bytes_ = 0;
};

} // namespace irsg
