#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <osg/Vec3d>

#include "irsg/geometry/reading/sandbox/GltfJson.h"

namespace irsg {

/// Buffers, views of them and accessors of a file of glTF, by their lengths: no byte of a buffer is
/// read.
class GltfBuffers {
  public:
    struct Accessor {
        std::size_t count = 0, components = 0, type = 0;
        std::optional<osg::Vec3d> least, most;
        bool stands = false; ///< its numbers lie in a buffer, none replaced by others
    };

    /// Throws InputError for a buffer that is missing, not opened (OpenableFiles.h) or shorter than
    /// it says, and for what reaches beyond it. `remarks` gets what accessors say in words of their
    /// own.
    GltfBuffers(const GltfJson& json, std::vector<std::string>& remarks);

    const std::vector<Accessor>& accessors() const { return accessors_; }
    /// Bytes of the buffers that no accessor and no image uses, but for padding.
    std::size_t unused_B() const;

  private:
    struct View {
        std::size_t length_B = 0, stride_B = 0, used_B = 0;
    };

    std::size_t sizeOfUri(const std::string& uri, const std::string& path) const;
    void readViews();
    void readAccessors(std::vector<std::string>& remarks);
    void useStretch(const nlohmann::json& object, const std::string& path, View& view,
                    std::size_t count, std::size_t size_B) const;

    const GltfJson& json_;
    std::vector<View> views_;
    std::vector<Accessor> accessors_;
};

/// Says which keys of an object are no words of the format: what another word would have said is
/// lost.
void remarkOtherWords(const nlohmann::json& object, const std::string& path,
                      std::initializer_list<std::string_view> known,
                      std::vector<std::string>& remarks);

} // namespace irsg
