// Libraries that cannot be used are refused with their path, what was expected and what was seen, on one line.
#include <elf.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <core/host/library_file.hpp>
#include <core/host/plugin_file.hpp>
#include <cstddef>
#include <random>
#include <tests/host/fixtures/temporary.hpp>

using pmreport::host::load_plugin;
using pmreport::host::PluginError;
namespace fs = std::filesystem;

namespace {

std::string refusal(const fs::path& file) {
  try {
    load_plugin(file);
  } catch (const PluginError& error) {
    return error.what();
  }
  return "not refused";
}

void check_refusal(const fs::path& file, const std::string& expected, const std::string& seen) {
  const std::string sentence = refusal(file);
  INFO(sentence);
  CHECK(sentence.starts_with(file.string() + ": "));
  CHECK(sentence.find("expected " + expected) != sentence.npos);
  CHECK(sentence.find("seen " + seen) != sentence.npos);
  CHECK(sentence.find('\n') == sentence.npos);
  CHECK(sentence.find("Bad file descriptor") == sentence.npos);
}

fs::path fixture(const std::string& name) { return fs::path(FIXTURES) / (name + ".so"); }

}  // namespace

TEST_CASE("the plugin that the broken ones are made from is sound") {
  const auto plugin = load_plugin(fixture("plain"));
  REQUIRE(plugin.mechanisms.size() == 1);
  CHECK(plugin.mechanisms[0]->name == std::string("plain-slider"));
  CHECK(plugin.path == fixture("plain"));
  CHECK(plugin.table->build == std::string("C"));
}

TEST_CASE("a plugin of a newer minor version is welcome, since structs only grow at their end") {
  CHECK(load_plugin(fixture("newer_minor")).table->abi_minor == 7);
}

TEST_CASE("a plugin may bring several mechanisms") { CHECK(load_plugin(fixture("faulty")).mechanisms.size() == 3); }

TEST_CASE("a plugin loaded twice is one library, by whatever path") {
  const TemporaryFolder folder;
  fs::create_symlink(fixture("plain"), folder.path() / "link.so");
  CHECK(load_plugin(folder.path() / "link.so").table == load_plugin(fixture("plain")).table);
}

TEST_CASE("a broken plugin is refused with path, expected and seen") {
  struct Case {
    const char *fixture, *expected, *seen;
  };
  const auto c = GENERATE(values<Case>({
      {"no_symbol", "the exported data symbol 'pm_plugin'", "a library without it"},
      {"function_symbol", "the exported data symbol 'pm_plugin'", "a symbol of that name that is not data"},
      {"older_major", "a plugin for ABI 1.x", "0.4; build the plugin again"},
      {"newer_major", "a plugin for ABI 1.x", "2.4; use a pmreport as new as the plugin"},
      {"short_table", "a plugin table of at least 40 bytes", "24"},
      {"no_mechanisms", "at least one mechanism", "none"},
      {"null_mechanisms", "a table of mechanisms", "a null pointer"},
      {"null_mechanism", "a table", "a null pointer"},
      {"short_mechanism", "a table of at least", "64"},
      {"null_name", "a name of lower-case letters, digits and dashes", "nothing"},
      {"null_function", "the function kinematics.place", "a null pointer"},
      {"missing_function", "a library that loads with all its symbols", "undefined symbol: a_function_that_nobody_defines"},
  }));
  CAPTURE(c.fixture);
  check_refusal(fixture(c.fixture), c.expected, c.seen);
}

TEST_CASE("a file that is no library is refused by what it is") {
  const TemporaryFolder folder;
  check_refusal(folder.path() / "missing.so", "a shared library (ELF)", "no such file");
  check_refusal(folder.path(), "a shared library (ELF)", "a folder");
  check_refusal(folder.write("empty.so", ""), "a shared library (ELF)", "an empty file");
  check_refusal(folder.write("text.so", "hello\nworld"), "a shared library (ELF)", "a file of 11 bytes that begins with 'hello\\x0aworld'");
  check_refusal(folder.write("magic.so",
                             "\x7f"
                             "ELF"),
                "a shared library (ELF)", "a file of 4 bytes");
  check_refusal("/dev/null", "a shared library (ELF)", "a special file");
}

TEST_CASE("a library that was cut off anywhere is refused, and does not end the process") {
  const TemporaryFolder folder;
  const std::string whole = read_bytes(fixture("plain"));
  REQUIRE(whole.size() > 2 * sizeof(Elf64_Ehdr));
  for (std::size_t length = 1; length < whole.size(); length += 1 + whole.size() / 64) {
    CAPTURE(length, whole.size());
    const auto file = folder.write("cut.so", whole.substr(0, length));
    if (length < sizeof(Elf64_Ehdr))
      check_refusal(file, "a shared library (ELF)", "a file of " + std::to_string(length) + " bytes");
    else
      check_refusal(file, "a whole library of " + std::to_string(whole.size()) + " bytes", "only " + std::to_string(length));
  }
}

TEST_CASE("a library for another machine is refused by name") {
  const TemporaryFolder folder;
  std::string bytes = read_bytes(fixture("plain"));
  const auto machine = static_cast<char>(bytes[offsetof(Elf64_Ehdr, e_machine)] == EM_RISCV % 256 ? EM_AARCH64 : EM_RISCV % 256);
  bytes[offsetof(Elf64_Ehdr, e_machine)] = machine;
  bytes[offsetof(Elf64_Ehdr, e_machine) + 1] = 0;
  check_refusal(folder.write("other.so", bytes), "a library for the machine",
                machine == static_cast<char>(EM_RISCV) ? "one for RISC-V" : "one for ARM64");
}

// Only looked at, not loaded: what the system's loader does with such a file is its own affair.
TEST_CASE("damaged headers are refused or overlooked, never followed out of the file") {
  const TemporaryFolder folder;
  const std::string whole = read_bytes(fixture("plain"));
  std::mt19937_64 random(12);
  int refused = 0;
  for (int i = 0; i < 500; ++i) {
    std::string bytes = whole;
    const std::size_t tables = bytes.size() - 30 * sizeof(Elf64_Shdr);  // section headers end the file
    for (int damage = 0; damage < 3; ++damage) {
      const std::size_t header = random() % (sizeof(Elf64_Ehdr) - EI_NIDENT) + EI_NIDENT;
      bytes[random() % 2 == 0 ? header : tables + random() % (bytes.size() - tables)] = static_cast<char>(random());
    }
    try {
      pmreport::host::require_plugin_library(folder.write("damaged.so", bytes));
    } catch (const PluginError&) {
      ++refused;
    }
  }
  CHECK(refused > 100);
}

TEST_CASE("a program is no plugin") { check_refusal("/proc/self/exe", "the exported data symbol 'pm_plugin'", "a library without it"); }

TEST_CASE("a plugin without its section headers is still found by the loader") {
  const TemporaryFolder folder;
  std::string bytes = read_bytes(fixture("plain"));
  for (const std::size_t at : {offsetof(Elf64_Ehdr, e_shoff), offsetof(Elf64_Ehdr, e_shnum), offsetof(Elf64_Ehdr, e_shstrndx)}) {
    const std::size_t size = at == offsetof(Elf64_Ehdr, e_shoff) ? 8 : 2;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), size, '\0');
  }
  CHECK(load_plugin(folder.write("bare.so", bytes)).mechanisms.size() == 1);
}
