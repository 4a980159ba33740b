// What the compiler says to the author of a mechanism who writes for numbers what must do for scalars.
#include <catch2/catch.hpp>
#include <tests/program/workshop.hpp>

using namespace program_test;
using Catch::Contains;

namespace {

// The end of a limb by `expression` of v, a vector of scalars, on every scalar that the program uses.
Result compile(const Workshop& here, const std::string& statement) {
  here.write("limb.cpp",
             "#include <pmreport/mechanism.hpp>\n"
             "using namespace pmreport;\n"
             "template <class T>\n"
             "Vector3<T> limb(const Vector3<T>& v) {\n" +
                 statement +
                 "\n}\n"
                 "template <class... T>\n"
                 "void on_all() { (limb(Vector3<T>(T(1.0), T(2.0), T(3.0))), ...); }\n"
                 "template void on_all<double, long double, Lanes, Jet<double>, Jet<Lanes>, Partials<double, 3>, Partials<Lanes, 3>>();\n");
  return run({CXX, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-I", SOURCE "/core", "-isystem", EIGEN, "limb.cpp"},
             {.folder = here.path()});
}

}  // namespace

TEST_CASE("length, unit and choose do on every scalar, and so do Eigen's own on plain numbers") {
  const Workshop here;
  const Result r = compile(
      here, "return v * length(v) + unit(v) * choose(v(0) < 0.0 && !(v(1) > 1.0), v(2), T(1.0)) * Eigen::Vector3d(1, 2, 2).norm();");
  INFO(r.err);
  CHECK(r.status == 0);
}

TEST_CASE("Eigen's norm and normalized on a scalar, and an if, are one error that says what to write, and where") {
  for (const char* statement : {"return v.normalized();", "return v * v.norm();", "if (v(0) < 0.0) return -v; return v;"}) {
    const Workshop here;
    const Result r = compile(here, statement);
    INFO(statement << '\n' << r.err);
    CHECK(r.status != 0);
    CHECK(count_of(r.err, "error:") == 1);
    CHECK_THAT(r.err, Contains("length(v) for v.norm()") && Contains("unit(v) for v.normalized()") && Contains("choose(mask, a, b)"));
    CHECK_THAT(r.err, Contains("limb.cpp:5:"));  // the line of the statement
  }
}
