#pragma once

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

/// What all parts of the Python module share. Python sees poses as 4 x 4 matrices, choices as text,
/// errors as `scanfuse.Error`.
namespace scanfuse::python {

namespace py = pybind11;

/// A failed Result on its way to Python, where it is `scanfuse.Error` with the same text.
struct Failure : std::runtime_error {
  explicit Failure(const Error& error) : std::runtime_error(error.message) {}
};

template <class T>
T value_or_throw(Result<T>&& result) {
  if (!result) throw Failure(result.error());
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

inline Eigen::Matrix4d matrix_of(const Pose3& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = pose.rotation.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = pose.translation_m;
  return matrix;
}

/// A matrix that is no rigid transform is an error: a typo must not become another pose.
inline Pose3 pose_of(const Eigen::Matrix4d& matrix) {
  const Eigen::Matrix3d rotation = matrix.topLeftCorner<3, 3>();
  const bool rigid =
      matrix.allFinite() && matrix.row(3) == Eigen::RowVector4d(0, 0, 0, 1) &&
      (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <
          1e-6 &&
      rotation.determinant() > 0;
  if (!rigid) {
    throw Failure({Error::Code::kMalformed,
                   "a pose is a 4 x 4 matrix of a rotation and a translation; this is none"});
  }
  return {Eigen::Quaterniond(rotation).normalized(), matrix.topRightCorner<3, 1>()};
}

/// {"ego pose extrapolated": (3, "at 12.5 s", False)}: count, where first, whether input was lost.
inline py::dict dict_of(const Diagnostics& diagnostics) {
  py::dict dict;
  for (const auto& [what, entry] : diagnostics.entries()) {
    dict[py::str(what)] = py::make_tuple(entry.count, entry.first, entry.damage);
  }
  return dict;
}

inline py::dict dict_of(const OptionView& view) {
  return py::dict(py::arg("name") = view.name, py::arg("value") = view.value,
                  py::arg("default") = view.fallback, py::arg("range") = view.range,
                  py::arg("doc") = view.doc);
}

inline Time time_of(double seconds) {
  if (!(std::abs(seconds) < 9e9)) {
    throw Failure({Error::Code::kOutOfRange,
                   fmt::format("{} s is no time: seconds since 1970 are wanted", seconds)});
  }
  return time_from_seconds(seconds);
}

/// A vector that lives in `owner` as an array that shares its memory; its elements' type is known
/// to numpy by PYBIND11_NUMPY_DTYPE. Read-only: the owner's invariants stay true.
template <class T>
py::array_t<T> view_of(const std::vector<T>& values, py::handle owner) {
  py::array_t<T> array(static_cast<py::ssize_t>(values.size()), values.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// The same of one number of each element, or of three that follow each other (shape (N, 3)).
template <class Number, class T>
py::array_t<Number> column_of(const std::vector<T>& values, const Number* first, py::handle owner,
                              py::ssize_t width = 1) {
  const auto rows = static_cast<py::ssize_t>(values.size());
  const auto stride = static_cast<py::ssize_t>(sizeof(T));
  const auto step = static_cast<py::ssize_t>(sizeof(Number));
  using Sizes = std::vector<py::ssize_t>;
  auto array = width == 1
                   ? py::array_t<Number>(Sizes{rows}, Sizes{stride}, first, owner)
                   : py::array_t<Number>(Sizes{rows, width}, Sizes{stride, step}, first, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class T>
py::array_t<T> array_of(const std::vector<T>& values) {
  return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

/// Sets an option from what Python gives: numbers, truth values, text.
template <class Options>
void set_from_python(Options& options, const std::string& name, const py::handle& value) {
  std::string text;
  if (py::isinstance<py::bool_>(value)) {
    text = value.cast<bool>() ? "true" : "false";
  } else if (py::isinstance<py::float_>(value)) {
    text = detail::print(value.cast<double>());
  } else {
    text = py::str(value);
  }
  value_or_throw(set_option(options, name, text));
}

/// An option struct as a Python class: one attribute a field, with its doc and range; what is out
/// of range or unknown is an error with the text of `--set`.
template <class Options>
py::class_<Options> bind_options(py::module_& module, const char* name, const char* doc) {
  py::class_<Options> bound(module, name, doc);
  bound.def(py::init([](const py::kwargs& values) {
    Options options;
    for (const auto& [key, value] : values) set_from_python(options, py::str(key), value);
    return options;
  }));
  std::apply(
      [&](const auto&... field) {
        (
            [&] {
              const std::string range = detail::range_text(field.low, field.high);
              const std::string text =
                  std::string(field.doc) + (range.empty() ? "" : " [" + range + "]");
              bound.def_property_readonly(
                  std::string(field.name).c_str(),
                  [member = field.member](const Options& options) {
                    using T = std::decay_t<decltype(options.*member)>;
                    if constexpr (Choice<T>) {
                      return detail::print(options.*member);
                    } else {
                      return options.*member;
                    }
                  },
                  text.c_str());
            }(),
            ...);
      },
      Options::fields());
  bound.def("__setattr__", [](const py::object& self, const py::str& key, const py::object& value) {
    set_from_python(self.cast<Options&>(), key, value);
  });
  bound.def("__copy__", [](const Options& options) { return options; });
  bound.def("__deepcopy__", [](const Options& options, const py::dict&) { return options; });
  bound.def("__repr__", [name = std::string(name)](const Options& options) {
    std::string text = name + "(";
    for (const auto& view : view_options("", options)) {
      text += fmt::format("{}{}={}{}{}", text.back() == '(' ? "" : ", ", view.name,
                          view.quoted ? "'" : "", view.value, view.quoted ? "'" : "");
    }
    return text + ")";
  });
  bound.def(
      "describe",
      [](const Options& options) {
        py::list rows;
        for (const auto& view : view_options("", options)) {
          rows.append(dict_of(view));
        }
        return rows;
      },
      "Every option: name, value, default, range and doc, all as text.");
  return bound;
}

// The parts of the module, in this order.
void bind_data(py::module_& module);
void bind_results(py::module_& module);
void bind_chain(py::module_& module);
void bind_files(py::module_& module);
void bind_scoring(py::module_& module);
void bind_passive(py::module_& module);
void bind_turntable(py::module_& module);

}  // namespace scanfuse::python
