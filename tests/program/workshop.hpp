// A fresh folder to work in, and small scenarios to work on.
#pragma once

#include <tests/program/process.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace program_test {

// Sanitizers bring an allocator, threads and memory of their own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

class Workshop {
 public:
  Workshop();
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop();

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  std::filesystem::path write(const std::filesystem::path& name, std::string_view bytes) const;
  // Writes `text` to scenario.toml and runs the program there on it: the report comes to scenario-report.
  Result report(std::string_view text, std::vector<std::string> more = {}, Surroundings surroundings = {}) const;
  std::filesystem::path report_folder() const { return path_ / "scenario-report"; }

 private:
  std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& file);
int count_of(const std::string& text, std::string_view part);
// All files below a folder by their relative paths, with their bytes.
std::map<std::string, std::string> contents(const std::filesystem::path& folder);

// Three samples of a plugin of the tests.
inline constexpr std::string_view slider = R"toml(title = "Slider"
[mechanism]
use = "plain-slider"
[motion]
duration = "1 s"
samples = 3
[[section]]
kind = "displacement"
)toml";

// A sound scenario of 21 samples in 2 s without pictures, all sections of curves, one check that passes.
inline constexpr std::string_view small = R"toml(title = "Small"

[mechanism]
use = "4sps-spr"

[motion]
duration = "2 s"
samples = 21
x = "20 mm * sin(2*pi*t/2 s)"
z = "550 mm"
alpha = "1 deg * (1 - cos(2*pi*t/2 s))"

[load]
force = ["0 N", "10 N", "-10 N"]

[[section]]
kind = "displacement"

[[section]]
kind = "velocity"

[[section]]
kind = "acceleration"

[[section]]
kind = "statics"

[[check]]
that = "max(abs(actuator_force))"
below = "400 N"
)toml";
// A scenario with every first part replaced, once, by the second. Throws when a part is not there.
std::string with(std::string_view scenario, const std::vector<std::pair<std::string, std::string>>& changes);

// Runs a command that must succeed; throws with all that it wrote when it does not.
Result succeed(const std::vector<std::string>& command, const Surroundings& surroundings = {});

// The program, its plugins and the package, installed in a folder of the workshop and moved to another: nothing may lead back to where they
// were built. Returns the prefix.
std::filesystem::path install(const Workshop& here);

// The columns of a data file by name; a cell without a number is a NaN.
std::map<std::string, std::vector<double>> columns(const std::filesystem::path& csv);

}  // namespace program_test
