#include "irsg/scene/scattering/SceneScattering.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <system_error>

#include "irsg/core/AppendUnique.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileStamp.h"
#include "irsg/core/RecentlyUsed.h"
#include "irsg/geometry/view/PixelGrid.h"
#include "irsg/radiometry/Units.h"
#include "irsg/scattering/FftPlans.h"
#include "irsg/scattering/MtfFilter.h"

namespace irsg {

namespace {

/// Filters that are kept, so that the objects of a scene can take turns.
constexpr std::size_t mostFilters = 16;
/// Half the field that haze is cut at where a database states none, rad.
constexpr double halfFieldUnstated_rad = 0.5;
/// The taper begins here, as a part of its end.
constexpr double taperBegin = 0.75;

/// The pixels of an object that are not 0, as planes of what is to be filtered.
struct Planes {
    HazeWindow window;
    std::vector<float> contrast, coverage;
};

Planes planesOf(const ScatteredObject& object, double centre_W_m2_sr) {
    int left = std::numeric_limits<int>::max(), top = left, right = -1, bottom = -1;
    for (const ScatteredObject::Pixel& pixel : object.pixels) {
        left = std::min(left, pixel.x);
        right = std::max(right, pixel.x);
        top = std::min(top, pixel.y);
        bottom = std::max(bottom, pixel.y);
    }
    Planes planes;
    if (right < 0)
        return planes;
    planes.window = {left, top, right - left + 1, bottom - top + 1};
    planes.contrast.assign(planes.window.size(), 0.0f);
    planes.coverage.assign(planes.window.size(), 0.0f);
    for (const ScatteredObject::Pixel& pixel : object.pixels) {
        const std::size_t i = static_cast<std::size_t>(pixel.y - top) *
                                  static_cast<std::size_t>(planes.window.width) +
                              static_cast<std::size_t>(pixel.x - left);
        planes.contrast[i] =
            static_cast<float>(pixel.radiance_W_m2_sr - pixel.opacity * centre_W_m2_sr);
        planes.coverage[i] = static_cast<float>(pixel.opacity);
    }
    return planes;
}

double halfFieldOf(const MtfDatabase& database) {
    const double stated_rad = database.header().fieldOfView_rad;
    return stated_rad > 0.0 ? 0.5 * stated_rad : halfFieldUnstated_rad;
}

int supportOf(const MtfDatabase& database, const Sensor& sensor) {
    const double farthest_px = std::hypot(sensor.width_px, sensor.height_px) / taperBegin;
    const double half_px = halfFieldOf(database) / sensor.pixelPitch();
    return std::max(1, static_cast<int>(std::ceil(std::min(half_px, farthest_px))));
}

/// What of a database does not fit a sensor.
std::vector<std::string> misfits(const std::filesystem::path& file, const MtfDatabase& database,
                                 const Sensor& sensor, double half_rad) {
    std::vector<std::string> sentences;
    const std::string name = file.filename().string();
    if (taperBegin * half_rad < 0.5 * sensor.horizontalFieldOfView_rad)
        sentences.push_back("scattering: the field of view of " + name + ", " +
                            numberText(std::round(10.0 * degrees(2.0 * half_rad)) / 10.0) +
                            " deg, is too small for that of the sensor: haze ends inside the "
                            "frame");
    const double wavelength_um = database.header().wavelength_um();
    const SpectralRange range = sensor.band.range();
    if (wavelength_um > 0.0 && (wavelength_um < range.min_um || wavelength_um > range.max_um))
        sentences.push_back("scattering: " + name + " is for " +
                            numberText(std::round(1000.0 * wavelength_um) / 1000.0) +
                            " um, outside the band " + numberText(range.min_um) + " to " +
                            numberText(range.max_um) + " um");
    return sentences;
}

/// Adds F - 1 of one object to sums over the frame.
void addObject(const ScatteredObject& object, double direct, const FrameBackground& background,
               MtfFilter& filter, const RadianceImage& frame, std::vector<double>& sums) {
    const Planes planes = planesOf(object, background.centre_W_m2_sr());
    if (planes.window.isEmpty())
        return;
    const HazeWindow to =
        planes.window.grown(filter.haze().support_px(), frame.width(), frame.height());
    std::vector<float> haze(to.size(), 0.0f);
    filter.addHaze(planes.window, planes.contrast, to, haze);
    std::vector<float> hidden(background.isUniform() ? 0 : to.size(), 0.0f);
    if (!hidden.empty())
        filter.addHaze(planes.window, planes.coverage, to, hidden);
    std::size_t i = 0;
    for (int y = to.y; y < to.y + to.height; ++y)
        for (int x = to.x; x < to.x + to.width; ++x, ++i) {
            const double over = background.at(x, y) - background.centre_W_m2_sr();
            sums[frame.offset(x, y)] +=
                static_cast<double>(haze[i]) -
                (hidden.empty() ? 0.0 : over * static_cast<double>(hidden[i]));
        }
    // What the database calls direct at its highest frequency may differ from 1.
    for (const ScatteredObject::Pixel& pixel : object.pixels)
        sums[frame.offset(pixel.x, pixel.y)] +=
            (direct - 1.0) *
            (pixel.radiance_W_m2_sr - pixel.opacity * background.behindAt(pixel.x, pixel.y));
}

/// The haze that pixels of an object send into a frame, each pixel's light times the weights of the
/// pixels that receive it: plain and with cosine, without and with the background there.
struct ReceivedHaze {
    HazeWindow window;
    std::vector<float> sent, sentCosine, hidden, hiddenCosine;
};

ReceivedHaze receivedHaze(const HazeWindow& window, const PixelGrid& grid, const Sensor& sensor,
                          const FrameBackground& background, MtfFilter& filter) {
    const HazeWindow frame{0, 0, sensor.width_px, sensor.height_px};
    const double middle_sr = grid.at(sensor.width_px / 2, sensor.height_px / 2).solidAngle_sr;
    const double level = std::max(background.centre_W_m2_sr(), 1e-30);
    ReceivedHaze received{window, {}, {}, {}, {}};
    std::vector<float> weights(frame.size());
    const auto filtered = [&](bool withCosine, bool withBackground) {
        std::size_t i = 0;
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x, ++i) {
                const PixelGrid::Pixel pixel = grid.at(x, y);
                weights[i] = static_cast<float>(
                    pixel.solidAngle_sr / middle_sr * (withCosine ? pixel.cosOffAxis : 1.0) *
                    (withBackground ? background.at(x, y) / level : 1.0));
            }
        std::vector<float> sums(window.size(), 0.0f);
        filter.addHaze(frame, weights, window, sums);
        const double unit = middle_sr * (withBackground ? level : 1.0);
        for (float& sum : sums)
            sum = static_cast<float>(unit * static_cast<double>(sum));
        return sums;
    };
    received.sent = filtered(false, false);
    received.sentCosine = filtered(true, false);
    received.hidden = filtered(false, true);
    received.hiddenCosine = filtered(true, true);
    return received;
}

HazeGain gainOf(const ScatteredObject& object, double direct, double range_m, const PixelGrid& grid,
                const FrameBackground& background, const ReceivedHaze& received) {
    double sent = 0.0, hidden = 0.0; // direct, W m-2
    HazeGain haze{0.0, 0.0, 0.0, 0.0};
    for (const ScatteredObject::Pixel& pixel : object.pixels) {
        const PixelGrid::Pixel at = grid.at(pixel.x, pixel.y);
        const std::size_t i = static_cast<std::size_t>(pixel.y - received.window.y) *
                                  static_cast<std::size_t>(received.window.width) +
                              static_cast<std::size_t>(pixel.x - received.window.x);
        const double behind_W_m2_sr = background.behindAt(pixel.x, pixel.y);
        const double more_sr = (direct - 1.0) * at.solidAngle_sr;
        const double projectedMore_sr = more_sr * at.cosOffAxis * pixel.cosineShare;
        sent += pixel.radiance_W_m2_sr * at.solidAngle_sr;
        hidden += pixel.opacity * behind_W_m2_sr * at.solidAngle_sr;
        haze.intensity +=
            pixel.radiance_W_m2_sr * (more_sr + static_cast<double>(received.sent[i]));
        haze.hidden +=
            pixel.opacity * (more_sr * behind_W_m2_sr + static_cast<double>(received.hidden[i]));
        haze.irradiance_per_m2 += pixel.radiance_W_m2_sr *
                                  (projectedMore_sr + static_cast<double>(received.sentCosine[i]));
        haze.hiddenIrradiance_per_m2 +=
            pixel.opacity *
            (projectedMore_sr * behind_W_m2_sr + static_cast<double>(received.hiddenCosine[i]));
    }
    HazeGain gain;
    if (sent != 0.0) {
        gain.intensity += haze.intensity / sent;
        gain.irradiance_per_m2 = haze.irradiance_per_m2 / (sent * range_m * range_m);
    }
    if (hidden != 0.0) {
        gain.hidden += haze.hidden / hidden;
        gain.hiddenIrradiance_per_m2 = haze.hiddenIrradiance_per_m2 / (hidden * range_m * range_m);
    }
    return gain;
}

} // namespace

