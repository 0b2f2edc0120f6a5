#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/core/Errors.h"
#include "irsg/geometry/view/FrameBackground.h"
#include "irsg/geometry/view/Sensor.h"
#include "irsg/image/RadianceImage.h"

namespace irsg {

/// True where scattering can be computed: this build has the floor irsg/scattering, and the library
/// of its Fourier transforms (libirsg_fftw, Debian package irsg-scattering) is installed.
bool hasScattering();
/// Why it cannot, for example "this build has no irsg/scattering (...)"; empty where it can.
std::string whyNoScattering();

/// What an MTF database holds.
struct MtfSummary {
    struct Field {
        std::string name;
        std::optional<double> value; ///< nothing where the file does not know it
        std::string unit;
    };
    struct Curve {
        double opticalDepth, gain, direct; ///< MTF(0), and MTF at the highest frequency
    };
    std::vector<Field> fields; ///< header and axes
    std::vector<Curve> curves;
    std::vector<std::string> remarks; ///< what looks odd
    /// All of it for a reader, remarks last as "note: ...".
    std::vector<std::string> lines;
};
/// Throws InputError for a file that is no MTF database, and where this build has no
/// irsg/scattering.
MtfSummary describeMtf(const std::filesystem::path& database);

/// What a frame shows of one object, and how its light is spread.
struct ScatteredObject {
    struct Pixel {
        int x, y;
        double radiance_W_m2_sr, opacity; ///< premultiplied, through the air
        double cosineShare = 1.0;         ///< cosine off the axis over that of the pixel's centre
    };
    std::string name;
    double opticalDepth = 0.0; ///< scattering, in the band
    std::vector<Pixel> pixels; ///< each at most once
};

/// What became of the light of an object that the frame shows.
struct ScatteredLight {
    std::string name;
    double opticalDepth = 0.0;
    double gain = 1.0;       ///< MTF(0), of the whole light over the direct light
    double cut = 0.0;        ///< part of the gain beyond the taper
    double support_px = 0.0; ///< where the taper ends
};

/// What the sums over an object become by its haze, as far as it falls into the frame. With S what
/// it sends and B what it hides of the background, both W sr-1 and direct:
///   intensity = g S, contrast = g S - b B, irradiance += s S - t B.
struct HazeGain {
    double intensity = 1.0, hidden = 1.0;                          ///< g and b
    double irradiance_per_m2 = 0.0, hiddenIrradiance_per_m2 = 0.0; ///< s and t
};

/// Haze around objects in finished pictures. With A the light of an object as it arrives (that of
/// the path before it included), c its coverage, F the filter of its MTF and L the background:
///   picture = L + F{A - c L0} - (L - L0) F{c},
/// L0 the background at the field's centre. That is F{A} + (1 - F{c}) L, but differences are taken
/// before they are filtered, so that what shines like its background stays invisible. Neither F{c}
/// nor a pixel is clamped. Keeps databases and filters between calls. Every call throws InputError
/// where there is no scattering.
class SceneScattering {
  public:
    SceneScattering();
    ~SceneScattering();
    SceneScattering(const SceneScattering&) = delete;
    SceneScattering& operator=(const SceneScattering&) = delete;

    /// Throws InputError for a file that is no MTF database.
    void check(const std::filesystem::path& database);
    /// How far haze reaches in a picture of this sensor, in pixels: to the end of the taper at half
    /// the database's field of view, or to where no pixel of the frame is farther away.
    int support_px(const std::filesystem::path& database, const Sensor& sensor);
    /// Adds F - 1 of every object to the primary plane of a picture that is composed without haze.
    /// Haze of more than the database's field of view is cut by a taper, and so is what would be
    /// farther away than any pixel of the frame. Warnings are added, each once. Throws InputError
    /// for an optical depth that the database does not reach.
    std::vector<ScatteredLight> addHaze(const std::filesystem::path& database, const Sensor& sensor,
                                        const FrameBackground& background,
                                        const std::vector<ScatteredObject>& objects,
                                        RadianceImage& image, std::vector<std::string>& warnings);
    /// What that adds to the sums over the frame, in closed form: filter and sum change places, so
    /// that the solid angles of the pixels are filtered in place of what the pixels show. By
    /// object, at distances of `ranges_m`. Throws as addHaze does.
    std::vector<HazeGain> gains(const std::filesystem::path& database, const Sensor& sensor,
                                const FrameBackground& background,
                                const std::vector<ScatteredObject>& objects,
                                const std::vector<double>& ranges_m);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace irsg
