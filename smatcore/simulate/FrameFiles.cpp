#include "smatcore/simulate/FrameFiles.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "irsg/core/BuildId.h"
#include "irsg/core/Collect.h"
#include "irsg/core/Errors.h"
#include "irsg/core/FileReplacement.h"
#include "irsg/core/ProgramVersion.h"
#include "irsg/core/Wording.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/radiometry/Units.h"
#include "smatcore/analysis/ImageFiles.h"
#include "smatcore/data/ColumnName.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/project/SceneScalings.h"
#include "smatcore/settings/SettingKeys.h"
#include "smatcore/simulate/FramePlaces.h"
#include "smatcore/simulate/ImagingSensorXml.h"
#include "smatcore/support/Folders.h"
#include "smatcore/support/PartialFile.h"

namespace smat {

namespace {

std::string textOf(const irsg::Vec3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

std::string degreesOf(const irsg::Attitude& attitude) {
    return fmt::format("{:.9g} {:.9g} {:.9g}", irsg::degrees(attitude.yaw_rad),
                       irsg::degrees(attitude.pitch_rad), irsg::degrees(attitude.roll_rad));
}

} // namespace

FrameFiles::FrameFiles(const LoadedScenario& scenario, std::filesystem::path folder,
                       std::vector<std::string> extensions, std::string commandLine)
    : scenario_(scenario),
      folder_(std::move(folder)),
      extensions_(std::move(extensions)),
      commandLine_(std::move(commandLine)) {}

void FrameFiles::checkExtensions() const {
    std::vector<irsg::Diagnostic> diagnostics;
    const std::vector<std::string> known = irsg::imageExtensions();
    std::vector<std::string> words;
    for (const std::string& extension : known)
        words.push_back(extension.substr(1));
    for (const std::string& extension : extensions_) {
        if (std::find(known.begin(), known.end(), extension) == known.end()) {
            diagnostics.push_back(
                {.file = "--format",
                 .position = "",
                 .value = extension.substr(std::min<std::size_t>(1, extension.size())),
                 .expected = irsg::alternatives(words)});
        }
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

std::vector<std::string> FrameFiles::makeFolders(const std::vector<std::size_t>& sensors) const {
    std::vector<std::string> sentences;
    for (const std::size_t sensor : sensors) {
        const std::filesystem::path folder = frameFolder(sensor);
        makeFolder(folder, "frames");
        const auto count = std::count_if(std::filesystem::directory_iterator(folder), {},
                                         [](const auto& entry) { return isFrame(entry.path()); });
        if (count > 0) {
            sentences.push_back(fmt::format("{} holds {} frames already; those of other steps or "
                                            "forms stay",
                                            folder.string(), count));
        }
    }
    return sentences;
}

void FrameFiles::checkOutputs(const std::vector<std::size_t>& sensors) const {
    std::vector<irsg::Diagnostic> diagnostics;
    for (const std::size_t sensor : sensors) {
        irsg::collect(diagnostics, [&] { checkFolder(frameFolder(sensor), "frames"); });
        if (!std::filesystem::is_directory(folder_))
            continue;
        for (const std::filesystem::path& file : {tableFile(sensor), imagingSensorFile(sensor)})
            irsg::collect(diagnostics, [&] { irsg::checkWritable(file); });
    }
    if (!diagnostics.empty())
        throw irsg::InputError(diagnostics);
}

std::filesystem::path FrameFiles::frameFile(std::size_t sensor, std::size_t number,
                                            const std::string& extension, std::size_t band) const {
    const std::vector<irsg::Band> bands = scenario_.sensors.at(sensor).scene.allBands();
    const std::string label =
        bands.size() > 1 ? "@" + distinctFileLabels(bandLabels(bands)).at(band) : "";
    return frameFolder(sensor) / fmt::format("frame_{:06}{}{}", number, label, extension);
}

std::vector<std::filesystem::path> FrameFiles::framesOf(std::size_t sensor, std::size_t number,
                                                        std::size_t band) const {
    std::vector<std::filesystem::path> files;
    files.reserve(extensions_.size());
    for (const std::string& extension : extensions_)
        files.push_back(frameFile(sensor, number, extension, band));
    return files;
}

std::filesystem::path FrameFiles::frameFolder(std::size_t sensor) const {
    return folder_ / scenario_.scenario.sensors.at(sensor).name;
}

bool FrameFiles::isFrame(const std::filesystem::path& file) {
    return file.filename().string().starts_with("frame_");
}

std::filesystem::path FrameFiles::tableFile(std::size_t sensor) const {
    return folder_ / (scenario_.scenario.sensors.at(sensor).name + ".csv");
}

std::filesystem::path FrameFiles::imagingSensorFile(std::size_t sensor) const {
    return folder_ / (scenario_.scenario.sensors.at(sensor).name + ".xml");
}

void FrameFiles::writeImagingSensor(std::size_t sensor, const std::filesystem::path& file) const {
    const std::filesystem::path& own = scenario_.scenario.sensors[sensor].imagingSensor;
    smat::writeImagingSensor(scenario_.sensors.at(sensor).settings,
                             file.empty() ? imagingSensorFile(sensor) : file,
                             scenario_.scenario.resolve(own));
}

Provenance sensorProvenance(const LoadedScenario& of, std::size_t sensor,
                            const std::string& commandLine) {
    const Scenario& scenario = of.scenario;
    const LoadedSensor& loaded = of.sensors.at(sensor);
    Provenance provenance;
    provenance.add("program", irsg::programWithVersion());
    provenance.add("analysis", name(AnalysisKind::simulation));
    if (!commandLine.empty())
        provenance.add("command", commandLine);
    provenance.add("scenario", scenario.displayName());
    provenance.add("sensor", scenario.sensors[sensor].name);
    for (const ScenarioEntity& entity : scenario.entities) {
        provenance.add("entity",
                       fmt::format("{} ({}, {})", entity.name, entity.model.filename().string(),
                                   entity.database.filename().string()));
    }
    for (const irsg::Band& band : loaded.scene.allBands()) {
        const irsg::SpectralRange range = band.range();
        provenance.add("band",
                       fmt::format("{} ({} to {} um)", band.name(), range.min_um, range.max_um));
    }
    for (const SettingInfo& setting : settingTable()) {
        if (isScenarioSetting(setting) && !loaded.settings.isDefault(setting.key)) {
            const std::string unit = setting.unit.empty() ? "" : " " + setting.unit;
            provenance.add(setting.key, loaded.settings.text(setting.key) + unit);
        }
    }
    tellSampledScales(loaded.scene, loaded.settings, provenance);
    if (!irsg::buildId().empty())
        provenance.add("build", irsg::buildId());
    return provenance;
}

void FrameFiles::describe(SensorFrame& frame, std::size_t number) const {
    const LoadedSensor& sensor = scenario_.sensors.at(frame.sensor);
    irsg::RadianceImage& image = frame.rendered.image;
    auto& attributes = image.attributes;

    // How the frame came to be; what occurs more than once is joined.
    const auto join = [&](const std::string& key, const std::string& value) {
        std::string& attribute = attributes[key];
        attribute += (attribute.empty() ? "" : "; ") + value;
    };
    for (const auto& [key, value] : sensorProvenance(scenario_, frame.sensor, commandLine_).entries)
        join(key, value);
    const irsg::Band band = sensor.scene.allBands().at(frame.band);
    attributes["band"] =
        fmt::format("{} ({} to {} um)", band.name(), band.range().min_um, band.range().max_um);
    for (const std::string& answer : frame.rendered.report.providedBy)
        join("answered by", answer);

    // Where everybody was.
    attributes.erase("range_m"); // there is one for each entity
    attributes["frame"] = std::to_string(number);
    attributes["time_s"] = fmt::format("{}", frame.time_s);
    attributes["sensor.position_m"] = textOf(frame.viewpoint.position_m);
    attributes["sensor.forward"] = textOf(frame.viewpoint.forward());
    attributes["sensor.up"] = textOf(frame.viewpoint.up);
    for (std::size_t i = 0; i < frame.entities.size(); ++i) {
        const std::string key = "entity." + scenario_.scenario.entities[i].name;
        if (!frame.entities[i]) {
            attributes[key] = "not there";
            continue;
        }
        const TrajectoryPoint& at = *frame.entities[i];
        attributes[key + ".position_m"] = textOf(at.pose.position_m);
        attributes[key + ".yaw_pitch_roll_deg"] = degreesOf(at.pose.attitude);
        attributes[key + ".power"] = fmt::format("{}", at.power);
        attributes[key + ".mach"] = fmt::format("{}", at.mach);
        attributes[key + ".range_m"] = fmt::format("{}", frame.objects[i]->range_m);
    }

    irsg::Sensor detector = sensor.scene.sensor;
    detector.band = band;
    const std::string sentence = showQuantity(image, detector, sensor.settings);
    if (!sentence.empty())
        join("warning", sentence);
}

PictureWords FrameFiles::words(std::size_t sensor, double time_s) const {
    const std::string& title = scenario_.scenario.title;
    const std::string heading = fmt::format("{}{}, {:.6g} s", title.empty() ? "" : title + ": ",
                                            scenario_.scenario.sensors[sensor].name, time_s);
    // Where entities are and when is the scenario's, not the settings'.
    std::vector<Condition> conditions = conditionsOf(scenario_.sensors.at(sensor).settings);
    std::erase_if(conditions, [](const Condition& one) {
        return one.key != key::sensorBand && one.key != key::environmentAtmospheres;
    });
    return {heading, conditions};
}

void FrameFiles::write(SensorFrame& frame, std::size_t number,
                       const std::filesystem::path& folder) const {
    describe(frame, number);
    const PictureWords above = words(frame.sensor, frame.time_s);
    const std::filesystem::path into = folder.empty() ? frameFolder(frame.sensor) : folder;
    for (const std::filesystem::path& file : framesOf(frame.sensor, number, frame.band))
        saveImage(frame.rendered.image, scenario_.sensors.at(frame.sensor).settings, above,
                  scenario_.scenario.displayName(), into / file.filename());
}

Provenance FrameFiles::provenanceOf(const SensorResult& result, AnalysisState state) const {
    Provenance provenance = sensorProvenance(scenario_, result.sensor, commandLine_);
    provenance.add("state", state == AnalysisState::complete ? "complete" : "partial");
    for (const std::string& answer : result.providedBy)
        provenance.add("answered by", answer);
    for (const std::string& warning : result.warnings)
        provenance.add("warning", warning);
    return provenance;
}

void FrameFiles::writeTable(SensorResult& result, AnalysisState state) const {
    result.table.provenance = provenanceOf(result, state);
    result.tableFile =
        savedResult(tableFile(result.sensor), state == AnalysisState::complete,
                    [&](const std::filesystem::path& place) { result.table.save(place); });
}

void writeSimulation(const LoadedScenario& scenario, const SimulationPlan& plan,
                     const FrameFiles& files, const RenderDoor& door, SimulationResult& result,
                     const ProgressCallback& progress, std::stop_token stop, StageTimer* timer,
                     const FrameSink& heed, const SimulationParts* parts) {
    std::optional<FramePlaces> places;
    if (parts == nullptr)
        places.emplace(files, plan.sensors);
    const auto folderOf = [&](std::size_t sensor) {
        return places ? places->folder(sensor) : files.frameFolder(sensor);
    };
    if (parts != nullptr && parts->isPart)
        for (const std::size_t sensor : plan.sensors)
            files.writeImagingSensor(sensor);
    SceneGenerator3D generator(scenario, door);
    SimulationSteps steps;
    if (parts != nullptr)
        steps = {parts->stores, [&](const SensorResult& sensor) {
                     return files.provenanceOf(sensor, AnalysisState::partial);
                 }};
    const auto finish = [&] {
        const bool isWhole = result.state == AnalysisState::complete;
        if (isWhole && places)
            places->moveIn();
        for (SensorResult& sensor : result.sensors) {
            sensor.folder = folderOf(sensor.sensor);
            if (parts != nullptr && parts->isPart)
                continue;
            files.writeTable(sensor, result.state);
            // It belongs to the table beside it.
            const std::filesystem::path own = files.imagingSensorFile(sensor.sensor);
            const bool isBeside = sensor.tableFile != files.tableFile(sensor.sensor);
            files.writeImagingSensor(sensor.sensor, isBeside ? partialFileBeside(own) : own);
            std::error_code ignored;
            if (!isBeside)
                std::filesystem::remove(partialFileBeside(own), ignored);
        }
    };
    try {
        runSimulation(
            generator, plan,
            [&](SensorFrame& frame, std::size_t number) {
                files.write(frame, number, folderOf(frame.sensor));
                if (heed)
                    heed(frame, number);
            },
            result, progress, std::move(stop), timer, parts ? &steps : nullptr);
    } catch (const irsg::InputError&) {
        // What was done so far is kept; the refusal is told by whoever asked.
        finish();
        throw;
    }
    finish();
}

} // namespace smat
