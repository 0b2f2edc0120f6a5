#include "gui/scenario/ScenarioPictures.h"

#include "gui/widgets/NumberFormat.h"
#include "gui/widgets/Sentences.h"
#include "gui/workbench/ModelStore.h"
#include "irsg/image/ApparentTemperature.h"
#include "smatcore/analysis/Conditions.h"
#include "smatcore/simulate/FrameFiles.h"

namespace smat::gui {

/// The renderer with the scenario that it holds; one picture at a time uses it.
struct ScenarioPictures::Engine {
    explicit Engine(std::shared_ptr<ModelStore> models)
        : scenes(ModelStore::loader(std::move(models))) {}

    void load(const std::shared_ptr<const EditedScenario>& state) {
        if (state == of)
            return;
        of.reset();
        generator.reset();
        files.reset();
        loaded = loadScenarioFiles(state->scenario, scenes, {}, state->trajectories);
        generator.emplace(loaded, door);
        files.emplace(loaded, std::filesystem::path(), std::vector<std::string>(), "");
        of = state;
    }
    ScenarioPicture draw(const ScenarioMoment& moment);

    SceneBuilder scenes;
    RenderDoor door = openRenderDoor();
    std::shared_ptr<const EditedScenario> of;
    LoadedScenario loaded;
    std::optional<SceneGenerator3D> generator;
    std::optional<FrameFiles> files;
};

ScenarioPicture ScenarioPictures::Engine::draw(const ScenarioMoment& moment) {
    ScenarioPicture picture;
    picture.moment = moment;
    const LoadedSensor& sensor = loaded.sensors.at(moment.sensor);
    const std::vector<irsg::Band> bands = sensor.scene.allBands();
    picture.settings = sensor.settings;
    picture.bandCount = bands.size();
    for (const std::string& warning : sensor.warnings)
        picture.notes << textOf(warning);
    const PictureWords words = files->words(moment.sensor, moment.time_s);
    picture.title = textOf(words.title);
    picture.conditions = textOf(lineOf(words.conditions));
    for (std::size_t i = 0; i < loaded.paths.size(); ++i)
        picture.entities.push_back(loaded.entityAt(i, moment.time_s));
    generator->check({moment.sensor}, {moment.time_s});
    if (!generator->sees(moment.sensor, moment.time_s))
        return picture;
    picture.moment.band = std::min(moment.band, bands.size() - 1);
    SensorFrame frame = generator->frame(moment.sensor, moment.time_s, picture.moment.band);
    files->describe(frame, moment.step);
    picture.objects = frame.objects;
    for (const std::string& warning : frame.warnings)
        picture.notes << textOf(warning);
    auto image = std::make_shared<irsg::RadianceImage>(std::move(frame.rendered.image));
    picture.image = image;
    picture.shown = image;
    if (image->primary().name == "L") {
        auto with = std::make_shared<irsg::RadianceImage>(*image);
        irsg::addApparentTemperature(*with, bands[picture.moment.band]);
        picture.shown = with;
    }
    return picture;
}

ScenarioPictures::ScenarioPictures(std::shared_ptr<ModelStore> models, QObject* parent)
    : QObject(parent), engine_(std::make_shared<Engine>(std::move(models))) {}

ScenarioPictures::~ScenarioPictures() = default;

void ScenarioPictures::setScenario(std::shared_ptr<const EditedScenario> state) {
    state_ = std::move(state);
}

void ScenarioPictures::ask(const ScenarioMoment& moment) {
    next_ = moment;
    if (!isDrawing_)
        begin();
}

void ScenarioPictures::begin() {
    isDrawing_ = true;
    const ScenarioMoment moment = *next_;
    next_.reset();
    emit busyChanged();
    const auto end = [this] {
        isDrawing_ = false;
        if (next_)
            begin();
        else
            emit busyChanged();
    };
    task_.run<ScenarioPicture>(
        [engine = engine_, state = state_, moment] {
            engine->load(state);
            return engine->draw(moment);
        },
        [this, state = state_, end](const ScenarioPicture& picture) {
            // What was edited meanwhile is drawn next.
            if (state == state_)
                emit drawn(picture);
            end();
        },
        [this, state = state_, end](const std::exception_ptr& thrown) {
            if (state == state_)
                emit failed(sentencesOf(thrown));
            end();
        });
}

} // namespace smat::gui

#include "moc_ScenarioPictures.cpp"
