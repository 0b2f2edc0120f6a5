#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "irsg/image/ExrFile.h"
#include "irsg/signature/ScalingXml.h"
#include "tests/cli/Program.h"
#include "tests/support/TemporaryFolder.h"

namespace smat::test {

using Words = std::vector<std::string>;

/// A scene of black boxes and grey spheres with these sensors, without air.
inline std::string scenarioOf(const std::string& entities, const std::string& sensors,
                              const std::string& more = R"("dt_s": 1, "end_s": 4)") {
    return R"({"version": 1, "render": {"sun": "off", "fluxes": "off", "background": "none", "bounces": 0},
 "sensor": {"width": 48, "height": 32, "fov": 4},
 "entities": [)" +
           entities + "],\n \"sensors\": [" + sensors + "],\n " + more + "}";
}

inline std::string entity(const std::string& name, const std::string& kind,
                          const std::string& place) {
    const std::string base = sample(kind + "/" + kind).string();
    return R"({"name": ")" + name + R"(", "model": ")" + base + R"(.flt", "database": ")" + base +
           R"(.sigdb", )" + place + "}";
}

/// Copies the sample box into a folder, with a scale of its emissivity.
inline void copyScaledBox(const std::filesystem::path& folder) {
    for (const char* name : {"box.flt", "box.sigdb"}) {
        std::filesystem::copy(sample("box") / name, folder / name);
    }
    const irsg::Distribution scale(irsg::DistributionKind::uniform, 0.9, 1.0);
    write(irsg::scalingFile(folder / "box.flt", irsg::ScalingKind::emissivity),
          irsg::scalingXml({{1, {scale, ""}}}));
}
/// That of a copy.
inline const char* const ownBox =
    R"({"name": "box", "model": "box.flt", "database": "box.sigdb", "position_m": [0, 5000, 100]})";

inline const char* const south = R"({"name": "south", "position_m": [0, 0, 100]})";

inline Ran simulated(const TemporaryFolder& folder, const Words& more = {}) {
    Words words = {"simulate", "s.json", "--out", "out"};
    words.insert(words.end(), more.begin(), more.end());
    return smatBatch(words, folder.path());
}

inline std::vector<float> pixels(const std::filesystem::path& file) {
    return irsg::readExr(file).primary().values;
}

} // namespace smat::test
