#include "python/inspection_module.h"

#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <array>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "inspection/fit.h"
#include "inspection/rigid.h"

namespace py = pybind11;

namespace evenload {

namespace {

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Numbers = Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1>;

// Contacts as arrays: their points' numbers, sides and multipliers.
template <typename Found>
void add_contacts(py::class_<Found>& into) {
  const auto column = [](auto member) {
    return [member](const Found& found) {
      using Number = std::decay_t<decltype(std::declval<Contact>().*member)>;
      Eigen::Matrix<Number, Eigen::Dynamic, 1> result(
          static_cast<Eigen::Index>(found.contacts.size()));
      for (Eigen::Index i = 0; i < result.size(); ++i)
        result[i] = found.contacts[static_cast<std::size_t>(i)].*member;
      return result;
    };
  };
  into.def_property_readonly("contacts", column(&Contact::point))
      .def_property_readonly("sides", column(&Contact::side))
      .def_property_readonly("multipliers", column(&Contact::multiplier))
      .def_readonly("deviations", &Found::deviations)
      .def_readonly("imbalance", &Found::imbalance)
      .def_readonly("is_proved", &Found::is_proved);
}

FittedFeature fit_for_python(int kind, bool is_minimum_zone, const PointRows& points,
                             bool is_spatial) {
  const py::gil_scoped_release unlocked;
  return fit(static_cast<Kind>(kind),
             is_minimum_zone ? Method::kMinimumZone : Method::kLeastSquares, points.transpose(),
             is_spatial);
}

// (points, their numbers) -> (nearest points, normals), rows of three.
using PythonPart =
    std::function<std::tuple<PointRows, PointRows>(const PointRows&, const Numbers&)>;

Profile profile_for_python(const PointRows& points, const PythonPart& part,
                           const std::array<bool, 6>& is_free, const Eigen::Matrix3d& axes,
                           const Eigen::Vector3d& pivot) {
  const Part asked = [&](const Points& places, const Which& which) {
    const auto [feet, normals] =
        part(places.transpose(),
             Eigen::Map<const Numbers>(which.data(), static_cast<Eigen::Index>(which.size())));
    if (feet.rows() != places.cols() || normals.rows() != places.cols())
      throw std::invalid_argument(
          "The part must answer each point with a nearest point and a normal.");
    return Feet{feet.transpose(), normals.transpose()};
  };
  return profile(points.transpose(), asked, {is_free, axes, pivot});
}

}  // namespace

void bind_inspection(py::module_& module) {
  py::module_ m = module.def_submodule("inspection", "Features and parts through measured points.");
  py::class_<FittedFeature> feature(m, "FittedFeature");
  add_contacts(feature);
  feature.def_readonly("zone", &FittedFeature::zone)
      .def_readonly("point", &FittedFeature::point)
      .def_readonly("direction", &FittedFeature::direction)
      .def_readonly("radius", &FittedFeature::radius);
  m.def("fit", &fit_for_python, py::arg("kind"), py::arg("is_minimum_zone"), py::arg("points"),
        py::arg("is_spatial"));
  py::class_<Profile> profile_class(m, "Profile");
  add_contacts(profile_class);
  profile_class.def_readonly("width", &Profile::width)
      .def_property_readonly("shift", [](const Profile& p) { return p.motion.shift; })
      .def_property_readonly("turn", [](const Profile& p) { return p.motion.turn; });
  m.def("profile", &profile_for_python, py::arg("points"), py::arg("part"), py::arg("is_free"),
        py::arg("axes"), py::arg("pivot"));
}

}  // namespace evenload
