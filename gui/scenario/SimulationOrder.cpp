#include "gui/scenario/SimulationOrder.h"

#include <algorithm>
#include <cmath>

#include "smatcore/simulate/FrameFiles.h"

namespace smat::gui {
namespace {

constexpr int thumbnailWidth_px = 112;

WrittenFrame smallCopy(const SensorFrame& frame, std::size_t number) {
    const irsg::RadianceImage& image = frame.rendered.image;
    const std::vector<float>& values = image.primary().values;
    WrittenFrame written;
    written.sensor = frame.sensor;
    written.band = frame.band;
    written.number = number;
    written.time_s = frame.time_s;
    // What is small and hot stays to be seen: the largest of the pixels that become one.
    const int step = std::max(1, (image.width() + thumbnailWidth_px - 1) / thumbnailWidth_px);
    written.width = (image.width() + step - 1) / step;
    written.height = (image.height() + step - 1) / step;
    written.values.assign(static_cast<std::size_t>(written.width) *
                              static_cast<std::size_t>(written.height),
                          std::nanf(""));
    written.low = INFINITY;
    written.high = -INFINITY;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const float value = values[image.offset(x, y)];
            if (!std::isfinite(value))
                continue;
            float& small = written.values[static_cast<std::size_t>(y / step * written.width) +
                                          static_cast<std::size_t>(x / step)];
            if (std::isnan(small) || value > small)
                small = value;
            written.low = std::min(written.low, static_cast<double>(value));
            written.high = std::max(written.high, static_cast<double>(value));
        }
    }
    return written;
}

} // namespace

SimulationOutcome runSimulationOrder(const SimulationOrder& order, SceneBuilder& scenes,
                                     const RenderDoor& door, const ProgressCallback& progress,
                                     std::stop_token stop) {
    SimulationOutcome outcome;
    outcome.order = order;
    const SimulationPlan plan = planSimulation(order.scenario, order.request);
    const LoadedScenario loaded = loadScenarioFiles(order.scenario, scenes, {}, order.trajectories);
    const FrameFiles files(loaded, order.folder, order.extensions, order.commandLine);
    files.checkExtensions();
    outcome.notes = files.makeFolders(plan.sensors);
    FilmRecorder recorder(loaded, files);
    writeSimulation(loaded, plan, files, door, outcome.result, progress, std::move(stop), nullptr,
                    [&](SensorFrame& frame, std::size_t number) {
                        outcome.frames.push_back(smallCopy(frame, number));
                        recorder.heed(frame, number);
                    });
    if (std::ranges::find(order.extensions, ".exr") != order.extensions.end())
        outcome.films = recorder.strips();
    return outcome;
}

} // namespace smat::gui
