#include <core/host/surroundings.hpp>

#include <clocale>
#include <system_error>

namespace pmreport::host {

namespace {

std::string locale() {
  const char* name = std::setlocale(LC_ALL, nullptr);
  return name != nullptr ? name : "";
}

std::filesystem::path folder() {
  std::error_code none;
  return std::filesystem::current_path(none);
}

// How numbers are rounded, and whether tiny ones are taken for zero: a library that was built with -ffast-math sees to the latter as it is
// loaded, for the whole thread (GCC before 13).
bool same(const std::fenv_t& a, const std::fenv_t& b) {
#if defined(__x86_64__)
  constexpr unsigned flags = 0x3F;  // what happened, not what is to happen
  return a.__control_word == b.__control_word && (a.__mxcsr & ~flags) == (b.__mxcsr & ~flags);
#else
  (void)a, (void)b;
  return std::fegetround() == FE_TONEAREST;
#endif
}

}  // namespace

Surroundings::Surroundings() : locale_(locale()), folder_(folder()), numbers_() { std::fegetenv(&numbers_); }

std::vector<std::string> Surroundings::restore() const {
  std::vector<std::string> changed;
  if (locale() != locale_) {
    std::setlocale(LC_ALL, locale_.c_str());
    changed.push_back("the locale (setlocale)");
  }
  if (folder() != folder_) {
    std::error_code none;
    std::filesystem::current_path(folder_, none);
    changed.push_back("the working folder (chdir)");
  }
  std::fenv_t now;
  std::fegetenv(&now);
  if (!same(now, numbers_)) {
    std::fesetenv(&numbers_);
    changed.push_back("how numbers are rounded (fesetround, or a build with -ffast-math)");
  }
  return changed;
}

}  // namespace pmreport::host
