#include <reports/program/worker/sandbox.hpp>
#include <reports/program/worker/system_calls.hpp>

#include <core/text/text.hpp>
#include <reports/document/folder/file.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <system_error>

namespace pmreport::program {

namespace fs = std::filesystem;

namespace {

using document::Descriptor;

// Of <linux/landlock.h>, whose older versions lack the later of them: numbers and layouts are the kernel's promise.
constexpr std::uint64_t write_file = 1u << 1, remove_folder = 1u << 4, remove_file = 1u << 5, make_all = 0x7Fu << 6, refer = 1u << 13,
                        truncate_file = 1u << 14;
constexpr std::uint64_t bind_and_connect = 3, abstract_sockets_and_signals = 3;
constexpr int refer_since = 2, truncate_since = 3, network_since = 4, scopes_since = 6;  // versions of Landlock
constexpr int path_beneath = 1;
constexpr unsigned ask_version = 1;

struct Rules {
  std::uint64_t files, network, scopes;
};
struct __attribute__((packed)) FolderRule {
  std::uint64_t allowed;
  std::int32_t folder;
};

std::string reason(int error) { return std::generic_category().message(error); }

int landlock_version() {
  const long version = syscall(SYS_landlock_create_ruleset, nullptr, 0, ask_version);
  if (version < 1)
    throw SandboxError(
        fmt::format("--sandbox needs Landlock in the kernel, which does not offer it ({}); it is part of Linux since 5.13, and on where "
                    "\"landlock\" stands in /sys/kernel/security/lsm. Nothing was run",
                    reason(errno)));
  return static_cast<int>(version);
}

void allow(int rules, const fs::path& path, std::uint64_t what) {
  const Descriptor at(open(path.c_str(), O_PATH | O_CLOEXEC));
  if (at.number() < 0) throw SandboxError(fmt::format("--sandbox cannot reach {}: {}", printable(path.string()), reason(errno)));
  const FolderRule rule{what, at.number()};
  if (syscall(SYS_landlock_add_rule, rules, path_beneath, &rule, 0) != 0)
    throw SandboxError(fmt::format("--sandbox cannot let {} be written: {}", printable(path.string()), reason(errno)));
}

void confine_files(std::span<const fs::path> writable) {
  const int version = landlock_version();
  Rules asked{write_file | remove_folder | remove_file | make_all, 0, 0};
  if (version >= refer_since) asked.files |= refer;
  if (version >= truncate_since) asked.files |= truncate_file;
  if (version >= network_since) asked.network = bind_and_connect;
  if (version >= scopes_since) asked.scopes = abstract_sockets_and_signals;
  const std::size_t size = sizeof(std::uint64_t) * (version >= scopes_since ? 3 : version >= network_since ? 2 : 1);
  const Descriptor rules(static_cast<int>(syscall(SYS_landlock_create_ruleset, &asked, size, 0)));
  if (rules.number() < 0) throw SandboxError(fmt::format("--sandbox cannot make rules of Landlock: {}", reason(errno)));
  for (const fs::path& folder : writable) allow(rules.number(), folder, asked.files);
  allow(rules.number(), "/dev/null", write_file);  // where libraries write what nobody shall see
  if (syscall(SYS_landlock_restrict_self, rules.number(), 0) != 0)
    throw SandboxError(fmt::format("--sandbox cannot be entered (Landlock): {}", reason(errno)));
}

// Threads of this process, as the kernel lists them.
std::ptrdiff_t threads() { return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator()); }

fs::path resolved(const fs::path& path) { return fs::weakly_canonical(fs::absolute(path)).lexically_normal(); }

}  // namespace

std::vector<fs::path> folders_that_hold(const std::vector<fs::path>& paths) {
  std::vector<fs::path> out;
  for (const fs::path& path : paths) {
    fs::path folder = resolved(path);
    if (!folder.has_filename()) folder = folder.parent_path();
    folder = folder.parent_path();
    std::error_code error;
    while (!fs::is_directory(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
    out.push_back(folder);
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

bool within(std::span<const fs::path> folders, const fs::path& path) {
  std::error_code error;
  const fs::path parent = fs::canonical(path.parent_path(), error);  // where a link on the way would lead
  return !error && path.has_filename() && path.filename() != ".." && path.filename() != "." &&
         std::ranges::any_of(folders, [&](const fs::path& folder) { return std::ranges::mismatch(folder, parent).in1 == folder.end(); });
}

void confine(std::span<const fs::path> writable) try {
  if (threads() != 1) throw SandboxError("--sandbox cannot be entered: a library has begun threads before, which would stay outside of it");
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) throw SandboxError("--sandbox cannot be entered (no_new_privs): " + reason(errno));
  confine_files(writable);
  refuse_system_calls();
} catch (const fs::filesystem_error& e) {
  throw SandboxError(std::string("--sandbox cannot be entered: ") + e.what());
}

}  // namespace pmreport::program
