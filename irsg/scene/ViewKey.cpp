#include "irsg/scene/ViewKey.h"

#include "irsg/scene/KeyNumbers.h"

namespace irsg {

void appendReceivers(const SurfaceShading& shading, double lightError,
                     std::vector<double>& numbers) {
    if (!shading.between.exchange)
        return;
    numbers.push_back(lightError);
    for (const LightExchange::Body& body : shading.between.exchange->bodies()) {
        numbers.push_back(static_cast<double>(body.light->nodes().nodes()));
        numbers.push_back(static_cast<double>(body.light->mesh().cells()));
    }
}

void appendLobes(const SceneSurfaces& surfaces, std::vector<double>& numbers) {
    if (!surfaces.shading.lobes)
        return;
    for (const auto& model : surfaces.evaluation.evaluated->radiometry.models()) {
        numbers.push_back(model ? 1.0 : 0.0);
        if (model)
            numbers.insert(numbers.end(), model->key().begin(), model->key().end());
    }
    for (const ObjectGeometry& object : surfaces.evaluation.geometry)
        for (const double number : object.mirror.key())
            numbers.push_back(number);
    const std::vector<double> mirrors = surfaces.shading.lobes->mirrors().key();
    numbers.insert(numbers.end(), mirrors.begin(), mirrors.end());
}

ViewKey viewKey(const RadianceTerms& terms, const FrameRequest& request,
                const SceneSurfaces& surfaces, const std::vector<AlongRange>& alongRange) {
    const RenderSettings& settings = request.scene.settings;
    const Sensor& sensor = request.view.sensor;
    ViewKey key;
    key.numbers = {static_cast<double>(sensor.width_px),
                   static_cast<double>(sensor.height_px),
                   sensor.horizontalFieldOfView_rad,
                   static_cast<double>(settings.tileSide_samples),
                   static_cast<double>(settings.tileStrategy),
                   static_cast<double>(settings.samplesPerAxis),
                   settings.countsPerPixel ? 1.0 : 0.0,
                   settings.pointSourceBelow_px,
                   static_cast<double>(settings.maximumLayers),
                   settings.terrainHides ? 1.0 : 0.0,
                   surfaces.engine.isRays ? 1.0 : 0.0,
                   request.withErrors ? 1.0 : 0.0,
                   surfaces.shading.shadows ? static_cast<double>(settings.sunShadows) : 0.0};
    const Viewpoint& viewpoint = request.view.viewpoint;
    for (const Vec3& v : {viewpoint.position_m, viewpoint.right, viewpoint.up})
        appendTo(key.numbers, v);
    for (const FrameDirection& direction : terms.directions)
        appendTo(key.numbers, direction.world(request.scene.environment.sun));
    for (const Entity& entity : request.scene.entities) {
        appendTo(key.numbers, entity.pose.position_m);
        appendTo(key.numbers, entity.pose.attitude);
        key.models.push_back(entity.model);
    }
    for (const SurfaceRow& row : surfaces.evaluation.rows)
        key.numbers.push_back(static_cast<double>(row.nAngleFactor));
    key.numbers.insert(key.numbers.end(), surfaces.evaluation.hot.begin(),
                       surfaces.evaluation.hot.end());
    if (surfaces.shading.shadows)
        key.numbers.insert(key.numbers.end(), surfaces.shading.shadows->reflects().begin(),
                           surfaces.shading.shadows->reflects().end());
    appendReceivers(surfaces.shading, settings.lightError, key.numbers);
    appendLobes(surfaces, key.numbers);
    for (const ObjectGeometry& object : surfaces.evaluation.geometry)
        if (object.hidden != HiddenPart::none)
            key.numbers.insert(key.numbers.end(), object.hiddenBelow_m.begin(),
                               object.hiddenBelow_m.end());
    for (const AlongRange& one : alongRange)
        key.numbers.push_back(static_cast<double>(one.object.entity));
    if (!alongRange.empty())
        key.numbers.push_back(request.sampledFrom_m.value_or(0.0));
    key.terrain = request.scene.terrain;
    key.rows = surfaces.rows();
    key.shader = terms.glsl(settings);
    return key;
}

} // namespace irsg
