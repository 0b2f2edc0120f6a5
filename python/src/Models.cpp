#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "irsg/geometry/mesh/Mesh.h"
#include "irsg/geometry/model/Model.h"
#include "python/src/Bindings.h"

namespace smat::python {

namespace {

using irsg::Mesh;
using irsg::Model;

/// A part of a mesh, which it keeps.
struct MeshPart {
    std::shared_ptr<const Mesh> mesh;
    std::size_t number = 0;

    const Mesh::Part& operator*() const { return mesh->parts[number]; }
    const Mesh::Part* operator->() const { return &**this; }
};

py::array_t<float> triplesOf(const std::vector<irsg::Float3>& triples, const py::object& owner) {
    const float* first = triples.empty() ? nullptr : triples.front().data();
    return viewOf(std::span<const float>(first, 3 * triples.size()), owner,
                  {static_cast<py::ssize_t>(triples.size()), 3});
}

void addMeshPart(py::module_& module) {
    py::class_<MeshPart>(module, "MeshPart",
                         "The triangles of a model that carry one pair of codes.")
        .def_property_readonly(
            "temperature_index", [](const MeshPart& part) { return part->codes.temperature; },
            "The code that a temperature entry stands behind.")
        .def_property_readonly(
            "material_index", [](const MeshPart& part) { return part->codes.material; },
            "The code that a material stands behind.")
        .def_property_readonly(
            "vertices_m",
            [](const py::object& self) {
                return triplesOf(self.cast<const MeshPart&>()->vertices, self);
            },
            "Vertices in model axes (x starboard, y nose, z up), m, shape (n, 3). Read-only, not a "
            "copy.")
        .def_property_readonly(
            "normals",
            [](const py::object& self) {
                return triplesOf(self.cast<const MeshPart&>()->normals, self);
            },
            "Unit normals of the vertices, shape (n, 3). Read-only, not a copy.")
        .def_property_readonly(
            "triangles",
            [](const py::object& self) {
                const std::vector<unsigned>& triangles = self.cast<const MeshPart&>()->triangles;
                return viewOf(std::span<const unsigned>(triangles), self,
                              {static_cast<py::ssize_t>(triangles.size() / 3), 3});
            },
            "Numbers of the vertices of each triangle, counter-clockwise from the front, shape "
            "(m, 3). Read-only, not a copy.")
        .def_property_readonly(
            "area_m2", [](const MeshPart& part) { return part->area_m2; }, "Area, m2.");
}

} // namespace

void addModels(py::module_& module) {
    addMeshPart(module);
    py::class_<Model, std::shared_ptr<Model>>(module, "Model",
                                              R"(A model: its mesh with infrared codes.

Parameters
----------
file : str or os.PathLike
    .flt, .osgt, .osgb, .ive, .obj, .ply, .stl, .gltf and others, read in a process of its own.
unit_m : float, optional
    What one unit of the file is, m; without, as the file states it.

Raises
------
InputError
    For a file that is missing, damaged, unreadable or without faces.
)")
        .def(py::init([](const std::filesystem::path& file, std::optional<double> unit_m) {
                 irsg::ModelOptions options;
                 options.placing.unit_m = unit_m;
                 return withoutLock([&] { return Model::load(file, options); });
             }),
             py::arg("file"), py::kw_only(), py::arg("unit_m") = py::none())
        .def_property_readonly("name", &Model::name, "The name of its file.")
        .def_property_readonly("file", &Model::file, "Its file.")
        .def_property_readonly(
            "bounds_m",
            [](const Model& model) {
                const irsg::BoundingBox& box = model.bounds();
                return arrayOf<double>(
                           {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z})
                    .reshape({2, 3});
            },
            "Least and largest corner in model axes, m, shape (2, 3).")
        .def_property_readonly(
            "parts",
            [](const Model& model) {
                std::vector<MeshPart> parts;
                for (std::size_t i = 0; i < model.mesh()->parts.size(); ++i)
                    parts.push_back({model.mesh(), i});
                return parts;
            },
            "The triangles, a MeshPart for each kind of surface.")
        .def_property_readonly(
            "facets", [](const Model& model) { return model.mesh()->facets(); },
            "How many triangles there are.")
        .def_property_readonly("remarks", &Model::remarks,
                               "What the reader had to do or could not keep.")
        .def("__repr__",
             [](const Model& model) {
                 return "Model " + model.name() + " of " + std::to_string(model.mesh()->facets()) +
                        " triangles";
             })
        .def(py::pickle(
            [](const Model& model) {
                return py::make_tuple(std::filesystem::absolute(model.file()),
                                      model.placing().unit_m);
            },
            [](const py::tuple& state) {
                irsg::ModelOptions options;
                options.placing.unit_m = state[1].cast<std::optional<double>>();
                return Model::load(state[0].cast<std::filesystem::path>(), options);
            }));
}

} // namespace smat::python
