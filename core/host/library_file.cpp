// Boost.DLL's library_info lists the symbols of .symtab, which `strip` and `cmake --install --strip` remove; the loader looks in .dynsym,
// and so does this.
#include <dlfcn.h>
#include <elf.h>
#include <fmt/core.h>
#include <link.h>
#include <pmreport/plugin.h>

#include <algorithm>
#include <cerrno>
#include <core/host/library_file.hpp>
#include <core/host/refusal.hpp>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

namespace pmreport::host {
namespace {

using Header = ElfW(Ehdr);
using Segment = ElfW(Phdr);
using Section = ElfW(Shdr);
using Symbol = ElfW(Sym);

constexpr const char* build_advice = "build the plugin with pmreport_add_mechanism, or take the file out of the plugin folder";

class BinaryFile {
 public:
  explicit BinaryFile(const std::filesystem::path& path) : stream_(path, std::ios::binary | std::ios::ate) {
    if (stream_) size_ = static_cast<std::uint64_t>(stream_.tellg());
  }
  bool open() const { return stream_.is_open(); }
  std::uint64_t size() const { return size_; }
  bool holds(std::uint64_t at, std::uint64_t bytes) const { return at <= size_ && bytes <= size_ - at; }

  // `count` items at byte `at`; empty where the file does not hold them.
  template <class T>
  std::vector<T> read(std::uint64_t at, std::uint64_t count) {
    if (count > size_ / sizeof(T) || !holds(at, count * sizeof(T))) return {};
    std::vector<T> items(count);
    stream_.seekg(static_cast<std::streamoff>(at));
    stream_.read(reinterpret_cast<char*>(items.data()), static_cast<std::streamsize>(count * sizeof(T)));
    if (!stream_) items.clear();
    return items;
  }

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
};

bool is_elf(const Header& h) { return std::memcmp(h.e_ident, ELFMAG, SELFMAG) == 0; }

std::string machine_name(const Header& h) {
  const auto name = [&]() -> std::string {
    switch (h.e_machine) {
      case EM_X86_64:
        return "x86-64";
      case EM_386:
        return "x86";
      case EM_AARCH64:
        return "ARM64";
      case EM_ARM:
        return "ARM";
      case EM_RISCV:
        return "RISC-V";
      case EM_PPC64:
        return "POWER";
      default:
        return fmt::format("number {}", h.e_machine);
    }
  }();
  return fmt::format("{} ({} bits)", name, h.e_ident[EI_CLASS] == ELFCLASS64 ? 64 : 32);
}

// A library must be for the machine of the program that loads it, and that one can read its own header.
Header header_of_this_program() {
  const auto own = BinaryFile("/proc/self/exe").read<Header>(0, 1);
  return own.empty() ? Header{} : own.front();
}

void require_machine(const std::string& where, const Header& h) {
  static const Header own = header_of_this_program();
  if (!is_elf(own)) return;  // without /proc the loader itself has to judge
  if (h.e_machine != own.e_machine || h.e_ident[EI_CLASS] != own.e_ident[EI_CLASS] || h.e_ident[EI_DATA] != own.e_ident[EI_DATA])
    refuse(where, fmt::format("a library for the machine {}", machine_name(own)), fmt::format("one for {}", machine_name(h)),
           "build the plugin on this machine");
}

// The end of the furthest part that the headers tell of.
std::uint64_t told_size(BinaryFile& file, const Header& h) {
  std::uint64_t end = h.e_shoff + std::uint64_t{h.e_shnum} * h.e_shentsize;
  end = std::max(end, h.e_phoff + std::uint64_t{h.e_phnum} * h.e_phentsize);
  for (const Segment& s : file.read<Segment>(h.e_phoff, h.e_phnum))
    if (s.p_type == PT_LOAD) end = std::max(end, std::uint64_t{s.p_offset} + s.p_filesz);
  return end;
}

// What the dynamic symbols say. A file whose section headers were stripped does not tell.
struct Exports {
  bool told = false;
  std::optional<Symbol> table;   // the definition of `pm_plugin`
  bool needs_sanitizer = false;  // AddressSanitizer's start is called for
};
constexpr const char* sanitizer_start = "__asan_init";

Exports read_exports(BinaryFile& file, const Header& h) {
  Exports exports;
  const auto sections = file.read<Section>(h.e_shoff, h.e_shnum);
  for (const Section& s : sections) {
    if (s.sh_type != SHT_DYNSYM || s.sh_link >= sections.size()) continue;
    const auto names = file.read<char>(sections[s.sh_link].sh_offset, sections[s.sh_link].sh_size);
    if (names.empty() || names.back() != '\0') continue;
    exports.told = true;
    for (const Symbol& symbol : file.read<Symbol>(s.sh_offset, s.sh_size / sizeof(Symbol))) {
      const std::string_view name = symbol.st_name < names.size() ? &names[symbol.st_name] : "";
      const bool defined = symbol.st_shndx != SHN_UNDEF;
      if (defined && name == PM_PLUGIN_SYMBOL) exports.table = symbol;
      if (!defined && name == sanitizer_start) exports.needs_sanitizer = true;
    }
  }
  return exports;
}

std::string first_bytes(BinaryFile& file) {
  const auto start = file.read<char>(0, std::min<std::uint64_t>(file.size(), 16));
  return fmt::format("a file of {} bytes that begins with {}", file.size(), quoted(std::string_view(start.data(), start.size())));
}

}  // namespace

void require_plugin_library(const std::filesystem::path& path) {
  const std::string where = path.string();
  constexpr const char* library = "a shared library (ELF)";
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found) refuse(where, library, "no such file", "check the path");
  if (kind != std::filesystem::file_type::regular)
    refuse(where, library,
           kind == std::filesystem::file_type::directory ? "a folder"
           : error                                       ? error.message()
                                                         : "a special file",
           "check the path");
  errno = 0;
  BinaryFile file(path);
  if (!file.open()) refuse(where, "a file that can be read", std::generic_category().message(errno), "check its permissions");
  if (file.size() == 0) refuse(where, library, "an empty file", build_advice);