struct SceneScattering::Impl {
    /// A database with what tells whether its file is still the same.
    struct Loaded {
        std::filesystem::path file;
        std::optional<FileStamp> stamp;
        MtfDatabase database;
    };
    struct Filter {
        double opticalDepth, pitch_rad;
        int support_px;
        double gain, direct;
        MtfFilter filter;
    };

    const MtfDatabase& load(const std::filesystem::path& file) {
        if (!hasScattering())
            throw InputError({file.string(), "scattering", whyNoScattering(),
                              "the package irsg-scattering, or scattering off"});
        const auto stamp = stampOf(file);
        if (!loaded || loaded->file != file || loaded->stamp != stamp) {
            filters.clear();
            loaded.reset();
            loaded.emplace(Loaded{file, stamp, MtfDatabase::read(file)});
        }
        return loaded->database;
    }

    Filter& filterOf(const MtfDatabase& database, double opticalDepth, const std::string& name,
                     double pitch_rad, int support_px) {
        Filter* const known = filters.find([&](const Filter& kept) {
            return kept.opticalDepth == opticalDepth && kept.pitch_rad == pitch_rad &&
                   kept.support_px == support_px;
        });
        if (known != nullptr)
            return *known;
        const MtfCurve curve = database.at(opticalDepth, "the path to '" + name + "'");
        return filters.add({opticalDepth, pitch_rad, support_px, curve.gain(), curve.direct(),
                            MtfFilter(std::make_shared<const PixelHaze>(HazeFunction(curve),
                                                                        pitch_rad, support_px))});
    }

