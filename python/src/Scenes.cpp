#include "python/src/Scenes.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "python/src/Environments.h"
#include "python/src/Pool.h"
#include "smatcore/data/ResultTable.h"
#include "smatcore/project/SceneBuilder.h"
#include "smatcore/settings/Settings.h"

namespace smat::python {

namespace {

using irsg::Entity;
using irsg::ObjectRadiometry;
using irsg::Outputs;
using irsg::Rendered;
using irsg::RenderReport;
using irsg::Scene;
using irsg::Sensor;
using irsg::SensorView;
using irsg::Viewpoint;
using Point = std::array<double, 3>;

irsg::Vec3 vectorOf(const Point& point) {
    return {point[0], point[1], point[2]};
}
Point pointOf(const irsg::Vec3& vector) {
    return {vector.x, vector.y, vector.z};
}

void addSensor(py::module_& module) {
    py::class_<Sensor>(module, "Sensor", R"(A pinhole camera with square pixels on a flat detector.

Parameters
----------
width_px, height_px : int
    1 to 16384.
horizontal_field_of_view_rad : float
    0 to pi, exclusive.
band : Band
    Its spectral response.

Raises
------
InputError
    For numbers out of range.
)")
        .def(py::init([](int width_px, int height_px, double field_rad, const irsg::Band& band) {
                 const Sensor sensor{width_px, height_px, field_rad, band};
                 sensor.check();
                 return sensor;
             }),
             py::arg("width_px") = Sensor().width_px, py::arg("height_px") = Sensor().height_px,
             py::arg("horizontal_field_of_view_rad") = Sensor().horizontalFieldOfView_rad,
             py::arg_v("band", Sensor().band, "Band('3-5')"))
        .def_readonly("width_px", &Sensor::width_px, "Columns.")
        .def_readonly("height_px", &Sensor::height_px, "Rows.")
        .def_readonly("horizontal_field_of_view_rad", &Sensor::horizontalFieldOfView_rad,
                      "Horizontal field of view, rad.")
        .def_readonly("band", &Sensor::band, "Spectral response.")
        .def("__eq__", [](const Sensor& a, const Sensor& b) { return a == b; })
        .def("__eq__", [](const Sensor&, const py::object&) { return false; })
        .def("__repr__",
             [](const Sensor& sensor) {
                 return "Sensor of " + std::to_string(sensor.width_px) + " x " +
                        std::to_string(sensor.height_px) + " px, " + sensor.band.name();
             })
        .def(py::pickle(
            [](const Sensor& sensor) {
                return py::make_tuple(sensor.width_px, sensor.height_px,
                                      sensor.horizontalFieldOfView_rad, sensor.band);
            },
            [](const py::tuple& state) {
                return Sensor{state[0].cast<int>(), state[1].cast<int>(), state[2].cast<double>(),
                              state[3].cast<irsg::Band>()};
            }))
        .attr("__hash__") = py::none();
}

void addViewpoint(py::module_& module) {
    py::class_<Viewpoint>(module, "Viewpoint",
                          "Where a camera is and how it is turned, in the world (x east, y north, "
                          "z up); made by about() or look_at().")
        .def_static(
            "about",
            [](const Point& point, double azimuth_rad, double elevation_rad, double range_m,
               double yaw_rad) {
                return Viewpoint::about(vectorOf(point), yaw_rad, azimuth_rad, elevation_rad,
                                        range_m);
            },
            py::arg("reference_point_m"), py::kw_only(), py::arg("azimuth_rad"),
            py::arg("elevation_rad"), py::arg("range_m"), py::arg("yaw_rad") = 0.0,
            R"(A camera that looks at a point from an azimuth and an elevation.

Parameters
----------
reference_point_m : (float, float, float)
    The point, in the world, m.
azimuth_rad : float
    0 sees the nose, pi / 2 the starboard side of a model with that yaw.
elevation_rad : float
    Of the camera above the point.
range_m : float
    Distance, m.
yaw_rad : float
    Of the frame that the azimuth is counted in, counter-clockwise from above.
)")
        .def_static(
            "look_at",
            [](const Point& position, const Point& target) {
                return Viewpoint::lookAt(vectorOf(position), vectorOf(target));
            },
            py::arg("position_m"), py::arg("target_m"),
            "A camera at a place that looks at another one, with the world's z up.")
        .def_property_readonly(
            "position_m", [](const Viewpoint& self) { return pointOf(self.position_m); },
            "Where the camera is, m.")
        .def_property_readonly(
            "forward", [](const Viewpoint& self) { return pointOf(self.forward()); },
            "Unit vector along the line of sight.")
        .def_property_readonly(
            "up", [](const Viewpoint& self) { return pointOf(self.up); },
            "Unit vector that is up in the image.")
        .def(py::pickle(
            [](const Viewpoint& self) {
                return py::make_tuple(pointOf(self.position_m), pointOf(self.right),
                                      pointOf(self.up), pointOf(self.backward));
            },
            [](const py::tuple& state) {
                const auto vector = [&](std::size_t i) { return vectorOf(state[i].cast<Point>()); };
                return Viewpoint{vector(0), vector(1), vector(2), vector(3)};
            }));
    py::class_<SensorView>(module, "SensorView",
                           "Who looks, and from where: a sensor and a viewpoint.")
        .def(py::init([](const Sensor& sensor, const Viewpoint& viewpoint) {
                 return SensorView{sensor, viewpoint};
             }),
             py::arg("sensor"), py::arg("viewpoint"))
        .def_readonly("sensor", &SensorView::sensor, "The sensor.")
        .def_readonly("viewpoint", &SensorView::viewpoint, "The viewpoint.")
        .def(py::pickle(
            [](const SensorView& self) { return py::make_tuple(self.sensor, self.viewpoint); },
            [](const py::tuple& state) {
                return SensorView{state[0].cast<Sensor>(), state[1].cast<Viewpoint>()};
            }));
}

Entity entityOf(const std::shared_ptr<irsg::Model>& model,
                const std::shared_ptr<irsg::SignatureDatabase>& database, const std::string& name,
                const Point& position_m, const Point& attitude_rad, double time_s, double power,
                double mach) {
    Entity entity;
    entity.name = name.empty() ? model->name() : name;
    entity.model = model;
    entity.database = database;
    entity.pose = {vectorOf(position_m), {attitude_rad[0], attitude_rad[1], attitude_rad[2]}};
    entity.state = {.time_s = time_s, .power = power, .mach = mach};
    return entity;
}

void addEntity(py::module_& module) {
    py::class_<Entity>(module, "Entity", R"(One thing that flies, drives or floats.

Parameters
----------
model : Model
    Its shape.
database : SignatureDatabase
    What stands behind the codes of the model.
name : str
    How results call it; the model's name where it is empty.
position_m : (float, float, float)
    Of the model's origin in the world: east, north, altitude, m.
attitude_rad : (float, float, float)
    Yaw (counter-clockwise from above), pitch (nose up) and roll (starboard down), rad.
time_s, power, mach : float
    Its state, which temperatures may depend on.
)")
        .def(py::init(&entityOf), py::arg("model").none(false), py::arg("database").none(false),
             py::kw_only(), py::arg("name") = "", py::arg("position_m") = Point{},
             py::arg("attitude_rad") = Point{}, py::arg("time_s") = 0.0, py::arg("power") = 0.0,
             py::arg("mach") = 0.0)
        .def_readonly("name", &Entity::name, "How results call it.")
        .def("__repr__", [](const Entity& entity) { return "Entity " + entity.name; });
}

Scene sceneOf(const std::vector<Entity>& entities, const NamedEnvironment* environment,
              const std::map<std::string, std::string>& settings) {
    Settings given;
    for (const auto& [key, text] : settings) {
        if (!key.starts_with("render."))
            throw badArgument("settings", key, "a setting of the section render");
        given.set(key, text, "settings");
    }
    Scene scene;
    scene.entities = entities;
    if (environment != nullptr)
        scene.environment = environment->environment;
    scene.settings = renderSettingsOf(given);
    return scene;
}

void addScene(py::module_& module) {
    py::class_<Scene>(module, "Scene", R"(What there is to see, and how it is computed.

Parameters
----------
entities : list of Entity
    The first is the target.
environment : Environment, optional
    Air and sun; vacuum without it.
settings : dict of str to object
    Settings of rendering, such as ``{'render.sun': 'off'}`` (docs/settings.md).

Raises
------
InputError
    For a setting that does not exist and a value that it cannot have.
)")
        .def(py::init([](const std::vector<Entity>& entities, const NamedEnvironment* environment,
                         const py::dict& settings) {
                 return sceneOf(entities, environment,
                                py::module_::import("smat._settings")
                                    .attr("texts")(settings)
                                    .cast<std::map<std::string, std::string>>());
             }),
             py::arg("entities"), py::arg("environment") = py::none(),
             py::arg("settings") = py::dict())
        .def_property_readonly(
            "entities",
            [](const Scene& scene) {
                std::vector<std::string> names;
                for (const Entity& entity : scene.entities)
                    names.push_back(entity.name);
                return names;
            },
            "Names of the entities.");
}

void addOutputs(py::module_& module) {
    py::class_<Outputs>(module, "Outputs",
                        "What of a view is asked for; whatever is not is not computed.")
        .def_static("image", &Outputs::image, "The image in the sensor's band.")
        .def_static(
            "image_with_reports",
            [](bool errors) -> Outputs { return Outputs::imageWithReports().withErrors(errors); },
            py::kw_only(), py::arg("errors") = false,
            "The image, and the sums of the objects; with errors, the bounds of these.")
        .def_static(
            "reports",
            [](const std::vector<irsg::Band>& bands, bool errors) -> Outputs {
                return Outputs::reports(bands).withErrors(errors);
            },
            py::arg("bands") = std::vector<irsg::Band>(), py::kw_only(), py::arg("errors") = false,
            "The sums of the objects in each band, without in the sensor's.")
        .def_static(
            "spectrum",
            [](const Numbers& wavenumbers_per_cm) -> Outputs {
                return Outputs::spectrum(
                    python::vectorOf(wavenumbers_per_cm, "wavenumbers_per_cm"));
            },
            py::arg("wavenumbers_per_cm"),
            "The spectra of the objects at wavenumbers, cm-1, shape (n,).");
}

std::shared_ptr<ResultTable> tableOf(const irsg::IntensitySpectrum& spectrum) {
    if (spectrum.wavenumbers_per_cm.empty())
        return nullptr;
    auto table = std::make_shared<ResultTable>();
    using enum irsg::Quantity;
    table->add(wavenumber).values = spectrum.wavenumbers_per_cm;
    table->add(wavelength).values = spectrum.wavelengths_um;
    table->add(spectralIntensity).values = spectrum.intensity_W_sr_um;
    table->add(spectralContrastIntensity).values = spectrum.contrastIntensity_W_sr_um;
    table->add(spectralIrradiance).values = spectrum.irradiance_W_m2_um;
    return table;
}

/// The error of a number at two standard deviations; none where it was not asked for.
std::optional<double> errorOf(const ObjectRadiometry& object,
                              irsg::ErrorParts irsg::RadiometryErrors::*number) {
    if (!object.errors)
        return std::nullopt;
    return (*object.errors.*number).sum();
}

void addReports(py::module_& module) {
    using Errors = irsg::RadiometryErrors;
    py::class_<ObjectRadiometry>(module, "ObjectRadiometry",
                                 "The radiometry of one object as the sensor sees it.")
        .def_readonly("name", &ObjectRadiometry::name, "Its name.")
        .def_readonly("range_m", &ObjectRadiometry::range_m, "From the sensor, m.")
        .def_readonly("intensity_W_sr", &ObjectRadiometry::intensity_W_sr,
                      "Radiant intensity through the air, W sr-1.")
        .def_readonly("contrast_intensity_W_sr", &ObjectRadiometry::contrastIntensity_W_sr,
                      "The same less the background that it hides, W sr-1.")
        .def_readonly("irradiance_W_m2", &ObjectRadiometry::irradiance_W_m2,
                      "Irradiance of the contrast at the sensor, W m-2.")
        .def_readonly("covered_pixels", &ObjectRadiometry::coveredPixels, "Pixels that it covers.")
        .def_readonly("solid_angle_sr", &ObjectRadiometry::solidAngle_sr, "Solid angle, sr.")
        .def_property_readonly(
            "error_intensity_W_sr",
            [](const ObjectRadiometry& object) { return errorOf(object, &Errors::intensity_W_sr); },
            "Error of the intensity at two standard deviations, W sr-1; None where it was not "
            "asked for.")
        .def_property_readonly(
            "error_contrast_intensity_W_sr",
            [](const ObjectRadiometry& object) {
                return errorOf(object, &Errors::contrastIntensity_W_sr);
            },
            "The same of the contrast intensity, W sr-1.");
    py::class_<RenderReport>(module, "RenderReport", "The sums of a view in one band.")
        .def_readonly("objects", &RenderReport::objects, "Each object, in the order of the scene.")
        .def_readonly("all", &RenderReport::all, "All objects together.")
        .def_readonly("total_irradiance_W_m2", &RenderReport::totalIrradiance_W_m2,
                      "Irradiance of the whole frame, background included, W m-2.")
        .def_readonly("background_W_m2_sr", &RenderReport::background_W_m2_sr,
                      "Radiance of the background, W m-2 sr-1.")
        .def_readonly("provided_by", &RenderReport::providedBy,
                      "Which atmosphere provided what: 'transmittance: vacuum'.")
        .def_readonly("warnings", &RenderReport::warnings, "What there is to warn of.")
        .def_readonly("renderer", &RenderReport::renderer, "OpenGL renderer, or rays.");
    py::class_<Rendered, std::shared_ptr<Rendered>>(module, "Rendered", "What came out of a view.")
        .def_property_readonly(
            "image",
            [](const std::shared_ptr<Rendered>& rendered) -> std::shared_ptr<irsg::RadianceImage> {
                if (rendered->image.empty())
                    return nullptr;
                return {rendered, &rendered->image};
            },
            "The Image, which keeps the memory of the renderer; None where it was not asked for.")
        .def_readonly("reports", &Rendered::reports,
                      "A RenderReport for each band; of an image alone one without sums.")
        .def_property_readonly(
            "spectrum", [](const Rendered& rendered) { return tableOf(rendered.spectrum); },
            "A Table of the sums of the objects over wavenumber; None where it was not asked for.");
}

Pool<SharedRenderer>& renderers() {
    static auto* const pool = new Pool<SharedRenderer>;
    return *pool;
}

} // namespace

void addScenes(py::module_& module) {
    addSensor(module);
    addViewpoint(module);
    addEntity(module);
    addScene(module);
    addOutputs(module);
    addReports(module);
    constexpr const char* renderHelp = R"(Render a view of a scene.

The result is a function of these values alone. The lock of the interpreter is released meanwhile.

Parameters
----------
scene : Scene
    What there is to see.
view : SensorView
    Who looks, and from where.
outputs : Outputs
    What is asked for.

Returns
-------
Rendered
    Its arrays are the renderer's memory, without copies.

Raises
------
InputError
    With everything that is wrong with the scene: codes without entries, bands that spectra do not
    cover, places below the ground, quantities that no atmosphere has.
)";
    py::class_<SharedRenderer>(module, "Renderer", R"(Renders scenes and keeps what views share.

Threads may share one; they then wait for each other. A renderer of its own for each thread renders
at the same time.
)")
        .def(py::init())
        .def(
            "render",
            [](SharedRenderer& self, const Scene& scene, const SensorView& view,
               const Outputs& outputs) {
                return withoutLock([&] { return self.render(scene, view, outputs); });
            },
            py::arg("scene"), py::arg("view"),
            py::arg_v("outputs", Outputs::image(), "Outputs.image()"), renderHelp)
        .def(
            "check",
            [](SharedRenderer& self, const Scene& scene, const SensorView& view,
               const Outputs& outputs) {
                withoutLock([&] {
                    self.with(
                        [&](irsg::Renderer& renderer) { renderer.check(scene, view, outputs); });
                });
            },
            py::arg("scene"), py::arg("view"),
            py::arg_v("outputs", Outputs::image(), "Outputs.image()"),
            "Raise what render() would raise, without rendering.")
        .def(
            "reference_point",
            [](SharedRenderer& self, const Entity& entity) {
                return pointOf(withoutLock([&] {
                    return self.with(
                        [&](irsg::Renderer& renderer) { return renderer.referencePoint(entity); });
                }));
            },
            py::arg("entity"),
            "What a camera looks at: the centre of what is opaque, in model axes, m.")
        .def(
            "description",
            [](SharedRenderer& self, const Scene& scene) {
                return withoutLock([&] {
                    return self.with([&](irsg::Renderer& renderer) {
                        return renderer.rendererDescription(scene);
                    });
                });
            },
            py::arg("scene"), "What renders the scene: OpenGL with its driver, or rays.");
    module.def(
        "render",
        [](const Scene& scene, const SensorView& view, const Outputs& outputs) {
            return withoutLock([&] {
                const Pool<SharedRenderer>::Lease renderer(renderers());
                return renderer->render(scene, view, outputs);
            });
        },
        py::arg("scene"), py::arg("view"),
        py::arg_v("outputs", Outputs::image(), "Outputs.image()"), renderHelp);
}

} // namespace smat::python
