// Text and numbers as the documents show them.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <reports/document/quantity.hpp>
#include <reports/document/text.hpp>

using namespace pmreport::document;

TEST_CASE("a small number is read as a power of ten with two digits") {
  CHECK(rounded(2.1e-15) == "2.1 × 10⁻¹⁵");
  CHECK(rounded(-3.456e-7) == "−3.5 × 10⁻⁷");
  CHECK(rounded(9.96e-5) == "1.0 × 10⁻⁴");
  CHECK(rounded(6.02214e23) == "6.0 × 10²³");
}

TEST_CASE("a number of ordinary size is read as it is with three digits") {
  CHECK(rounded(0) == "0");
  CHECK(rounded(0.5) == "0.5");
  CHECK(rounded(312.44) == "312");
  CHECK(rounded(0.0012345) == "0.00123");
  CHECK(rounded(999.6) == "1000");
  CHECK(rounded(1234.4) == "1234");
  CHECK(rounded(10000) == "1 × 10⁴");
}

TEST_CASE("a residual just above its tolerance does not read like the tolerance") {
  CHECK(rounded(1e-9) == "1 × 10⁻⁹");
  CHECK(rounded(1.0000001e-9) == "1.0 × 10⁻⁹");
}

TEST_CASE("what is not finite reads as not computed, and has no unit") {
  CHECK(rounded(std::numeric_limits<double>::quiet_NaN(), "m") == "not computed");
  CHECK(rounded(-std::numeric_limits<double>::infinity()) == "not computed");
}

TEST_CASE("a unit is set with real dots and exponents") {
  CHECK(unit_text("kg*m^2") == "kg·m²");
  CHECK(unit_text("m/s^2") == "m/s²");
  CHECK(unit_text("s^-1") == "s⁻¹");
  CHECK(unit_text("") == "");
  CHECK(unit_text("^") == "");
  CHECK(rounded(2.5, "N*m") == "2.5 N·m");
}

TEST_CASE("control characters and broken UTF-8 do not reach a file") {
  CHECK(clean(std::string("a\0b\x01\x1b[31m\tc\n", 12)) == "ab[31m\tc\n");
  CHECK(clean("\xff\xfe") == "\uFFFD\uFFFD");
  CHECK(clean("\xed\xa0\x80") == "\uFFFD\uFFFD\uFFFD");  // half of a surrogate pair
  CHECK(clean("end \xe2\x82") == "end \uFFFD\uFFFD");    // cut in the middle
  CHECK(clean("\uFFFE\u0085x") == "x");
  CHECK(clean("Tiny \uFDD0\uFDEF\U0001FFFF!") == "Tiny !");  // valid UTF-8, and never a character
  CHECK(clean("Prüfung 机构 𝛼") == "Prüfung 机构 𝛼");
}

TEST_CASE("text cannot become markup, nor leave its attribute") {
  CHECK(escape("<a href=\"x\" b='y'>&amp;") == "&lt;a href=&quot;x&quot; b=&#39;y&#39;&gt;&amp;amp;");
}

TEST_CASE("base64 gives the examples of RFC 4648") {
  CHECK(base64("") == "");
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string("\0\xff", 2)) == "AP8=");
}

TEST_CASE("the size of a file has a unit that suits it") {
  CHECK(size_of(0) == "0 B");
  CHECK(size_of(999) == "999 B");
  CHECK(size_of(1000) == "1.0 kB");
  CHECK(size_of(9949) == "9.9 kB");
  CHECK(size_of(9960) == "10 kB");
  CHECK(size_of(999499) == "999 kB");
  CHECK(size_of(999500) == "1.0 MB");
  CHECK(size_of(28'000'000'000) == "28 GB");
}
