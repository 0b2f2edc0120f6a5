#include "irsg/render/opengl/ShaderSource.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "irsg/core/Errors.h"

namespace {

namespace fs = std::filesystem;

const char* const shaderName = "surface.frag.glsl";

std::string contentOf(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// A folder of shaders on disk that IRSG_SHADER_DIR names as long as the test runs.
class ShaderFolder {
  public:
    ShaderFolder()
        : folder_(fs::path(testing::TempDir()) / ("irsg-shaders-" + std::to_string(::getpid()))) {
        fs::create_directories(folder_);
        ::setenv("IRSG_SHADER_DIR", folder_.c_str(), 1);
    }
    ~ShaderFolder() {
        ::unsetenv("IRSG_SHADER_DIR");
        fs::remove_all(folder_);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
    }

  private:
    fs::path folder_;
};

} // namespace

TEST(ShaderSource, EmbedsEveryShaderOfTheTreeByteForByte) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(SMAT_SOURCE_DIR) / "shaders")) {
        if (entry.path().extension() == ".glsl") {
            EXPECT_EQ(irsg::shaderSource(entry.path().filename()), contentOf(entry.path()))
                << entry.path();
            ++files;
        }
    }
    EXPECT_EQ(files, static_cast<int>(irsg::embeddedShaders().size()));
    EXPECT_GT(files, 0);
}

TEST(ShaderSource, PrefersTheCopyOnDisk) {
    const ShaderFolder folder;
    folder.write(shaderName, "void main() {}\n");
    EXPECT_EQ(irsg::shaderSource(shaderName), "void main() {}\n");
}

TEST(ShaderSource, FallsBackToTheEmbeddedTextWhereTheFolderLacksTheFile) {
    const ShaderFolder folder;
    EXPECT_EQ(irsg::shaderSource(shaderName), irsg::embeddedShaders().at(shaderName));
}

TEST(ShaderSource, CallsAnUnknownNameOurOwnFault) {
    EXPECT_THROW(irsg::shaderSource("no-such-shader.glsl"), irsg::LogicError);
}
