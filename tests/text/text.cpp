#include <catch2/catch.hpp>
#include <core/text/text.hpp>

using namespace pmreport;

TEST_CASE("what is never a character is replaced, and its neighbours stay") {
  CHECK(without_noncharacters("a\uFDD0b\uFDEFc") == "a\uFFFDb\uFFFDc");
  CHECK(without_noncharacters("\uFFFE\uFFFF") == "\uFFFD\uFFFD");
  CHECK(without_noncharacters("\U0001FFFE\U0008FFFF\U0010FFFF") == "\uFFFD\uFFFD\uFFFD");
  const std::string sound = "Prüfung 机构 𝛼 \uFDCF\uFDF0\uFFFD\U0001FFFD\U0010FFFD\U0002003F";
  CHECK(without_noncharacters(sound) == sound);
}

TEST_CASE("what would steer a terminal or turn the direction of reading is not printed") {
  CHECK(printable("a\x1b[31mb") == "a?[31mb");
  CHECK(printable("a\xc2\x9b"
                  "31mb") == "a?31mb");  // CSI as one character
  CHECK(printable("a\xe2\x80\xae"
                  "b\xe2\x81\xa6"
                  "c") == "a?b?c");
  CHECK(printable("μ = 3 °, ‖J‖ \xc2\xa0") == "μ = 3 °, ‖J‖ \xc2\xa0");
}

TEST_CASE("words of somebody else are one line of valid UTF-8") {
  CHECK(one_line("arm 1") == "arm 1");
  CHECK(one_line("μ ‖J‖ 机构 \U0001F600") == "μ ‖J‖ 机构 \U0001F600");
  CHECK(one_line("a\nb\r\n\tc") == "a b   c");
  CHECK(one_line("a\x1b[31m") == "a?[31m");
  CHECK(one_line("") == "");
  const std::string none = "\uFFFD";
  for (const std::string wrong : {"\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe0\x80\x80", "\xf0\x80\x80\x80"}) {
    std::string expected = "a";
    for (std::size_t i = 0; i < wrong.size(); ++i) expected += none;
    CHECK(one_line("a" + wrong + "z") == expected + "z");
  }
}
