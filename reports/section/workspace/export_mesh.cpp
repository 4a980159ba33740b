#include <reports/section/workspace/export_mesh.hpp>

#include <Eigen/Geometry>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace pmreport::section {

namespace {

// Little endian whatever the machine.
template <class Bits>
void put(std::string& out, Bits bits) {
  for (std::size_t k = 0; k < sizeof bits; ++k) out += static_cast<char>(bits >> (8 * k) & 0xff);
}
void put(std::string& out, float x) { put(out, std::bit_cast<std::uint32_t>(x)); }
void put(std::string& out, double x) { put(out, std::bit_cast<std::uint64_t>(x)); }

void require_countable(std::size_t count) {
  if (count > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("a mesh of more than 2^32 - 1 pieces has no such file");
}

const Eigen::Vector3d& corner(const scene::Surface& surface, const std::array<int, 3>& triangle, std::size_t k) {
  return surface.points[static_cast<std::size_t>(triangle[k])];
}

}  // namespace

// A header that begins with "solid" would be taken for the format in words.
std::string to_stl(const scene::Surface& surface, const std::string& title) {
  require_countable(surface.triangles.size());
  std::string out = "binary STL: " + title;
  out.resize(80, ' ');
  put(out, static_cast<std::uint32_t>(surface.triangles.size()));
  out.reserve(out.size() + 50 * surface.triangles.size());
  for (const auto& t : surface.triangles) {
    const Eigen::Vector3d a = corner(surface, t, 0), b = corner(surface, t, 1), c = corner(surface, t, 2);
    Eigen::Vector3d normal = (b - a).cross(c - a);
    if (const double length = normal.norm(); length > 0) normal /= length;
    for (const Eigen::Vector3d& v : {normal, a, b, c})
      for (int k = 0; k < 3; ++k) put(out, static_cast<float>(v(k)));
    put(out, std::uint16_t{0});
  }
  return out;
}

std::string to_ply(const scene::Surface& surface, const std::string& title) {
  require_countable(surface.points.size());
  std::string comment;
  for (const char c : title) comment += c == '\n' || c == '\r' ? ' ' : c;
  std::string out = "ply\nformat binary_little_endian 1.0\ncomment " + comment + "\nelement vertex " +
                    std::to_string(surface.points.size()) + "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                    std::to_string(surface.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  out.reserve(out.size() + 24 * surface.points.size() + 13 * surface.triangles.size());
  for (const Eigen::Vector3d& p : surface.points)
    for (int k = 0; k < 3; ++k) put(out, p(k));
  for (const auto& t : surface.triangles) {
    out += '\3';
    for (const int k : t) put(out, static_cast<std::uint32_t>(k));
  }
  return out;
}

}  // namespace pmreport::section
