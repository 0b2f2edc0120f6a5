#include "benchmarks/exchange/ExchangeCases.h"

namespace irsg::bench {

std::vector<test::NamedCases> publicModelCases(const FileAspects& aspects) {
    const std::filesystem::path assimp = "/usr/share/assimp/models",
                                aircraft = "/usr/share/games/flightgear/AI/Aircraft";
    std::vector<test::NamedCases> cases;
    for (const std::filesystem::path& file :
         {assimp / "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
          assimp / "OBJ/spider.obj", assimp / "3DS/fels.3ds", assimp / "STL/sphereWithHole.stl",
          assimp / "STL/Wuson.stl", assimp / "Collada/duck.dae", assimp / "Collada/teapots.DAE",
          assimp / "FBX/huesitos.fbx", aircraft / "FK9MK2/Models/fk9mk2.ac",
          aircraft / "DH82/Models/DH82.ac", aircraft / "b1900d/Models/b1900d.ac",
          aircraft / "F-4/F-4_lowpoly.ac"})
        cases.push_back({file.filename().string(), [aspects, file] { return aspects.of(file); }});
    return cases;
}

} // namespace irsg::bench
