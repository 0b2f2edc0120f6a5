#include "smatcore/simulate/CollectScenario.h"

#include <system_error>

#include "smatcore/simulate/ScenarioFile.h"

namespace smat {

namespace fs = std::filesystem;

Scenario collectScenario(const Scenario& scenario, const fs::path& file, FileCollection* told) {
    FileCollection files(collectionFolder(file));
    Scenario made = scenario;
    made.file = fs::absolute(file).lexically_normal();
    const auto resolve = [&scenario](const fs::path& path) { return scenario.resolve(path); };
    const auto take = [&](fs::path& path, const char* kind) {
        if (!path.empty())
            path = files.add(resolve(path), kind);
    };
    for (ScenarioEntity& entity : made.entities) {
        entity.model =
            files.add(resolve(entity.model), "models", filesBesideModel(resolve(entity.model)));
        take(entity.database, "databases");
        take(entity.trajectory, "trajectories");
    }
    made.settings = files.collected(made.settings, resolve);
    for (ScenarioSensor& sensor : made.sensors) {
        take(sensor.trajectory, "trajectories");
        take(sensor.imagingSensor, "sensors");
        sensor.settings = files.collected(sensor.settings, resolve);
    }
    files.write();
    std::error_code failure;
    fs::create_directories(made.file.parent_path(), failure);
    saveScenario(made, made.file);
    if (told != nullptr)
        *told = std::move(files);
    return loadScenario(made.file);
}

} // namespace smat
