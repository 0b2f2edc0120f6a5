#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>

#include "benchmarks/antialiasing/Bodies.h"
#include "benchmarks/antialiasing/Study.h"
#include "irsg/radiometry/Units.h"

namespace irsg::study {

namespace {

constexpr int width_px = 640, height_px = 512;

double rangeOf_m(const Body& body, double size_px) {
    return body.size_m / (size_px * pixel_rad);
}

test::Triangles trianglesOf(const Mesh& mesh) {
    test::Triangles triangles;
    for (const Mesh::Part& part : mesh.parts)
        for (std::size_t i = 0; i < part.triangles.size(); i += 3) {
            auto& triangle = triangles.emplace_back();
            triangle.codes = part.codes;
            triangle.cullsBackFaces = part.culled;
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.vertex[k] = toVec3(part.vertices[part.triangles[i + k]]);
                triangle.normal[k] = toVec3(part.normals[part.triangles[i + k]]);
            }
        }
    return triangles;
}

void lookFrom(InteractiveRenderer& irsg, double azimuth_rad, double elevation_rad, double range_m) {
    test::look(irsg, {.range_m = range_m,
                      .azimuth_rad = azimuth_rad,
                      .elevation_rad = elevation_rad,
                      .width_px = width_px,
                      .height_px = height_px,
                      .fieldOfView_rad = 2.0 * std::atan(0.5 * width_px * pixel_rad)});
}

struct FrameTime {
    double wall_ms = 0.0, processor_ms = 0.0;
};

FrameTime timeOf(InteractiveRenderer& irsg) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    irsg.imageWithReport();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - start;
    return {wall.count(), 1e3 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values, values.begin() + static_cast<long>(values.size() / 2));
    return values[values.size() / 2];
}

FrameTime median(const std::vector<FrameTime>& times) {
    std::vector<double> wall, processor;
    for (const FrameTime& time : times) {
        wall.push_back(time.wall_ms);
        processor.push_back(time.processor_ms);
    }
    return {median(wall), median(processor)};
}

/// A scene in a frame of 640 x 512 pixels, drawn by each method with a generator of its own: what
/// one keeps from frame to frame no other disturbs.
class TimedScene {
  public:
    TimedScene(Entity entity, double azimuth_rad, double elevation_rad)
        : entity_(std::move(entity)), azimuth_rad_(azimuth_rad), elevation_rad_(elevation_rad) {
        for (const Method& method : methods()) {
            InteractiveRenderer& irsg =
                *generators_.emplace_back(std::make_unique<InteractiveRenderer>());
            irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
            irsg.scene.settings = method.settings();
            irsg.scene.entities = {entity_};
        }
    }

    /// Median time by range and method. The methods take turns, and all ranges are gone through
    /// again and again with a few frames each, so that a busy moment of the machine meets every one
    /// of them.
    std::vector<std::vector<FrameTime>> times(const std::vector<double>& ranges_m, int rounds) {
        constexpr int roundsOfPass = 5;
        const int passes = (rounds + roundsOfPass - 1) / roundsOfPass;
        std::vector<std::vector<std::vector<FrameTime>>> taken(
            ranges_m.size(), std::vector<std::vector<FrameTime>>(generators_.size()));
        for (int pass = 0; pass < passes; ++pass)
            for (std::size_t r = 0; r < ranges_m.size(); ++r)
                take(ranges_m[r], roundsOfPass, taken[r]);

        std::vector<std::vector<FrameTime>> result;
        for (const auto& ofRange : taken)
            for (std::vector<FrameTime>& medians = result.emplace_back(); const auto& all : ofRange)
                medians.push_back(median(all));
        return result;
    }

  private:
    /// Appends the times of some frames, by method.
    void take(double range_m, int rounds, std::vector<std::vector<FrameTime>>& taken) {
        const std::vector<Method> all = methods();
        for (std::size_t m = 0; m < all.size(); ++m) {
            generators_[m]->scene.entities[0].pose = entity_.pose;
            lookFrom(*generators_[m], azimuth_rad_, elevation_rad_, range_m);
            if (all[m].wholeFrame)
                mark(*generators_[m]);
        }

        const Viewpoint camera = generators_.front()->view.viewpoint;
        for (int round = 0; round <= rounds; ++round) {
            Pose pose = entity_.pose;
            pose.position_m = pose.position_m + phaseShift_m(camera, range_m * pixel_rad, round);
            for (std::size_t m = 0; m < all.size(); ++m) {
                if (all[m].wholeFrame && round > 1) // ten to a hundred times as long
                    continue;
                generators_[m]->scene.entities[0].pose = pose;
                const FrameTime time = timeOf(*generators_[m]);
                if (round > 0) // shaders are made and targets grown in the first
                    taken[m].push_back(time);
            }
        }
    }

    /// Has the whole frame drawn from where the generator looks.
    void mark(InteractiveRenderer& irsg) const {
        Entity entity = entity_;
        entity.model =
            test::modelOf(test::joined(trianglesOf(*entity_.model->mesh()),
                                       cornerMarks(irsg.view.viewpoint, entity_.pose.position_m,
                                                   width_px, height_px)),
                          "marked");
        irsg.scene.entities = {entity};
    }

    std::vector<std::unique_ptr<InteractiveRenderer>> generators_; // by method
    Entity entity_;
    double azimuth_rad_, elevation_rad_;
};

