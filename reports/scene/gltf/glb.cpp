#include <reports/scene/gltf/glb.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>

namespace pmreport::scene {

namespace {

using Json = nlohmann::ordered_json;

// Numbers of the format.
enum ComponentType { unsigned_short = 5123, unsigned_int = 5125, float32 = 5126 };
enum Target { of_vertices = 34962, of_indices = 34963, of_keys = 0 };
constexpr std::uint32_t magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;  // "glTF", "JSON", "BIN\0"
constexpr std::size_t header_size = 12, chunk_header_size = 8;

// Little endian whatever the machine.
template <class Bits>
void put(std::string& out, Bits bits) {
  for (std::size_t k = 0; k < sizeof bits; ++k) out += static_cast<char>(bits >> (8 * k) & 0xff);
}
void put(std::string& out, float x) { put(out, std::bit_cast<std::uint32_t>(x)); }

void pad(std::string& out, char with) { out.resize((out.size() + 3) / 4 * 4, with); }

// Every accessor has a view of its own: no strides, and each begins at a multiple of four bytes.
class Buffer {
 public:
  // `rows` of `width` floats each; with the bounds of each column where the format asks for them.
  int add(const std::vector<float>& numbers, std::size_t width, Target target, bool bounded) {
    const std::size_t first = bytes_.size();
    for (const float x : numbers) put(bytes_, x);
    constexpr const char* types[] = {"", "SCALAR", "", "VEC3", "VEC4"};
    Json accessor{
        {"bufferView", close(first, target)}, {"componentType", float32}, {"count", numbers.size() / width}, {"type", types[width]}};
    if (bounded) {
      Json low = Json::array(), high = Json::array();
      for (std::size_t column = 0; column < width; ++column) {
        float least = numbers[column], most = least;
        for (std::size_t k = column; k < numbers.size(); k += width) least = std::min(least, numbers[k]), most = std::max(most, numbers[k]);
        low.push_back(static_cast<double>(least)), high.push_back(static_cast<double>(most));
      }
      accessor["min"] = std::move(low), accessor["max"] = std::move(high);
    }
    return keep(std::move(accessor));
  }

  // The largest number of a type is no index: it may mean something else to a renderer.
  int add(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
    const bool small = vertices <= std::numeric_limits<std::uint16_t>::max();
    const std::size_t first = bytes_.size();
    for (const std::uint32_t i : indices) small ? put(bytes_, static_cast<std::uint16_t>(i)) : put(bytes_, i);
    return keep({{"bufferView", close(first, of_indices)},
                 {"componentType", small ? unsigned_short : unsigned_int},
                 {"count", indices.size()},
                 {"type", "SCALAR"}});
  }

  const std::string& bytes() const { return bytes_; }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }

