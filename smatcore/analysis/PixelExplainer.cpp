#include "smatcore/analysis/PixelExplainer.h"

#include <utility>

#include "smatcore/analysis/AnalysisGenerator.h"
#include "smatcore/settings/SettingKeys.h"

namespace smat {

namespace {

/// The databases as they were when the image was computed, in place of their files.
SceneBuilder::DatabaseOverrides databasesOf(const AnalysisData& data) {
    SceneBuilder::DatabaseOverrides databases;
    for (std::size_t i = 0; i < data.project.models.size() && i < data.databases.size(); ++i)
        if (data.databases[i])
            databases[data.project.resolve(data.project.models[i].database)] = data.databases[i];
    return databases;
}

} // namespace

PixelExplainer::PixelExplainer(AnalysisData image, SceneBuilder::ModelLoader models,
                               RenderDoor door, StageTimer* timer)
    : data_(std::move(image)), door_(door.isOpen() ? std::move(door) : openRenderDoor()) {
    if (!data_.settings[key::imageSensor].empty())
        throw irsg::InputError({.file = "",
                                .position = key::imageSensor,
                                .value = data_.settings.text(key::imageSensor),
                                .expected = "none: a sensor mixes what its pixels see, which has "
                                            "no terms"});
    data_.settings.set(key::imageQuantity, "radiance");
    if (bandsOf(data_.project, data_.settings).size() > 1)
        throw irsg::InputError({.file = "",
                                .position = key::sensorBand,
                                .value = "several bands",
                                .expected = "one band: a pixel has terms for each"});
    SceneBuilder builder(std::move(models));
    builder.setDatabaseOverrides(databasesOf(data_));
    const PlacedCase drawn =
        AnalysisGenerator(door_, [&](const Project& project, const Settings& settings) {
            return builder.build(project, settings);
        }).run(data_, {}, {}, timer);
    const StageTimer::Scope ready(timer, "make ready to explain");
    explain_ = door_.explainer(drawn.scene, drawn.view);
}

PixelExplainer::~PixelExplainer() {
    explain_ = nullptr; // before its door
}

ExplainedPixel PixelExplainer::explain(int x, int y) {
    const std::scoped_lock lock(mutex_);
    return {explain_(x, y), static_cast<double>(data_.image.at(x, y))};
}

} // namespace smat
