// Printed programs run by Node, many in one start of it.
#pragma once

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace in_node {

inline bool here() {
  static const bool found = std::system("command -v node >/dev/null") == 0;
  if (!found) WARN("node is not here: what is printed as JavaScript was not run");
  return found;
}

// A folder of its own, gone with it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "pmreport-node-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for Node");
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name, std::ios::binary) << text; }

 private:
  std::filesystem::path path_;
};

inline std::string bytes_of(const std::vector<double>& x) { return {reinterpret_cast<const char*>(x.data()), x.size() * sizeof(double)}; }

// Functions (x, y) of so many inputs and outputs, each run on all its inputs, pose after pose.
class Functions {
 public:
  void add(const std::string& function, std::size_t inputs, std::size_t outputs, const std::vector<double>& x) {
    calls_ +=
        "[" + function + "," + std::to_string(inputs) + "," + std::to_string(outputs) + "," + std::to_string(x.size() / inputs) + "],\n";
    in_.insert(in_.end(), x.begin(), x.end());
    sizes_.push_back(x.size() / inputs * outputs);
  }

  // What each gives, in the order in which they were added.
  std::vector<std::vector<double>> run() const {
    const Folder folder;
    folder.write("in", bytes_of(in_));
    folder.write("run.js", "const fs = require('fs'), bytes = fs.readFileSync(process.argv[2]), all = [" + calls_ + R"(];
const numbers = new Float64Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
const out = new Float64Array(all.reduce((sum, [, , outputs, count]) => sum + outputs * count, 0));
let from = 0, to = 0;
for (const [f, inputs, outputs, count] of all)
  for (let k = 0; k < count; ++k) f(numbers.subarray(from, from += inputs), out.subarray(to, to += outputs));
fs.writeFileSync(process.argv[3], Buffer.from(out.buffer));
)");
    const std::string command = "node '" + folder.file("run.js") + "' '" + folder.file("in") + "' '" + folder.file("out") + "'";
    REQUIRE(std::system(command.c_str()) == 0);
    std::ifstream file(folder.file("out"), std::ios::binary);
    std::vector<std::vector<double>> out;
    for (const std::size_t size : sizes_) {
      out.emplace_back(size);
      file.read(reinterpret_cast<char*>(out.back().data()), static_cast<std::streamsize>(size * sizeof(double)));
      REQUIRE(file);
    }
    return out;
  }

 private:
  std::string calls_;
  std::vector<double> in_;
  std::vector<std::size_t> sizes_;
};

}  // namespace in_node
