#include <reports/document/pdf/pdf_date.hpp>

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>

namespace pmreport::document::pdf {

const char* const placeholder_date = "2000-01-01T00:00:00+00:00";

long long source_date_epoch() {
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  if (!text) return -1;
  constexpr long long year_10000 = 253402300800;
  long long epoch = -1;
  const char* const end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, epoch);
  return error == std::errc() && stop == end && stop != text && epoch >= 0 && epoch < year_10000 ? epoch : -1;
}

// Cairo 1.16 leaves out the "D:" that every date in a PDF begins with. The placeholder's zone of five characters makes room for it.
void settle_date(std::string& pdf, long long epoch) {
  static const std::string written = "/CreationDate (20000101000000+00'00)";
  const auto at = pdf.rfind(written);
  if (at == std::string::npos) return;
  std::string date;
  if (epoch >= 0) {
    using namespace std::chrono;
    const sys_seconds time{seconds{epoch}};
    const auto day = floor<days>(time);
    const year_month_day d{day};
    const hh_mm_ss t{time - day};
    date = fmt::format("/CreationDate (D:{:04}{:02}{:02}{:02}{:02}{:02}Z)", static_cast<int>(d.year()), static_cast<unsigned>(d.month()),
                       static_cast<unsigned>(d.day()), t.hours().count(), t.minutes().count(), t.seconds().count());
  }
  date.resize(written.size(), ' ');
  pdf.replace(at, written.size(), date);
}

}  // namespace pmreport::document::pdf