/// Every index of the model has an entry; its plumes let 60 % through.
Entity aircraft() {
    const std::shared_ptr<const Model> model =
        Model::load(std::string(SMAT_SOURCE_DIR) + "/samples/turboprop4/turboprop4.flt");
    SignatureDatabase database;
    for (const auto& [codes, use] : model->codes()) {
        database.temperatures[codes.temperature] = test::fixedTemperature(320.0);
        database.materials[codes.material] = test::greyMaterial(0.8);
    }
    database.temperatures.try_emplace(1, test::fixedTemperature(320.0));
    database.materials.try_emplace(1, test::greyMaterial(0.8));
    for (const int zone : {5, 6, 7})
        database.materials[zone] = test::greyMaterial(0.4, 0.6);
    return test::entityOf(model, std::move(database));
}

std::ofstream curve(const Options& options, const std::string& figure, const Method& method,
                    const std::string& header) {
    const std::filesystem::path folder = options.folder / figure;
    std::filesystem::create_directories(folder);
    std::ofstream file(folder / (method.name() + ".csv"));
    file << "# range.log: true\n" << header << "\n";
    return file;
}

std::vector<double> ranges_m() {
    return {1e3, 2e3, 3e3, 5e3, 7e3, 1e4, 1.5e4, 2e4, 3e4, 4.5e4, 6e4, 1e5, 2e5};
}

} // namespace

void measureTimes(const Options& options) {
    std::ofstream file(options.folder / "times.csv");
    file << "body,size [px],strategy,mode,whole_frame,time [ms],processor_time [ms]\n";
    for (const Body& body : chosenBodies(options)) {
        Entity entity = greyEntity(body.mesh);
        entity.pose.attitude = body.attitude;
        TimedScene scene(entity, body.azimuth_rad, body.elevation_rad);
        std::vector<double> ranges_m;
        for (const double size_px : sizes_px())
            ranges_m.push_back(rangeOf_m(body, size_px));
        const auto times = scene.times(ranges_m, options.rounds);
        const auto all = methods();
        for (std::size_t size = 0; size < ranges_m.size(); ++size)
            for (std::size_t m = 0; m < all.size(); ++m) {
                char row[200];
                std::snprintf(row, sizeof row, "%s,%.6g,%s,%d,%d,%.4g,%.4g\n", body.name.c_str(),
                              sizes_px()[size], all[m].strategy.c_str(), all[m].mode,
                              all[m].wholeFrame ? 1 : 0, times[size][m].wall_ms,
                              times[size][m].processor_ms);
                file << row << std::flush;
            }
    }
}

void measureRanges(const Options& options) {
    const std::vector<Method> all = methods();
    std::vector<std::ofstream> time, intensity;
    for (const Method& method : all) {
        time.push_back(curve(options, "time", method,
                             "range [m],time_per_frame [ms],processor_time_per_frame [ms]"));
        if (!method.wholeFrame)
            intensity.push_back(
                curve(options, "intensity", method, "range [m],contrast_intensity [W sr-1]"));
    }

    TimedScene scene(aircraft(), radians(60.0), radians(15.0));
    const auto times = scene.times(ranges_m(), options.rounds);
    for (std::size_t r = 0; r < times.size(); ++r)
        for (std::size_t m = 0; m < all.size(); ++m)
            time[m] << ranges_m()[r] << "," << times[r][m].wall_ms << ","
                    << times[r][m].processor_ms << "\n";

    // The sphere of 1 m radius moves across the pixels as it recedes; finely stepped, so that what
    // a mode makes of its phase is seen.
    InteractiveRenderer irsg{RenderSettings::direct()};
    irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
    irsg.scene.entities = {greyEntity(bodies().front().mesh)};
    constexpr int steps = 200;
    for (int i = 0; i <= steps; ++i) {
        const double range_m = 1e3 * std::pow(200.0, static_cast<double>(i) / steps);
        irsg.scene.entities[0].pose = {{0, 0, test::standingAltitude_m}, {}};
        test::look(irsg, {.range_m = range_m,
                          .width_px = 64,
                          .height_px = 64,
                          .fieldOfView_rad = 2.0 * std::atan(32.0 * pixel_rad)});
        irsg.scene.entities[0].pose = {
            Vec3{0, 0, test::standingAltitude_m} +
                phaseShift_m(irsg.view.viewpoint, pixel_rad * range_m, i),
            {}};
        std::size_t file = 0;
        for (const Method& method : all) {
            if (method.wholeFrame)
                continue;
            irsg.scene.settings = method.settings();
            intensity[file++] << range_m << ","
                              << irsg.imageWithReport().report.all.contrastIntensity_W_sr << "\n";
        }
    }
}

void profile(const Options& options) {
    for (const Body& body : chosenBodies(options)) {
        InteractiveRenderer irsg{RenderSettings::direct()};
        irsg.scene.environment = test::environmentOf(test::ConstantAtmosphere{});
        Entity entity = greyEntity(body.mesh);
        entity.pose.attitude = body.attitude;
        irsg.scene.entities = {entity};
        for (const Method& method : methods()) {
            if (method.wholeFrame)
                continue;
            irsg.scene.settings = method.settings();
            for (const double size_px : sizes_px()) {
                lookFrom(irsg, body.azimuth_rad, body.elevation_rad, rangeOf_m(body, size_px));
                irsg.imageWithReport();
                irsg.resetStageTimes();
                std::vector<FrameTime> times;
                for (int i = 0; i < options.rounds; ++i)
                    times.push_back(timeOf(irsg));
                std::printf("%-18s %7.2f px %-16s %6.3f ms:", body.name.c_str(), size_px,
                            method.name().c_str(), median(times).wall_ms);
                for (const StageTimes::Stage& stage : irsg.stageTimes().stages)
                    std::printf("  %s %.3f", stage.name.c_str(),
                                1e3 * stage.seconds / options.rounds);
                std::printf("\n");
            }
        }
    }
}

} // namespace irsg::study
