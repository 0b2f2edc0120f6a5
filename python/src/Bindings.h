#pragma once

#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "irsg/core/Errors.h"
#include "irsg/core/Remarks.h"

namespace smat::python {

namespace py = pybind11;

/// Each adds its classes and functions to the module `smat._core`; in this order, as later ones
/// take values of earlier ones.
void addErrors(py::module_& module);
void addRadiometry(py::module_& module);
void addImages(py::module_& module);
void addTables(py::module_& module);
void addAtmospheres(py::module_& module);
void addModels(py::module_& module);
void addSignatures(py::module_& module);
void addScenes(py::module_& module);
void addProjects(py::module_& module);

/// An InputError about an argument of a Python function.
inline irsg::InputError badArgument(std::string argument, std::string value, std::string expected) {
    return irsg::InputError(irsg::Diagnostic{.file = std::move(argument),
                                             .position = "",
                                             .value = std::move(value),
                                             .expected = std::move(expected)});
}

/// Issues each sentence as a Python warning (smat.SmatWarning). Throws where the user has made
/// warnings errors.
void warnOf(const std::vector<std::string>& sentences);

/// Does work without the lock of the interpreter and warns of what readers remarked meanwhile.
template <typename Work>
auto withoutLock(const Work& work) {
    const irsg::CollectedRemarks remarks;
    const auto unlocked = [&] {
        const py::gil_scoped_release release;
        return work();
    };
    if constexpr (std::is_void_v<decltype(work())>) {
        unlocked();
        warnOf(remarks.sentences());
    } else {
        auto result = unlocked();
        warnOf(remarks.sentences());
        return result;
    }
}

/// Numbers in memory of ours as a read-only array of that shape, without a copy. `owner` is the
/// Python object that keeps them.
template <typename Number>
py::array_t<Number> viewOf(std::span<const Number> numbers, const py::object& owner,
                           std::vector<py::ssize_t> shape) {
    py::array_t<Number> array(std::move(shape), numbers.data(), owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}
template <typename Number>
py::array_t<Number> viewOf(const std::vector<Number>& numbers, const py::object& owner) {
    return viewOf(std::span<const Number>(numbers), owner,
                  {static_cast<py::ssize_t>(numbers.size())});
}

/// An array that owns its numbers.
template <typename Number>
py::array_t<Number> arrayOf(const std::vector<Number>& numbers) {
    return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

/// The numbers of an array of one dimension.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
inline std::vector<double> vectorOf(const Numbers& array, const char* argument) {
    if (array.ndim() != 1)
        throw badArgument(argument, std::to_string(array.ndim()) + " dimensions", "one dimension");
    return {array.data(), array.data() + array.size()};
}

} // namespace smat::python
