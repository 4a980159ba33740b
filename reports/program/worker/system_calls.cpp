#include <reports/program/worker/sandbox.hpp>
#include <reports/program/worker/system_calls.hpp>

#include <fmt/format.h>

#include <asm/ioctls.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <system_error>
#include <vector>

namespace pmreport::program {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t processor = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t processor = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t processor = 0;  // whose calls nobody has looked at
#endif

constexpr std::uint32_t other_numbers = 0x40000000;  // the first call of x32, by which the same kernel can be asked

// Numbers since Linux 5.1 are those of all processors; headers older than a call lack its name.
constexpr std::uint32_t openat2_number = 437, fchmodat2_number = 452, setxattrat_number = 463, removexattrat_number = 466,
                        clone3_number = 435;

// No part of any of them in a report.
constexpr std::uint32_t refused[] = {
    // Networks, and whoever listens on this machine.
    SYS_socket, SYS_connect, SYS_bind, SYS_listen, SYS_accept, SYS_accept4, SYS_sendto, SYS_sendmsg, SYS_sendmmsg,
    // Programs and other processes.
    SYS_execve, SYS_execveat, SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_tkill, SYS_pidfd_open, SYS_pidfd_getfd,
    SYS_pidfd_send_signal, SYS_kcmp, SYS_shmget, SYS_semget, SYS_msgget, SYS_mq_open, SYS_unshare, SYS_setns,
#if defined(SYS_fork)
    SYS_fork, SYS_vfork,
#endif
    // Modes, owners, times and lengths of files by their names, which Landlock does not watch, or not in every version.
    SYS_fchmod, SYS_fchmodat, fchmodat2_number, SYS_fchown, SYS_fchownat, SYS_utimensat, SYS_truncate, SYS_setxattr, SYS_lsetxattr,
    SYS_fsetxattr, SYS_removexattr, SYS_lremovexattr, SYS_fremovexattr, setxattrat_number, removexattrat_number,
#if defined(SYS_chmod)
    SYS_chmod, SYS_chown, SYS_lchown, SYS_utime, SYS_utimes, SYS_futimesat,
#endif
    SYS_open_by_handle_at, SYS_fanotify_init,
    // What does all this by another way, or changes the machine.
    SYS_io_uring_setup, SYS_io_uring_enter, SYS_io_uring_register, SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_mount, SYS_umount2,
    SYS_pivot_root, SYS_chroot, SYS_move_mount, SYS_open_tree, SYS_fsopen, SYS_fsconfig, SYS_fsmount, SYS_fspick, SYS_mount_setattr,
    SYS_swapon, SYS_swapoff, SYS_reboot, SYS_kexec_load, SYS_init_module, SYS_finit_module, SYS_delete_module, SYS_acct, SYS_settimeofday,
    SYS_clock_settime, SYS_clock_adjtime, SYS_adjtimex, SYS_sethostname, SYS_setdomainname, SYS_quotactl, SYS_add_key, SYS_request_key,
    SYS_keyctl};

// Their arguments stand in memory, where a filter cannot look: as on a kernel that does not have them, the older ones are asked.
constexpr std::uint32_t unknown[] = {clone3_number, openat2_number};

// Calls that may be made with one value of an argument alone: about this process.
struct Own {
  std::uint32_t call;
  std::uint32_t argument;
};
constexpr Own own[] = {{SYS_kill, 0}, {SYS_tgkill, 0}, {SYS_rt_sigqueueinfo, 0}, {SYS_rt_tgsigqueueinfo, 0}};

constexpr std::uint32_t number_at = offsetof(seccomp_data, nr), processor_at = offsetof(seccomp_data, arch);
constexpr std::uint32_t argument_at(std::uint32_t i) {  // its lower half, on processors whose numbers begin with it
  return static_cast<std::uint32_t>(offsetof(seccomp_data, args)) + 8 * i;
}

constexpr std::uint32_t answer_with(int error) { return SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error); }

