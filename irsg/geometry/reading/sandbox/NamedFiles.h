#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace irsg {

/// The files outside the folder of a model that the model, or a library of materials beside it,
/// names: pictures, materials, buffers and models that are there, behind `..` or by their whole
/// path, as text with either kind of slash. What stands packed in a file is not found. Throws
/// nothing: what cannot be read names nothing.
std::vector<std::filesystem::path> filesNamedOutside(const std::filesystem::path& place,
                                                     const std::filesystem::path& model);

/// The same of a text.
std::vector<std::filesystem::path> filesNamedIn(std::string_view text,
                                                const std::filesystem::path& folder);

} // namespace irsg
