#include "irsg/render/opengl/ShaderSource.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "irsg/core/Errors.h"

namespace irsg {

std::string shaderSource(const std::string& name) {
    // A copy on disk wins.
    if (const char* folder = std::getenv("IRSG_SHADER_DIR")) {
        std::ifstream file(std::filesystem::path(folder) / name, std::ios::binary);
        if (file)
            return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }

    const auto embedded = embeddedShaders().find(name);
    if (embedded == embeddedShaders().end())
        throw LogicError("no shader is named " + name);
    return embedded->second;
}

} // namespace irsg
