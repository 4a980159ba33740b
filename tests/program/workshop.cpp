#include <tests/program/workshop.hpp>

#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace program_test {

namespace fs = std::filesystem;

Workshop::Workshop() {
  std::string name = (fs::temp_directory_path() / "pmreport-program-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = fs::canonical(name);
}

Workshop::~Workshop() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path Workshop::write(const fs::path& name, std::string_view bytes) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

Result Workshop::report(std::string_view text, std::vector<std::string> more, Surroundings surroundings) const {
  write("scenario.toml", text);
  more.insert(more.begin(), "scenario.toml");
  surroundings.folder = path_;
  return run_pmreport(more, surroundings);
}

int count_of(const std::string& text, std::string_view part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> out;
  if (!fs::exists(folder)) return out;
  for (const fs::directory_entry& e : fs::recursive_directory_iterator(folder))
    if (e.is_regular_file()) out[e.path().lexically_relative(folder).string()] = bytes_of(e.path());
  return out;
}

std::string with(std::string_view scenario, const std::vector<std::pair<std::string, std::string>>& changes) {
  std::string text(scenario);
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    if (at == std::string::npos) throw std::invalid_argument("not in the scenario: " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

Result succeed(const std::vector<std::string>& command, const Surroundings& surroundings) {
  Result result = run(command, surroundings);
  if (result.status != 0)
    throw std::runtime_error(command.front() + " ended with " + std::to_string(result.status) + "\n" + result.out + result.err);
  return result;
}

fs::path install(const Workshop& here) {
  succeed({CMAKE, "--install", BINARY, "--prefix", (here / "built").string()});
  fs::rename(here / "built", here / "prefix");
  return here / "prefix";
}

std::map<std::string, std::vector<double>> columns(const fs::path& csv) {
  std::istringstream lines(bytes_of(csv));
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> out;
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    if (names.empty()) {
      for (const std::string& cell : cells) names.push_back(cell.substr(0, cell.find(" [")));
      continue;
    }
    if (cells.size() != names.size()) throw std::runtime_error("a row of another length: " + line);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      double x = std::numeric_limits<double>::quiet_NaN();
      const char* const end = cells[i].data() + cells[i].size();
      if (!cells[i].empty() && std::from_chars(cells[i].data(), end, x).ptr != end) throw std::runtime_error("no number: " + cells[i]);
      out[names[i]].push_back(x);
    }
  }
  return out;
}

}  // namespace program_test
