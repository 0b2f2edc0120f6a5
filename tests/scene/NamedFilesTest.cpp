#include "irsg/geometry/reading/sandbox/NamedFiles.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/TemporaryFolder.h"

namespace irsg {
namespace {

namespace fs = std::filesystem;
using smat::test::TemporaryFolder;
using testing::ElementsAre;
using testing::IsEmpty;

class NamedFiles : public testing::Test {
  protected:
    NamedFiles() {
        fs::create_directories(folder_ / "models");
        fs::create_directories(folder_ / "textures");
        for (const char* name : {"textures/wood.png", "textures/two words.PNG", "secret.txt",
                                 "models/own.png", "key"}) {
            std::ofstream(folder_ / name) << name;
        }
    }
    std::vector<std::string> namedIn(const std::string& text) const {
        std::vector<std::string> names;
        for (const fs::path& file : filesNamedIn(text, folder_ / "models")) {
            names.push_back(file.lexically_normal().lexically_relative(folder_.path()).string());
        }
        return names;
    }
    TemporaryFolder folder_;
};

TEST_F(NamedFiles, AreFoundInTheFormsInWhichModelsNameThem) {
    for (const std::string& text :
         {std::string("map_Kd ../textures/wood.png\n"),
          std::string("\"uri\": \"../textures/wood.png\""),
          std::string("<init_from>..\\textures\\wood.png</init_from>"),
          std::string("\0\0../textures/wood.png\0\0", 24), std::string("../TEXTURES/Wood.PNG"),
          std::string("x../textures/wood.pngS\x08") + "more",
          "texture \"" + (folder_ / "textures/wood.png").string() + "\""}) {
        EXPECT_THAT(namedIn(text), ElementsAre("textures/wood.png")) << text;
    }
    EXPECT_THAT(namedIn("map_Kd ../textures/two words.PNG\n"),
                ElementsAre("textures/two words.PNG"));
}

TEST_F(NamedFiles, AreNoneThatBelongToNoModel) {
    for (const char* text : {"../secret.txt", "../key", "../textures", "../lost.png", "..", "../",
                             "f 1/1/1 2/2/2 3/3/3\n", "/etc/passwd", "own.png", ""}) {
        EXPECT_THAT(namedIn(text), IsEmpty()) << text;
    }
}

TEST_F(NamedFiles, OfALibraryOfMaterialsBesideTheModelCount) {
    std::ofstream(folder_ / "models/m.mtl") << "newmtl a\nmap_Kd ../textures/wood.png\n";
    std::ofstream(folder_ / "models/m.obj") << "mtllib m.mtl\n";
    const fs::path model = folder_ / "models/m.obj";
    EXPECT_EQ(filesNamedOutside(model, model).size(), 1u);
}

} // namespace
} // namespace irsg