  const auto start = file.read<Header>(0, 1);
  if (start.empty() || !is_elf(start.front())) refuse(where, library, first_bytes(file), build_advice);
  const Header& h = start.front();
  require_machine(where, h);
  if (h.e_type != ET_DYN) refuse(where, library, fmt::format("an ELF file of type {}", h.e_type), build_advice);
  if (const std::uint64_t told = told_size(file, h); told > file.size())
    refuse(where, fmt::format("a whole library of {} bytes", told), fmt::format("only {}: the file is truncated", file.size()),
           "copy or build it again");

  const Exports exports = read_exports(file, h);
  constexpr const char* wanted = "the exported data symbol '" PM_PLUGIN_SYMBOL "'";
  constexpr const char* export_advice = "end the source with PMREPORT_PLUGIN(...) and build it with pmreport_add_mechanism";
  if (!exports.told) return;  // the loader finds the symbol, or tells that there is none
  if (!exports.table) refuse(where, wanted, "a library without it", export_advice);
  constexpr std::size_t readable = offsetof(pm_plugin_table, abi_minor) + sizeof(std::uint32_t);  // the part that tells the version
  if ((exports.table->st_info & 0xf) != STT_OBJECT) refuse(where, wanted, "a symbol of that name that is not data", export_advice);
  if (exports.table->st_size < readable) refuse(where, wanted, fmt::format("one of {} bytes", exports.table->st_size), export_advice);
  // The sanitizer ends the process when it is loaded late.
  if (exports.needs_sanitizer && dlsym(RTLD_DEFAULT, sanitizer_start) == nullptr)
    refuse(where, "a library without AddressSanitizer, which this program was started without", "one that needs it",
           "start the program with LD_PRELOAD=libasan.so, or build the plugin without -fsanitize=address");
}

}  // namespace pmreport::host
