#include <reports/section/workspace/export_mesh.hpp>
#include <reports/section/workspace/export_npy.hpp>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <bit>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <regex>

using namespace pmreport;
using namespace pmreport::section;
using Eigen::Vector3d;

namespace {

scene::Surface tetrahedron() {
  scene::Surface s;
  s.points = {{0, 0, 0}, {1.25, 0, 0}, {0, 0.1, 0}, {0, 0, -3}};
  s.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return s;
}

template <class T>
T read(const std::string& bytes, std::size_t at) {  // this machine's order, which the test asks to be little endian
  static_assert(std::endian::native == std::endian::little);
  T out;
  REQUIRE(at + sizeof out <= bytes.size());
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return out;
}

}  // namespace

TEST_CASE("a binary STL has its header, its number of triangles, and of each the normal and the corners") {
  const scene::Surface s = tetrahedron();
  const std::string stl = to_stl(s, std::string(200, 't'));
  REQUIRE(stl.size() == 84 + 4 * 50);
  CHECK(!stl.starts_with("solid"));
  CHECK(read<std::uint32_t>(stl, 80) == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t at = 84 + 50 * k;
    Vector3d seen[4];
    for (std::size_t v = 0; v < 4; ++v)
      for (std::size_t i = 0; i < 3; ++i) seen[v](static_cast<int>(i)) = double(read<float>(stl, at + 12 * v + 4 * i));
    for (std::size_t v = 0; v < 3; ++v) {
      const Vector3d& p = s.points[static_cast<std::size_t>(s.triangles[k][v])];
      CHECK((seen[v + 1] - p).norm() < 1e-7 * 4);  // single precision
    }
    CHECK(seen[0].norm() == Approx(1));
    CHECK(std::abs(seen[0].dot(seen[2] - seen[1])) < 1e-6);
    CHECK(std::abs(seen[0].dot(seen[3] - seen[1])) < 1e-6);
    CHECK(seen[0].dot((seen[2] - seen[1]).cross(seen[3] - seen[1])) > 0);
    CHECK(read<std::uint16_t>(stl, at + 48) == 0);
  }
}

TEST_CASE("a PLY says what it has, and has it to the last bit") {
  const scene::Surface s = tetrahedron();
  const std::string ply = to_ply(s, "two\nlines");
  const std::size_t end = ply.find("end_header\n");
  REQUIRE(end != std::string::npos);
  CHECK(ply.starts_with("ply\nformat binary_little_endian 1.0\ncomment two lines\nelement vertex 4\n"));
  CHECK(ply.find("element face 4\nproperty list uchar int vertex_indices\n") < end);
  const std::size_t points = end + 11, faces = points + 4 * 24;
  REQUIRE(ply.size() == faces + 4 * 13);
  for (std::size_t k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(read<double>(ply, points + 24 * k + 8 * i) == s.points[k](static_cast<int>(i)));
    CHECK(ply[faces + 13 * k] == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(read<std::int32_t>(ply, faces + 13 * k + 1 + 4 * i) == s.triangles[k][i]);
  }
}

TEST_CASE("an NPY has its magic, a header that Python reads, and the values in order") {
  const std::vector<std::uint32_t> counts{0, 1, 2, 4'000'000'000U, 5, 6};
  const std::vector<double> numbers{0.1, -1e300};
  const std::string ints = to_npy({2, 3}, counts), doubles = to_npy({2}, numbers);
  for (const auto& [npy, words, size] :
       {std::tuple{&ints, R"(\{'descr': '<u4', 'fortran_order': False, 'shape': \(2, 3\), \} *\n)", std::size_t{24}},
        std::tuple{&doubles, R"(\{'descr': '<f8', 'fortran_order': False, 'shape': \(2,\), \} *\n)", std::size_t{16}}}) {
    CHECK(npy->substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    const std::size_t length = read<std::uint16_t>(*npy, 8);
    CHECK((10 + length) % 64 == 0);
    REQUIRE(npy->size() == 10 + length + size);
    CHECK(std::regex_match(npy->substr(10, length), std::regex(words)));
  }
  for (std::size_t k = 0; k < 6; ++k) CHECK(read<std::uint32_t>(ints, ints.size() - 24 + 4 * k) == counts[k]);
  for (std::size_t k = 0; k < 2; ++k) CHECK(read<double>(doubles, doubles.size() - 16 + 8 * k) == numbers[k]);
  CHECK_THROWS_AS(to_npy({2, 2}, counts), std::invalid_argument);
  CHECK(to_npy({0, 3}, std::vector<double>{}).size() % 64 == 0);
}

TEST_CASE("NumPy itself reads an NPY, where there is one") {
  if (std::system("python3 -c 'import numpy' >/dev/null 2>&1") != 0) return;
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "pmreport-counts-test.npy";
  std::ofstream(file, std::ios::binary) << to_npy({2, 3}, std::vector<std::uint32_t>{1, 2, 3, 4, 5, 4'000'000'000U});
  const std::string script = "import numpy; a = numpy.load(\"" + file.string() +
                             "\"); assert a.shape == (2, 3) and a[0, 2] == 3 and a[1, 2] == 4000000000 and a.dtype == numpy.uint32";
  CHECK(std::system(("python3 -c '" + script + "'").c_str()) == 0);
  std::filesystem::remove(file);
}
