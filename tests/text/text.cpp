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
