// Files of a report on disk: opened so that neither a pipe nor a folder nor a file without end holds the program up.
#include <reports/compare/data_names.hpp>
#include <reports/compare/results.hpp>
#include <reports/compare/spreadsheet.hpp>

#include <reports/document/folder/file.hpp>

#include <core/text/text.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

namespace pmreport::compare {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{64} << 20;  // a thousand times the largest results of ours

[[noreturn]] void refuse(const fs::path& file, const std::string& what) { throw InputError(printable(file.string()) + ": " + what); }

const char* sort_of(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

// A file that grows while it is read ends at the bound as well.
std::string read_all(const fs::path& file) {
  // Without waiting for a writer, should it be a pipe.
  const document::Descriptor opened(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat status {};
  if (opened.number() < 0 || fstat(opened.number(), &status) != 0)
    refuse(file, fmt::format("cannot be read: {}", std::generic_category().message(errno)));
  if (!S_ISREG(status.st_mode)) refuse(file, fmt::format("expected a file; seen {}", sort_of(status.st_mode)));
  std::string out;
  std::string buffer(std::size_t{1} << 16, '\0');
  while (static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) <= most_bytes && out.size() <= most_bytes) {
    const ssize_t count = read(opened.number(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) refuse(file, fmt::format("cannot be read: {}", std::generic_category().message(errno)));
    if (count == 0) return out;
    out.append(buffer, 0, static_cast<std::size_t>(count));
  }
  refuse(file, fmt::format("expected at most {} MiB; it is larger", most_bytes >> 20));
}

// What results.json says is the file's name, if it lies in data/ and nowhere else.
bool is_plain_name_in_data(const std::string& csv) {
  constexpr std::string_view folder = "data/";
  if (!csv.starts_with(folder)) return false;
  const std::string name = csv.substr(folder.size());
  return !name.empty() && name.front() != '.' && name.find_first_of(std::string_view("/\0", 2)) == std::string::npos;
}

}  // namespace

fs::path results_file(const std::string& folder_or_file) {
  std::error_code ignored;
  const fs::path given(folder_or_file);
  if (!fs::is_directory(given, ignored)) return given;
  const fs::path inside = given / "results.json";
  if (!fs::exists(fs::symlink_status(inside, ignored))) refuse(given, "expected the folder of a report; it has no results.json");
  return inside;
}

std::string bytes_of_results(const fs::path& file) { return read_all(file); }

Results read_report(const std::string& folder_or_file) {
  const fs::path file = results_file(folder_or_file);
  const std::string text = read_all(file);
  Results out = read_results(text, folder_or_file);
  std::size_t missing = 0, all = 0;
  std::optional<std::string> first_problem;
  for (const DataName& data : data_names(text, folder_or_file)) {
    if (!is_plain_name_in_data(data.csv))
      refuse(folder_or_file, fmt::format("data: expected a file in data/; seen {}", in_quotes(data.csv)));
    const fs::path csv = file.parent_path() / data.csv;
    std::error_code ignored;
    ++all;
    if (!fs::exists(csv, ignored)) {
      ++missing;
      continue;
    }
    try {
      if (auto curves = read_curves(read_all(csv), data.name)) out.curves.push_back(std::move(*curves));
    } catch (const InputError& e) {
      if (!first_problem) first_problem = e.what();
    } catch (const SpreadsheetError& e) {
      if (!first_problem) first_problem = printable(csv.string()) + ": " + e.what();
    }
  }
  if (first_problem)
    out.curves_missing = *first_problem;
  else if (missing == all && all > 0)
    out.curves_missing = "it stands alone, without the folder data/";
  else if (missing > 0)
    out.curves_missing = fmt::format("{} of {} files are missing in data/", missing, all);
  return out;
}

}  // namespace pmreport::compare