 private:
  std::size_t close(std::size_t first, Target target) {
    Json view{{"buffer", 0}, {"byteOffset", first}, {"byteLength", bytes_.size() - first}};
    if (target != of_keys) view["target"] = target;
    views_.push_back(std::move(view));
    pad(bytes_, '\0');
    return views_.size() - 1;
  }
  int keep(Json accessor) {
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

std::vector<float> flat(const std::vector<std::array<float, 3>>& rows) {
  std::vector<float> out;
  for (const auto& row : rows) out.insert(out.end(), row.begin(), row.end());
  return out;
}
std::vector<float> flat(const std::vector<Eigen::Vector3d>& rows) {
  std::vector<float> out;
  for (const Eigen::Vector3d& v : rows)
    for (const double x : v) out.push_back(static_cast<float>(x));
  return out;
}
std::vector<float> flat(const std::vector<Eigen::Quaterniond>& rows) {
  std::vector<float> out;
  for (const Eigen::Quaterniond& q : rows)
    for (const double x : q.coeffs()) out.push_back(static_cast<float>(x));  // x y z w, as Eigen has them
  return out;
}

Json list(const Eigen::Ref<const Eigen::VectorXd>& v) {
  Json out = Json::array();
  for (const double x : v) out.push_back(static_cast<double>(static_cast<float>(x)) + 0.0);  // as the keys have it; no -0
  return out;
}

// Materials are in linear light. Four digits are more than eight bits of sRGB hold.
double linear(float srgb) {
  const double x = srgb, light = x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  return std::round(1e4 * light) / 1e4;
}

// Painted metal, as the pictures suggest it: more light than mirror.
Json material(const Color& c) {
  Json out{{"pbrMetallicRoughness",
            {{"baseColorFactor", {linear(c.r), linear(c.g), linear(c.b), static_cast<double>(c.a)}},
             {"metallicFactor", 0.1},
             {"roughnessFactor", 0.55}}}};
  if (c.a < 1) out["alphaMode"] = "BLEND", out["doubleSided"] = true;
  return out;
}

class Writer {
 public:
  explicit Writer(const Model& model) : model_(model) {
    add_meshes();
    add_nodes();
    if (!model.tracks.empty()) add_animation();
  }

  std::string bytes() {
    Json out{{"asset", {{"version", "2.0"}, {"generator", "pmreport"}}}, {"scene", 0}};
    out["scenes"] = {{{"name", model_.name}, {"nodes", {0}}}};
    out["nodes"] = std::move(nodes_);
    if (!meshes_.empty()) out["meshes"] = std::move(meshes_), out["materials"] = std::move(materials_);
    if (!animations_.empty()) out["animations"] = std::move(animations_);
    std::string binary = buffer_.bytes();
    if (!binary.empty()) {
      out["accessors"] = buffer_.accessors();
      out["bufferViews"] = buffer_.views();
      out["buffers"] = {{{"byteLength", binary.size()}}};
    }
    std::string json = out.dump(-1, ' ', false, Json::error_handler_t::replace);
    pad(json, ' ');
    const std::size_t size = header_size + chunk_header_size + json.size() + (binary.empty() ? 0 : chunk_header_size + binary.size());
    if (size > std::numeric_limits<std::uint32_t>::max()) throw std::length_error("a model of more than 4 GiB has no such file");
    std::string glb;
    glb.reserve(size);
    put(glb, magic), put(glb, std::uint32_t{2}), put(glb, static_cast<std::uint32_t>(size));
    put(glb, static_cast<std::uint32_t>(json.size())), put(glb, json_chunk);
    glb += json;
    if (!binary.empty()) put(glb, static_cast<std::uint32_t>(binary.size())), put(glb, binary_chunk), glb += binary;
    return glb;
  }

 private:
  int material_of(const Color& c) {
    const auto [at, is_new] = material_at_.try_emplace({c.r, c.g, c.b, c.a}, static_cast<int>(materials_.size()));
    if (is_new) materials_.push_back(material(c));
    return at->second;
  }

  // Legs of one make differ in colour alone: their shape stands once.
  struct Shape {
    const Primitive* of;
    int positions, normals, indices;  // accessors
  };
  Shape shape_of(const Primitive& p) {
    for (const Shape& s : shapes_)
      if (s.of->positions == p.positions && s.of->normals == p.normals && s.of->indices == p.indices) return s;
    const int positions = buffer_.add(flat(p.positions), 3, of_vertices, true),
              normals = buffer_.add(flat(p.normals), 3, of_vertices, false);
    shapes_.push_back({&p, positions, normals, buffer_.add(p.indices, p.positions.size())});
    return shapes_.back();
  }

  void add_meshes() {
    for (const std::vector<Primitive>& mesh : model_.meshes) {
      Json primitives = Json::array();
      for (const Primitive& p : mesh) {
        const Shape s = shape_of(p);
        primitives.push_back({{"attributes", {{"POSITION", s.positions}, {"NORMAL", s.normals}}},
                              {"indices", s.indices},
                              {"material", material_of(p.color)}});
      }
      meshes_.push_back({{"primitives", std::move(primitives)}});
    }
  }

  // Node 0 is the root, node k + 1 the model's node k.
  void add_nodes() {
    Json children = Json::array();
    for (std::size_t k = 0; k < model_.nodes.size(); ++k) children.push_back(k + 1);
    // A quarter turn about -x: (x, y, z) becomes (x, z, -y).
    constexpr double half = 1 / std::numbers::sqrt2;
    Json root{{"name", model_.name}, {"rotation", list(Eigen::Vector4d(-half, 0, 0, half))}};
    if (!children.empty()) root["children"] = std::move(children);
    nodes_.push_back(std::move(root));
    for (std::size_t k = 0; k < model_.nodes.size(); ++k) {
      const ModelNode& n = model_.nodes[k];
      Json node{{"name", n.name}};
      if (static_cast<int>(k) == model_.platform) node["extras"] = {{"platform", true}};
      if (n.mesh >= 0) node["mesh"] = n.mesh;
      node["translation"] = list(n.translation), node["rotation"] = list(n.rotation.coeffs());
      nodes_.push_back(std::move(node));
    }
  }

  void add_animation() {
    const int input = buffer_.add(model_.times, 1, of_keys, true);
    Json samplers = Json::array(), channels = Json::array();
    const auto add = [&](int node, const char* path, int output) {
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node + 1}, {"path", path}}}});
      samplers.push_back({{"input", input}, {"interpolation", "LINEAR"}, {"output", output}});
    };
    for (const ModelTrack& track : model_.tracks) {
      add(track.node, "translation", buffer_.add(flat(track.translation), 3, of_keys, false));
      add(track.node, "rotation", buffer_.add(flat(track.rotation), 4, of_keys, false));
    }
    Json animation{{"name", "motion"}, {"channels", std::move(channels)}, {"samplers", std::move(samplers)}};
    if (model_.begin != 0) animation["extras"] = {{"begin", model_.begin}};
    animations_.push_back(std::move(animation));
  }

  const Model& model_;
  Buffer buffer_;
  Json meshes_ = Json::array(), materials_ = Json::array(), nodes_ = Json::array(), animations_ = Json::array();
  std::map<std::array<float, 4>, int> material_at_;
  std::vector<Shape> shapes_;
};

}  // namespace

bool Primitive::operator==(const Primitive& other) const {
  const auto told = [](const Color& c) { return std::array{c.r, c.g, c.b, c.a}; };
  return told(color) == told(other.color) && positions == other.positions && normals == other.normals && indices == other.indices;
}

std::string to_glb(const Model& model) { return Writer(model).bytes(); }

}  // namespace pmreport::scene