    std::optional<Loaded> loaded;
    RecentlyUsed<Filter> filters{mostFilters};
};

bool hasScattering() {
    return areTransformsInstalled();
}

std::string whyNoScattering() {
    return hasScattering() ? ""
                           : "the Fourier transforms of irsg/scattering are not installed "
                             "(libirsg_fftw.so, which links FFTW)";
}

MtfSummary describeMtf(const std::filesystem::path& database) {
    const MtfDatabase read = MtfDatabase::read(database);
    MtfSummary summary;
    for (const MtfField& field : read.fields())
        summary.fields.push_back({field.name, field.value, field.unit});
    for (std::size_t i = 0; i < read.opticalDepths().size(); ++i)
        summary.curves.push_back(
            {read.opticalDepths()[i], read.values(i).front(), read.values(i).back()});
    summary.remarks = read.remarks();
    summary.lines = read.description();
    for (const std::string& remark : summary.remarks)
        summary.lines.push_back("note: " + remark);
    return summary;
}

SceneScattering::SceneScattering() : impl_(std::make_unique<Impl>()) {}
SceneScattering::~SceneScattering() = default;

void SceneScattering::check(const std::filesystem::path& database) {
    impl_->load(database);
}

int SceneScattering::support_px(const std::filesystem::path& database, const Sensor& sensor) {
    return supportOf(impl_->load(database), sensor);
}

std::vector<ScatteredLight> SceneScattering::addHaze(const std::filesystem::path& file,
                                                     const Sensor& sensor,
                                                     const FrameBackground& background,
                                                     const std::vector<ScatteredObject>& objects,
                                                     RadianceImage& image,
                                                     std::vector<std::string>& warnings) {
    const MtfDatabase& database = impl_->load(file);
    const double pitch_rad = sensor.pixelPitch();
    const int support_px = supportOf(database, sensor);
    appendUnique(warnings, misfits(file, database, sensor, halfFieldOf(database)));

    std::vector<ScatteredLight> told;
    std::vector<double> sums(image.primary().values.size(), 0.0);
    for (const ScatteredObject& object : objects) {
        if (object.pixels.empty())
            continue;
        Impl::Filter& filter =
            impl_->filterOf(database, object.opticalDepth, object.name, pitch_rad, support_px);
        told.push_back({object.name, object.opticalDepth, filter.gain,
                        filter.filter.haze().cut() / filter.gain, static_cast<double>(support_px)});
        if (object.opticalDepth > 0.0)
            addObject(object, filter.direct, background, filter.filter, image, sums);
    }
    std::vector<float>& pixels = image.primary().values;
    for (std::size_t i = 0; i < sums.size(); ++i)
        pixels[i] = static_cast<float>(static_cast<double>(pixels[i]) + sums[i]);
    return told;
}

std::vector<HazeGain> SceneScattering::gains(const std::filesystem::path& file,
                                             const Sensor& sensor,
                                             const FrameBackground& background,
                                             const std::vector<ScatteredObject>& objects,
                                             const std::vector<double>& ranges_m) {
    const MtfDatabase& database = impl_->load(file);
    const double pitch_rad = sensor.pixelPitch();
    const int support_px = supportOf(database, sensor);
    const PixelGrid grid(sensor);
    std::vector<HazeGain> all;
    for (std::size_t e = 0; e < objects.size(); ++e) {
        const ScatteredObject& object = objects[e];
        all.emplace_back();
        const HazeWindow window = planesOf(object, 0.0).window;
        if (window.isEmpty() || !(object.opticalDepth > 0.0))
            continue;
        Impl::Filter& filter =
            impl_->filterOf(database, object.opticalDepth, object.name, pitch_rad, support_px);
        all.back() = gainOf(object, filter.direct, ranges_m[e], grid, background,
                            receivedHaze(window, grid, sensor, background, filter.filter));
    }
    return all;
}

} // namespace irsg
