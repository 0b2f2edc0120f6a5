#include "smatcore/simulate/SimulationOutputs.h"

#include "smatcore/simulate/Film.h"

namespace smat {

SimulationOutputs outputsOf(const SceneGenerator3D& generator, const SimulationPlan& plan,
                            const FrameFiles& files, const std::filesystem::path& film,
                            const std::function<bool(std::size_t step)>& mine) {
    SimulationOutputs outputs;
    std::vector<FilmStrip> strips;
    for (const std::size_t sensor : plan.sensors) {
        SimulationOutputs::OfSensor of{.sensor = sensor,
                                       .steps = {},
                                       .frames = {},
                                       .table = files.tableFile(sensor),
                                       .settings = files.imagingSensorFile(sensor)};
        for (std::size_t i = 0; i < plan.steps.size(); ++i)
            if ((!mine || mine(i)) && generator.sees(sensor, plan.steps[i].time_s))
                of.steps.push_back(plan.steps[i]);
        const std::size_t bands = generator.scenario().sensors.at(sensor).scene.allBands().size();
        for (const SimulationPlan::Step& step : of.steps)
            for (std::size_t band = 0; band < bands; ++band)
                for (std::filesystem::path& file : files.framesOf(sensor, step.number, band))
                    of.frames.push_back(std::move(file));
        for (std::size_t band = 0; band < bands && !of.steps.empty(); ++band) {
            strips.push_back(FilmRecorder::stripOf(generator.scenario(), files, sensor, band));
            for (const SimulationPlan::Step& step : of.steps)
                strips.back().frames.push_back({.file = {}, .number = step.number, .words = {}});
        }
        outputs.sensors.push_back(std::move(of));
    }
    if (!film.empty())
        for (const FilmStrip& strip : strips)
            outputs.films.push_back(filmFiles(filmFile(film, strip, strips.size()), strip));
    return outputs;
}

std::string firstToLast(const std::vector<std::filesystem::path>& files) {
    if (files.empty())
        return "";
    return files.front().string() +
           (files.size() > 1 ? " to " + files.back().string() : std::string());
}

} // namespace smat
