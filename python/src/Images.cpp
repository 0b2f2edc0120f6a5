#include <map>
#include <memory>
#include <optional>
#include <string>

#include "irsg/image/ImageFile.h"
#include "irsg/image/ImageFormat.h"
#include "irsg/image/ImageIntensity.h"
#include "irsg/image/ImageStatistics.h"
#include "irsg/image/PngView.h"
#include "irsg/image/RadianceImage.h"
#include "python/src/Bindings.h"
#include "smatcore/analysis/ImageFiles.h"

namespace smat::python {

namespace {

using irsg::ImageChannel;
using irsg::RadianceImage;
using Image = std::shared_ptr<RadianceImage>;
using Plane = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Planes = std::map<std::string, Plane>;
using Texts = std::map<std::string, std::string>;

const ImageChannel& planeOf(const RadianceImage& image, const std::string& name) {
    return irsg::chosenPlane(image, name, "image");
}

py::array_t<float> arrayOfPlane(const py::object& self, const std::string& name) {
    const RadianceImage& image = *self.cast<Image>();
    return viewOf(std::span<const float>(planeOf(image, name).values), self,
                  {image.height(), image.width()});
}

Image imageOfPlanes(const py::dict& planes, const Texts& units, const Texts& attributes) {
    Image image;
    for (const auto& [key, value] : planes) {
        const auto name = key.cast<std::string>();
        const auto plane = value.cast<Plane>();
        if (plane.ndim() != 2 || plane.size() == 0)
            throw badArgument("planes['" + name + "']",
                              std::to_string(plane.ndim()) + " dimensions",
                              "an array of rows and columns with at least one pixel");
        const auto unit = units.find(name);
        const std::string unitText = unit == units.end() ? "" : unit->second;
        const auto height = static_cast<int>(plane.shape(0));
        const auto width = static_cast<int>(plane.shape(1));
        if (!image)
            image = std::make_shared<RadianceImage>(width, height, name, unitText);
        if (width != image->width() || height != image->height())
            throw badArgument("planes['" + name + "']",
                              std::to_string(width) + " x " + std::to_string(height) + " pixels",
                              "the size of the first plane, " + std::to_string(image->width()) +
                                  " x " + std::to_string(image->height()));
        image->channel(name, unitText).values.assign(plane.data(), plane.data() + plane.size());
    }
    if (!image)
        throw badArgument("planes", "none", "at least one plane");
    image->attributes = attributes;
    irsg::checkPlanes(*image);
    return image;
}

/// Colours and limits that are not asked for are those that the program exports the plane with.
irsg::PngViewOptions viewOptions(const RadianceImage& image, const ImageChannel& plane,
                                 const std::optional<std::string>& colorMap,
                                 const std::optional<std::pair<double, double>>& limits,
                                 bool colorBar, const std::string& title) {
    // Limits that were set are of the plane that was shown.
    Settings display = &plane == &image.primary() ? displayOf(image) : Settings();
    if (colorMap)
        display.set("display.colorMap", *colorMap);
    irsg::PngViewOptions options =
        viewOf(plane, display, {.title = title, .conditions = {}}, "image");
    options.colorBar = colorBar;
    if (limits)
        options.limits = irsg::DisplayLimits{limits->first, limits->second};
    return options;
}

py::array_t<std::uint8_t> pictureOf(const RadianceImage& image, const std::string& plane,
                                    const std::optional<std::string>& colorMap,
                                    const std::optional<std::pair<double, double>>& limits,
                                    bool colorBar, const std::string& title) {
    const ImageChannel& shown = planeOf(image, plane);
    const irsg::Canvas canvas = withoutLock([&] {
        return irsg::renderView(image, shown,
                                viewOptions(image, shown, colorMap, limits, colorBar, title));
    });
    return py::array_t<std::uint8_t>({canvas.height(), canvas.width(), 3}, canvas.bytes().data());
}

py::dict statisticsOf(const RadianceImage& image, const std::string& plane) {
    const irsg::ImageStatistics found =
        withoutLock([&] { return irsg::imageStatistics(image, planeOf(image, plane)); });
    py::dict all;
    all["finite"] = found.finite;
    all["nan"] = found.nan;
    all["minimum"] = found.minimum;
    all["maximum"] = found.maximum;
    all["sum"] = found.sum;
    all["mean"] = found.mean;
    all["standard_deviation"] = found.standardDeviation;
    all["median"] = found.median;
    return all;
}

} // namespace

void addImages(py::module_& module) {
    py::class_<RadianceImage, Image>(module, "Image", R"(An image in physical units.

Planes by name, the first the one that is shown ('L', radiance in W m-2 sr-1, of an image that was
rendered), and attributes that say how it came to be. Row 0 is the top row.

Parameters
----------
planes : dict of str to array_like, shape (height, width)
    Values, 32-bit float; copied.
units : dict of str to str, optional
    Units by plane, such as 'W m-2 sr-1'.
attributes : dict of str to str, optional
    What else is known.

Raises
------
InputError
    Without a plane, and for planes of different sizes.
)")
        .def(py::init(&imageOfPlanes), py::arg("planes"), py::arg("units") = Texts(),
             py::arg("attributes") = Texts())
        .def_static(
            "load",
            [](const std::filesystem::path& file) {
                return withoutLock(
                    [&] { return std::make_shared<RadianceImage>(irsg::readImageFile(file)); });
            },
            py::arg("file"),
            R"(Read an image by its content: OpenEXR, TIFF, CSV, ENVI, NumPy and others.

Raises
------
InputError
    For a file that holds no image of values, with what it is instead.
)")
        .def(
            "save",
            [](const RadianceImage& image, const std::filesystem::path& file) {
                withoutLock([&] { saveImage(image, displayOf(image), {}, "image", file); });
            },
            py::arg("file"),
            R"(Write the image in the form of the extension: .exr with all planes and attributes.

A .png is the picture that the program exports: colours and limits are those of the settings
`display` that the image was calculated with, or their defaults.

Raises
------
InputError
    For another extension, listing those there are, and where the file cannot be written.
)")
        .def_property_readonly("width_px", &RadianceImage::width, "Columns.")
        .def_property_readonly("height_px", &RadianceImage::height, "Rows.")
        .def_property_readonly(
            "shape",
            [](const RadianceImage& image) {
                return py::make_tuple(image.height(), image.width());
            },
            "Rows and columns.")
        .def_property_readonly(
            "planes",
            [](const RadianceImage& image) {
                std::vector<std::string> names;
                for (const ImageChannel& plane : image.channels)
                    names.push_back(plane.name);
                return names;
            },
            "Names of the planes, the shown one first.")
        .def_property_readonly(
            "units",
            [](const RadianceImage& image) {
                py::dict units;
                for (const ImageChannel& plane : image.channels)
                    units[py::str(plane.name)] = plane.unit;
                return units;
            },
            "Units by plane.")
        .def_property_readonly(
            "attributes", [](const RadianceImage& image) { return image.attributes; },
            "What the image says of itself: band, geometry, settings, renderer.")
        .def("plane", &arrayOfPlane, py::arg("name") = "",
             R"(Values of a plane, without a copy.

Parameters
----------
name : str
    One of `planes`; '' for the only plane, one shown in place of radiance, or 'L'.

Returns
-------
numpy.ndarray, shape (height, width), float32
    Read-only; it keeps the image.

Raises
------
InputError
    For a plane that is not there, listing those that are.
)")
        .def("__getitem__", &arrayOfPlane, py::arg("name"), "The values of a plane, as plane().")
        .def(
            "__array__",
            [](const py::object& self, const py::object& dtype, const py::object& copy) {
                const RadianceImage& image = *self.cast<Image>();
                const py::object array = arrayOfPlane(self, image.primary().name);
                const py::object numpy = py::module_::import("numpy");
                if (!copy.is_none() && copy.cast<bool>())
                    return py::object(numpy.attr("array")(array, dtype));
                return py::object(numpy.attr("asarray")(array, dtype));
            },
            py::arg("dtype") = py::none(), py::arg("copy") = py::none(),
            "The shown plane, for numpy.asarray(image).")
        .def("picture", &pictureOf, py::arg("plane") = "", py::arg("color_map") = py::none(),
             py::arg("limits") = py::none(), py::arg("color_bar") = true, py::arg("title") = "",
             R"(The plane in false colours.

Parameters
----------
plane : str
    One of `planes`; '' for the shown one.
color_map : str, optional
    'white-hot', 'black-hot', 'ironbow', 'inferno', 'viridis' or 'diverging'; without, that of the
    settings the image was calculated with, or 'white-hot'.
limits : (float, float), optional
    Values of the first and the last colour, linear between; without, those of the same settings, or
    limits and scale that show the object and its background.
color_bar : bool
    Whether ticks, unit and title stand around the picture.
title : str
    A line above.

Returns
-------
numpy.ndarray, shape (rows, columns, 3), uint8
    sRGB.

Raises
------
InputError
    For an unknown colour map, and for limits that do not ascend.
)")
        .def(
            "_repr_png_",
            [](const RadianceImage& image) {
                const py::object picture = pictureOf(image, image.primary().name, {}, {}, true, "");
                return py::module_::import("smat._png").attr("png_bytes")(picture);
            },
            "The picture with its colour bar as PNG, for notebooks.")
        .def("statistics", &statisticsOf, py::arg("plane") = "",
             R"(What the finite values of a plane are like.

Returns
-------
dict
    finite, nan (counts), minimum, maximum, sum, mean, standard_deviation (divided by n), median.
)")
        .def(
            "contrast_intensity",
            [](const RadianceImage& image, const std::string& plane) {
                return irsg::contrastIntensity_W_sr(image, planeOf(image, plane));
            },
            py::arg("plane") = "",
            "Contrast intensity of a plane of radiance, W sr-1, from its pixels; None where the "
            "image does not know its geometry.")
        .def("__eq__", [](const RadianceImage& a, const RadianceImage& b) { return a == b; })
        .def("__eq__", [](const RadianceImage&, const py::object&) { return false; })
        .def("__repr__",
             [](const RadianceImage& image) {
                 return "Image of " + std::to_string(image.width()) + " x " +
                        std::to_string(image.height()) + " px: " + irsg::channelList(image);
             })
        .def(py::pickle(
            [](const py::object& self) {
                py::dict planes;
                const RadianceImage& image = *self.cast<Image>();
                for (const ImageChannel& plane : image.channels)
                    planes[py::str(plane.name)] = arrayOfPlane(self, plane.name);
                return py::make_tuple(planes, self.attr("units"), image.attributes);
            },
            [](const py::tuple& state) {
                return imageOfPlanes(state[0].cast<py::dict>(), state[1].cast<Texts>(),
                                     state[2].cast<Texts>());
            }))
        .attr("__hash__") = py::none();
}

} // namespace smat::python
