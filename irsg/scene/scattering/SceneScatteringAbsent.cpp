#include "irsg/scene/scattering/SceneScattering.h"

// Where SMAT_BUILD_SCATTERING is off: whoever asks for scattering is told what is missing.

namespace irsg {

struct SceneScattering::Impl {};

bool hasScattering() {
    return false;
}

std::string whyNoScattering() {
    return "this build has no irsg/scattering (it was configured with SMAT_BUILD_SCATTERING=OFF)";
}

MtfSummary describeMtf(const std::filesystem::path& database) {
    throw InputError({database.string(), "scattering", whyNoScattering(),
                      "a build with FFTW, SMAT_BUILD_SCATTERING=ON"});
}

SceneScattering::SceneScattering() = default;
SceneScattering::~SceneScattering() = default;

void SceneScattering::check(const std::filesystem::path& database) {
    describeMtf(database);
}

int SceneScattering::support_px(const std::filesystem::path& database, const Sensor&) {
    check(database);
    return 0;
}

std::vector<ScatteredLight> SceneScattering::addHaze(const std::filesystem::path& database,
                                                     const Sensor&, const FrameBackground&,
                                                     const std::vector<ScatteredObject>&,
                                                     RadianceImage&, std::vector<std::string>&) {
    check(database);
    return {};
}

std::vector<HazeGain> SceneScattering::gains(const std::filesystem::path& database, const Sensor&,
                                             const FrameBackground&,
                                             const std::vector<ScatteredObject>&,
                                             const std::vector<double>&) {
    check(database);
    return {};
}

} // namespace irsg
