#include <tests/document/pdf/pdf_tools.hpp>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>

#include <tests/document/sample.hpp>

namespace sample {

std::optional<std::string> ask(const std::string& command, const std::string& pdf) {
  const std::string program = command.substr(0, command.find(' '));
  if (std::system(("command -v " + program + " >/dev/null").c_str()) != 0) {
    WARN(program << " is not installed: what it would say is not tested");
    return std::nullopt;
  }
  const Folder folder;
  const std::string file = (folder / "report.pdf").string();
  put(file, pdf);
  std::string line = command;
  line.replace(line.find("{}"), 2, file);
  std::string answer;
  FILE* const pipe = popen((line + " 2>&1").c_str(), "r");
  REQUIRE(pipe);
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) answer.append(buffer, n);
  const int status = pclose(pipe);
  INFO(answer.substr(0, 2000));
  CHECK(status == 0);
  return answer;
}

std::string field(const std::string& info, const std::string& name) {
  const auto at = info.find(name + ":");
  if (at == std::string::npos) return "";
  const auto from = info.find_first_not_of(' ', at + name.size() + 1), to = info.find('\n', at);
  return info.substr(from, to - from);
}

}  // namespace sample
