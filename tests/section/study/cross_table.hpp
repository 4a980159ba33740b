// A table that two slides move crosswise, whose workspace is a rectangle:
//
//     base ==X, driven== carriage ==Y, driven== platform
//
// The slides go to +-a and +-b; the frame is 600 mm, so that a + b must not exceed it. `ratio` gears the first: q1 = ratio x.
#pragma once

#include <catch2/catch.hpp>

#include <core/scenario/loaded.hpp>
#include <pmreport/mechanism.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/study/study.hpp>
#include <tests/given/only.hpp>
#include <tests/section/report_words.hpp>

#include <algorithm>
#include <string>

namespace cross_table {

using namespace pmreport;

inline constexpr double frame = 0.6;  // [m]
inline constexpr const char* looks[] = {"plain", "lacquered"};
inline constexpr double marks[] = {0, 0.1};

class CrossTable : public Mechanism<2> {
 public:
  static constexpr const char *name = "cross-table", *title = "cross table", *source = "made for the tests";
  static constexpr Parameter parameters[] = {
      Parameter::number("a", 0.1, {0.01, 0.6}, "m", "mm", "reach along X"),
      Parameter::number("b", 0.1, {0.01, 0.6}, "m", "mm", "reach along Y"),
      Parameter::number("ratio", 1, {0.1, 10}, "", "", "gear of the first slide"),
      Parameter::choice("look", looks, 0, "its colour"),
      Parameter::numbers("marks", marks, {-1, 1}, 2, 4, "m", "mm", "marks on the frame"),
  };
  explicit CrossTable(const Parameters& p) : ratio_(p["ratio"]) {
    const double a = p["a"], b = p["b"];
    if (a + b > frame + 1e-12) throw std::invalid_argument("a and b together are longer than the frame");
    t_.coordinates = {{"x", "along X", "m", 0, {-0.5, 0.5}}, {"y", "along Y", "m", 0, {-0.5, 0.5}}};
    const int carriage = t_.add(Body{"carriage", 1, false, {}});
    t_.platform = t_.add(Body{"table", 0, false, {}});
    const int first = t_.add(Joint{"P1", JointKind::prismatic, 0, carriage, {}});
    const int second = t_.add(Joint{"P2", JointKind::prismatic, carriage, t_.platform, {}});
    t_.add(Actuator{"q1", "first slide", "m", first, {-ratio_ * a, ratio_ * a}});
    t_.add(Actuator{"q2", "second slide", "m", second, {-b, b}});
    t_.constraints.push_back({"force_z", "", "N"});
    for (const char* n : {"couple_x", "couple_y", "couple_z"}) t_.constraints.push_back({n, "", "N*m"});
  }
  Topology topology() const { return t_; }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    const Vector3<T> carriage(q[0], T(0.0), T(0.0)), table(q[0], q[1], T(0.0));
    at.body(1, carriage, Matrix3<T>(Matrix3<T>::Identity()));
    at.body(2, table, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, carriage, Eigen::Vector3d::UnitX().cast<T>());
    at.joint(1, table, Eigen::Vector3d::UnitY().cast<T>());
    at.actuator(0, q[0] * ratio_);
    at.actuator(1, q[1]);
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    Matrix6<T> g = Matrix6<T>::Identity();
    g(0, 0) = T(ratio_);
    return g;
  }

 private:
  double ratio_;
  Topology t_;
};

inline scenario::MechanismSource source() { return test::only<CrossTable>(); }

// Steps of 10 mm from -500 to 500 mm.
inline const std::string grid = R"toml([[section]]
kind = "workspace"
method = "grid"
scan = { x = ["-500 mm", "500 mm", 101], y = ["-500 mm", "500 mm", 101] }
safe = false
pictures = false
exports = false
)toml";

inline std::string text(const std::string& study, const std::string& workspace = grid) {
  return "title = \"Table\"\n[mechanism]\nuse = \"cross-table\"\n" + workspace + "[[section]]\nkind = \"study\"\n" + study;
}

// What the grid counts: of a reach r every step up to it on both sides, and the one in the middle.
inline double counted(double reach) { return 0.01 * (2 * std::floor(std::min(reach, 0.5) / 0.01 + 1e-9) + 1); }

struct Run {
  explicit Run(const std::string& text, const std::filesystem::path& file = "a.toml")
      : loaded(scenario::load_text(text, file, source(), section::kinds())),
        analysis(loaded.scenario, loaded.trajectory, *loaded.machine, analysis::asked_by(loaded.scenario), {}),
        result(section::study_section(analysis, options_of<section::StudyOptions>(loaded.scenario.sections.back()), 1, {})) {}

  std::string words() const { return report_words::text_of(result.section); }
  double value(const std::string& name) const {
    for (const document::Value& v : result.values)
      if (v.name == name) return v.value;
    FAIL("no value " << name);
    return 0;
  }
  const std::vector<double>& column(const std::string& heading) const {
    const document::Data& d = result.data.at(0);
    for (std::size_t i = 0; i < d.columns.size(); ++i)
      if (d.headings[d.words.size() + i] == heading) return d.columns[i];
    FAIL("no column " << heading);
    return d.columns.at(0);
  }
  std::vector<document::Evidence> evidence() const {
    std::vector<document::Evidence> out;
    for (const auto& p : report_words::blocks<document::Proof>(result.section)) out.insert(out.end(), p.lines.begin(), p.lines.end());
    return out;
  }
  std::vector<figure::Figure> figures() const { return report_words::blocks<figure::Figure>(result.section); }

  scenario::Loaded loaded;
  section::Analysis analysis;
  section::Result result;
};

// What is wrong with a scenario, as its user is told.
inline std::string told(const std::string& text, const std::filesystem::path& file = "a.toml") {
  std::string out;
  try {
    (void)scenario::load_text(text, file, source(), section::kinds());
  } catch (const scenario::ScenarioError& e) {
    for (const auto& d : e.diagnostics) out += (out.empty() ? "" : "\n") + to_string(d);
  }
  return out;
}

}  // namespace cross_table
