#include "gui/view/InfraredScene.h"

#include <algorithm>

#include "irsg/core/Errors.h"
#include "irsg/core/Stopwatch.h"
#include "irsg/image/ApparentTemperature.h"
#include "irsg/image/ImageStatistics.h"
#include "smatcore/project/EnvironmentInput.h"

namespace smat::gui {

const irsg::ImageChannel& InfraredPicture::plane() const {
    const auto* temperature = image->find(irsg::apparentTemperatureChannel);
    return quantity == InfraredQuantity::apparentTemperature && temperature != nullptr
               ? *temperature
               : image->primary();
}

InfraredScene::InfraredScene()
    : builder_([this](const std::filesystem::path& file, const irsg::ModelOptions& options) {
          // What the window has loaded serves once: a file that changed is read.
          if (const auto known = loaded_.extract({file, options}); !known.empty())
              return known.mapped();
          ++modelsLoaded_;
          return std::shared_ptr<const irsg::Model>(irsg::Model::load(file, options));
      }) {}

InfraredPicture InfraredScene::draw(const InfraredRequest& request) {
    if (!request.project || request.map == nullptr)
        throw irsg::LogicError("an infrared picture needs a project and a colour map");
    InfraredPicture picture;
    {
        const irsg::Stopwatch all(picture.seconds);
        if (!image_ || request.revision != last_.revision || request.coarse != last_.coarse ||
            request.direct != last_.direct) {
            const irsg::Stopwatch watch(picture.radiance_s);
            image_.reset();
            const PlacedCase drawn = placed(request);
            image_ = std::make_shared<irsg::RadianceImage>(
                drawn.render(door_, irsg::Outputs::followedImage()).image);
            view_ = drawn.view;
        } else if (request.quantity == InfraredQuantity::apparentTemperature) {
            image_ = std::make_shared<irsg::RadianceImage>(*image_);
        }
        if (request.quantity == InfraredQuantity::apparentTemperature &&
            image_->find(irsg::apparentTemperatureChannel) == nullptr)
            irsg::addApparentTemperature(*image_, view_.sensor.band);

        picture.image = image_;
        picture.quantity = request.quantity;
        picture.eye = view_.viewpoint;
        picture.size_px = request.size_px;
        picture.horizontalFieldOfView_rad = request.horizontalFieldOfView_rad;
        picture.coarse = request.coarse;
        picture.direct = request.direct;
        picture.revision = request.revision;
        const auto& values = picture.plane().values;
        // Colours hold still while something moves, levels of an equalized scale, too.
        picture.limits = request.coarse && request.limits
                             ? *request.limits
                             : limitsBy(request.rule, {&values}, request.limits);
        picture.colors = colorsOf(*image_, picture.plane(), *request.map, picture.limits);
    }
    last_ = picture;
    return picture;
}

const irsg::Environment& InfraredScene::environment(const InfraredRequest& request) {
    const Settings& settings = request.settings;
    if (const std::string key = environmentKey(*request.project, settings);
        key != environmentKey_) {
        environmentKey_.clear();
        environment_ = environmentOf(*request.project, settings);
        environmentKey_ = key;
    }
    // The sun moves without the air being read again.
    moveSun(environment_.sun, settings);
    return environment_;
}

PlacedCase InfraredScene::placed(const InfraredRequest& request) {
    if (request.models != offered_) {
        loaded_ = offered_ = request.models;
        // Painted ones have other codes while their files are what they were; all others stay, with
        // what is known of them.
        bool arePainted = false;
        for (const auto& [key, model] : offered_) {
            auto& before = codes_[key];
            arePainted |= before && *before != *model->codesBeside();
            before = model->codesBeside();
        }
        if (arePainted)
            builder_.forgetModels();
    }
    builder_.setDatabaseOverrides(request.edited);
    SceneDescription scene =
        builder_.build(*request.project, request.settings, &environment(request));

    scene.sensor.width_px = request.size_px.width();
    scene.sensor.height_px = request.size_px.height();
    scene.sensor.horizontalFieldOfView_rad = request.horizontalFieldOfView_rad;
    scene.settings.truthLayers = false;
    if (request.coarse) {
        scene.settings.tileSide_samples = 0;
        scene.settings.samplesPerAxis = 1;
    }
    if (request.direct)
        scene.settings.bounces = 0;
    const CasePlacer placer(door_, scene);
    const irsg::Vec3 target = scene.entities.front().pose.toWorld(placer.referencePoints().front());
    return placer.place(scene, CasePlacer::placesIn(scene),
                        request.camera.viewpoint(target, request.targetYaw_rad));
}

QImage colorsOf(const irsg::RadianceImage& image, const irsg::ImageChannel& plane,
                const irsg::ColorMap& map, const irsg::DisplayLimits& limits) {
    const auto color = [&](double value) { return map.color(value, limits); };
    QImage colors(image.width(), image.height(), QImage::Format_RGBA8888);
    // Many neighbours are equal: a uniform background is one value.
    float before = 0.0F;
    irsg::Rgb shown = color(0.0);
    for (int y = 0; y < image.height(); ++y) {
        uchar* line = colors.scanLine(y);
        for (int x = 0; x < image.width(); ++x) {
            const float value = plane.values[image.offset(x, y)];
            if (!(value == before)) {
                shown = color(static_cast<double>(value));
                before = value;
            }
            *line++ = shown.red;
            *line++ = shown.green;
            *line++ = shown.blue;
            *line++ = 255;
        }
    }
    return colors;
}

} // namespace smat::gui
