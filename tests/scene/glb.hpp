// Reads binary glTF as the format's text has it, with nothing of the code that writes it.
#pragma once

#include <catch2/catch.hpp>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace glb {

struct File {
  nlohmann::json json;
  std::string binary;

  explicit File(const std::string& bytes) {
    const auto word = [&](std::size_t at) {
      std::uint32_t out = 0;
      for (std::size_t k = 0; k < 4; ++k) out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + k))) << (8 * k);
      return out;
    };
    REQUIRE(bytes.substr(0, 4) == "glTF");
    REQUIRE(word(4) == 2);
    REQUIRE(word(8) == bytes.size());
    const std::size_t length = word(12);
    REQUIRE(length % 4 == 0);
    REQUIRE(bytes.substr(16, 4) == "JSON");
    REQUIRE(20 + length <= bytes.size());
    json = nlohmann::json::parse(bytes.substr(20, length));
    if (20 + length == bytes.size()) return;
    const std::size_t rest = word(20 + length);
    REQUIRE(rest % 4 == 0);
    REQUIRE(bytes.substr(24 + length, 4) == std::string("BIN\0", 4));
    REQUIRE(28 + length + rest == bytes.size());
    binary = bytes.substr(28 + length);
    REQUIRE(json["buffers"].size() == 1);
    REQUIRE(json["buffers"][0]["byteLength"] == binary.size());
    for (const auto& view : json["bufferViews"]) {
      REQUIRE(view["byteOffset"].get<std::size_t>() % 4 == 0);
      REQUIRE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>() <= binary.size());
    }
    for (std::size_t k = 0; k < json["accessors"].size(); ++k) {
      const auto& a = json["accessors"][k];
      const std::size_t size = a["componentType"] == 5123 ? 2 : 4;
      REQUIRE(json["bufferViews"].at(a["bufferView"].get<std::size_t>())["byteLength"] == size * width(k) * a["count"].get<std::size_t>());
    }
  }

  std::size_t width(std::size_t accessor) const {
    const std::string type = json["accessors"].at(accessor)["type"];
    return type == "SCALAR" ? 1 : type == "VEC3" ? 3 : 4;
  }

  // Rows of an accessor, one after the other.
  std::vector<double> numbers(std::size_t accessor) const {
    const auto& a = json["accessors"].at(accessor);
    const int type = a["componentType"];
    std::vector<double> out;
    const std::size_t from = json["bufferViews"][a["bufferView"].get<std::size_t>()]["byteOffset"];
    for (std::size_t k = 0; k < width(accessor) * a["count"].get<std::size_t>(); ++k) {
      if (type == 5126) {
        float x;
        std::memcpy(&x, binary.data() + from + 4 * k, 4);
        out.push_back(static_cast<double>(x));
      } else if (type == 5125) {
        std::uint32_t x;
        std::memcpy(&x, binary.data() + from + 4 * k, 4);
        out.push_back(x);
      } else {
        REQUIRE(type == 5123);
        std::uint16_t x;
        std::memcpy(&x, binary.data() + from + 2 * k, 2);
        out.push_back(x);
      }
    }
    return out;
  }

  const nlohmann::json& node(const std::string& name) const {
    for (const auto& n : json["nodes"])
      if (n["name"] == name) return n;
    throw std::out_of_range("no node " + name);
  }
  // The keys of a node's translation or rotation; none where it has no such channel.
  std::vector<double> keys(const std::string& name, const std::string& path, std::vector<double>* times = nullptr) const {
    if (json.contains("animations"))
      for (const auto& channel : json["animations"].at(0)["channels"]) {
        if (&json["nodes"].at(channel["target"]["node"].get<std::size_t>()) != &node(name) || channel["target"]["path"] != path) continue;
        const auto& sampler = json["animations"][0]["samplers"].at(channel["sampler"].get<std::size_t>());
        CHECK(sampler["interpolation"] == "LINEAR");
        if (times != nullptr) *times = numbers(sampler["input"]);
        return numbers(sampler["output"]);
      }
    return {};
  }
};

inline Eigen::Vector3d vector(const std::vector<double>& row, std::size_t k = 0) { return Eigen::Vector3d(row.data() + 3 * k); }
inline Eigen::Quaterniond quaternion(const std::vector<double>& row, std::size_t k = 0) {
  return Eigen::Quaterniond(row.data() + 4 * k);  // x y z w
}

}  // namespace glb