class Filter {
 public:
  void load(std::uint32_t at) { add(BPF_LD | BPF_W | BPF_ABS, at); }
  void mask(std::uint32_t bits) { add(BPF_ALU | BPF_AND | BPF_K, bits); }
  void give(std::uint32_t answer) { add(BPF_RET | BPF_K, answer); }
  // Of what was loaded last.
  void give_if_equal(std::uint32_t value, std::uint32_t answer) { skip_unless(BPF_JEQ, value, 1), give(answer); }
  void give_unless_equal(std::uint32_t value, std::uint32_t answer) { add(BPF_JMP | BPF_JEQ | BPF_K, value, 1, 0), give(answer); }
  void give_from(std::uint32_t value, std::uint32_t answer) { skip_unless(BPF_JGE, value, 1), give(answer); }
  void skip_unless_equal(std::uint32_t value, std::uint8_t instructions) { skip_unless(BPF_JEQ, value, instructions); }

  int install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0 ? 0 : errno;
  }

 private:
  void skip_unless(std::uint16_t how, std::uint32_t value, std::uint8_t instructions) {
    add(static_cast<std::uint16_t>(BPF_JMP | how | BPF_K), value, 0, instructions);
  }
  void add(std::uint16_t code, std::uint32_t k, std::uint8_t yes = 0, std::uint8_t no = 0) { code_.push_back({code, yes, no, k}); }

  std::vector<sock_filter> code_;
};

// A file that is opened to be read may be made empty on the way, which Landlock did not watch before its third version.
void refuse_emptying(Filter& filter, std::uint32_t call, std::uint32_t flags) {
  filter.load(number_at);
  filter.skip_unless_equal(call, 4);
  filter.load(argument_at(flags));
  filter.mask(O_ACCMODE | O_TRUNC);
  filter.give_if_equal(O_TRUNC, answer_with(EPERM));
}

}  // namespace

void refuse_system_calls() {
  if (processor == 0) throw SandboxError("--sandbox knows the system calls of x86-64 and AArch64 alone. Nothing was run");
  const auto self = static_cast<std::uint32_t>(getpid());
  constexpr std::uint32_t no = answer_with(EPERM), thread = CLONE_THREAD | CLONE_VM;
  Filter filter;
  filter.load(processor_at);
  filter.give_unless_equal(processor, no);
  filter.load(number_at);
  filter.give_from(other_numbers, no);
  for (const std::uint32_t call : refused) filter.give_if_equal(call, no);
  for (const std::uint32_t call : unknown) filter.give_if_equal(call, answer_with(ENOSYS));
  for (const Own& o : own) {
    filter.load(number_at);
    filter.skip_unless_equal(o.call, 3);
    filter.load(argument_at(o.argument));
    filter.give_unless_equal(self, no);
  }
  // Threads, and no processes.
  filter.load(number_at);
  filter.skip_unless_equal(SYS_clone, 4);
  filter.load(argument_at(0));
  filter.mask(thread);
  filter.give_unless_equal(thread, no);
  // Limits of other processes.
  filter.load(number_at);
  filter.skip_unless_equal(SYS_prlimit64, 5);
  filter.load(argument_at(0));
  filter.give_if_equal(self, SECCOMP_RET_ALLOW);
  filter.give_unless_equal(0, no);
  // Words that a terminal takes as typed by its user.
  for (const std::uint32_t request : {TIOCSTI, TIOCLINUX}) {
    filter.load(number_at);
    filter.skip_unless_equal(SYS_ioctl, 3);
    filter.load(argument_at(1));
    filter.give_if_equal(request, no);
  }
  refuse_emptying(filter, SYS_openat, 2);
#if defined(SYS_open)
  refuse_emptying(filter, SYS_open, 1);
#endif
  filter.give(SECCOMP_RET_ALLOW);
  if (const int error = filter.install(); error != 0)
    throw SandboxError(
        fmt::format("--sandbox needs seccomp filters in the kernel (CONFIG_SECCOMP_FILTER), which refuses them: {}. Nothing "
                    "was run",
                    std::generic_category().message(error)));
}

}  // namespace pmreport::program
