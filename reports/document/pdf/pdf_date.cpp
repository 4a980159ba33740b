#include <reports/document/pdf/pdf_date.hpp>

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>

namespace pmreport::document::pdf {

long long source_date_epoch() {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  if (!text) return -1;
  constexpr long long year_10000 = 253402300800;
  long long epoch = -1;
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, epoch);
  return error == std::errc() && stop == end && stop != text && epoch >= 0 && epoch < year_10000 ? epoch : -1;
}

namespace {

std::string date(const char* format, long long epoch) {
  using namespace std::chrono;
  const sys_seconds time{seconds{epoch}};
  const auto day = floor<days>(time);
  const year_month_day d{day};
  const hh_mm_ss t{time - day};
  return fmt::format(fmt::runtime(format), static_cast<int>(d.year()), static_cast<unsigned>(d.month()), static_cast<unsigned>(d.day()),
                     t.hours().count(), t.minutes().count(), t.seconds().count());
}

}  // namespace

std::string pdf_date(long long epoch) { return date("D:{:04}{:02}{:02}{:02}{:02}{:02}Z", epoch); }
std::string iso_date(long long epoch) { return date("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", epoch); }

}  // namespace pmreport::document::pdf
