#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "irsg/core/JsonText.h"

namespace irsg {

/// The JSON of a file of glTF 2.0, asked for its values by key. What is not of the form that is
/// asked for is an InputError with the file, the key path, the value and what was expected.
class GltfJson {
  public:
    /// The text of `place`, of a .glb that of its first chunk, whose other chunks must be whole.
    /// Messages name `file`, which must outlive this.
    GltfJson(const std::filesystem::path& place, const std::filesystem::path& file);

    const nlohmann::json& root() const { return root_; }
    const std::filesystem::path& file() const { return file_; }
    /// Length of the binary chunk of a .glb, bytes.
    std::optional<std::size_t> chunk_B() const { return chunk_B_; }

    [[noreturn]] void refuse(const std::string& path, std::string value,
                             std::string expected) const;

    /// A list of the outermost object; an empty one where it is missing.
    const nlohmann::json& list(const char* key) const;
    /// Calls each(object, path) with every object of a list.
    template <typename Each>
    void forEach(const nlohmann::json& values, const std::string& path, const Each& each) const {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::string at = joinedKeyPath(path, std::to_string(i));
            if (!values[i].is_object())
                refuse(at, shownJson(values[i]), "an object");
            each(values[i], at);
        }
    }

    /// Null where there is none.
    static const nlohmann::json* find(const nlohmann::json& object, const char* key);
    /// A whole number from 0 on, or nothing.
    std::optional<std::size_t> number(const nlohmann::json& object, const std::string& path,
                                      const char* key) const;
    std::size_t needed(const nlohmann::json& object, const std::string& path,
                       const char* key) const;
    /// A whole number below `end`, or nothing.
    std::optional<std::size_t> index(const nlohmann::json& object, const std::string& path,
                                     const char* key, std::size_t end) const;
    /// Whole numbers below `end`; none where the key is missing.
    std::vector<std::size_t> indices(const nlohmann::json& object, const std::string& path,
                                     const char* key, std::size_t end) const;
    std::string text(const nlohmann::json& object, const std::string& path, const char* key) const;
    /// So many numbers; false where the key is missing.
    bool numbers(const nlohmann::json& object, const std::string& path, const char* key,
                 double* into, std::size_t count) const;

  private:
    std::string textOfBinary(const std::string& bytes);

    const std::filesystem::path& file_;
    nlohmann::json root_;
    std::optional<std::size_t> chunk_B_;
};

} // namespace irsg
