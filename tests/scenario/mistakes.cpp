#include <sys/stat.h>
#include <catch2/catch.hpp>
#include <tests/scenario/trial.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace trial;
using Catch::Contains;

TEST_CASE("all mistakes of a file are told in one run, in its order") {
  const std::filesystem::path folder = std::filesystem::path(SOURCE) / "tests/scenario";
  CHECK(told(read(folder / "many_mistakes.toml"), "many_mistakes.toml") + "\n" == read(folder / "many_mistakes.txt"));
}

TEST_CASE("the sound scenario is sound") { CHECK(told(std::string(sound)).empty()); }

TEST_CASE("an empty file is refused with what a scenario needs") {
  for (const char* text : {"", "\n\n", "  \n\t\n"}) {
    CAPTURE(text);
    CHECK_THAT(told(text), Contains("a.toml: error: expected a scenario, seen an empty file\n  hint: a scenario has title"));
  }
}

TEST_CASE("what is not there is asked for") {
  CHECK_THAT(told("# nothing\n"), Contains("expected the key \"title\"") && Contains("expected the table [mechanism]") &&
                                      Contains("expected the table [motion]") && Contains("expected at least one section"));
  CHECK_THAT(told(with("duration = \"2 s\"\nsamples = 21\n", "")),
             Contains("expected the key \"duration\" in [motion]") && Contains("expected the key \"samples\" in [motion]"));
  CHECK_THAT(told(with("\"Stage\"", "\" \"")), Contains("expected a title, seen an empty text"));
}

TEST_CASE("texts have a length within which they can be broken into lines") {
  CHECK_THAT(told(with("\"Stage\"", "\"" + std::string(301, 'x') + "\"")), Contains("a.toml:1:9: error: expected at most 300 characters"));
  CHECK(told(with("\"Stage\"", "\"" + std::string(300, 'x') + "\"")).empty());
  const auto described = [](const std::string& text) { return told("description = \"\"\"" + text + "\"\"\"\n" + std::string(sound)); };
  CHECK_THAT(described(std::string(100'000, 'x')), Contains("expected at most 10000 characters for description, seen 100000"));
  CHECK_THAT(described(std::string(8000, '\n')), Contains("expected at most 200 lines"));
  CHECK(described(std::string(10'000, 'x')).empty());
}

TEST_CASE("a text holds no control characters but tabs and line breaks, wherever it stands") {
  CHECK(told("description = \"\"\"a\\tb\\r\\n\nc\"\"\"\n" + std::string(sound)).empty());
  CHECK(told("description = \"caf\\u00e9 \\u2028 90\\u00b0\"\n" + std::string(sound)).empty());
  CHECK(told("description = \"ab\\u0000c\"\n" + std::string(sound)) ==
        "a.toml:1:15: error: expected a text for \"description\" without control characters but tabs and line breaks, seen U+0000 as its "
        "character 3\n"
        "  description = \"ab\\u0000c\"\n"
        "                ^");
  CHECK_THAT(told("author = \"\\u00e9\\u007f\"\n" + std::string(sound)), Contains("seen U+007F as its character 2"));
  CHECK_THAT(told("author = \"\\u0085\"\n" + std::string(sound)), Contains("seen U+0085 as its character 1"));
  CHECK_THAT(told(with("\"Stage\"", "\"\\u001b[31m\"")), Contains("a text for \"title\"") && !Contains("key \"title\""));
  CHECK_THAT(told(with("phi = \"5 deg\"", "phi = \"5\\b deg\"")), Contains("a.toml:9:7: error: expected a text for \"motion.phi\""));
  CHECK_THAT(told(std::string(sound) + "\n[[section]]\nkind = \"snapshots\"\ntimes = [\"0 s\", \"1 \\u0001s\"]\n"),
             Contains("a text for \"section.times\"") && Contains("seen U+0001 as its character 3"));
}

TEST_CASE("a pipe is no scenario, and keeps nobody waiting") {
  const Folder folder;
  const auto pipe = folder.path() / "pipe.toml";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_AS(pmreport::scenario::load(pipe, stage::source(), pmreport::section::kinds()), ScenarioError);
}

TEST_CASE("a syntax error is told with its place") {
  CHECK(told(with("phi = \"5 deg\"", "phi = 5 deg")) ==
        "a.toml:9:9: error: Error while parsing key-value pair: expected a comment or whitespace, saw 'd'\n"
        "  phi = 5 deg\n"
        "          ^\n"
        "  hint: quote it: \"5 deg\"");
  CHECK_THAT(told(with("phi = \"5 deg\"", "phi = 5 deg # half a turn")), Contains("hint: quote it: \"5 deg\""));
  CHECK_THAT(told(with("phi = \"5 deg\"", "phi = \"5 deg")), Contains("a.toml:9:13: error: ") && !Contains("hint"));
  CHECK_THAT(told("[=]"), Contains("a.toml:1:2: error: "));
  CHECK_THAT(told("\xEF\xBB\xB5 = 1\n"), Contains("a.toml:1:1: error: "));  // U+FEF5
  CHECK_THAT(told("a = " + std::string(100000, '[')), Contains("a.toml:1:45: error: expected at most 40 levels of tables and lists"));
  CHECK_THAT(told("title = \"\xFF\"\n"), Contains("a.toml:1:"));
  CHECK_THAT(told("a = 1\na = 2\n"), Contains("a.toml:2:"));
  CHECK_THAT(told("x = " + std::string(5000, '1') + "x\n"), Contains("a.toml:1:") && !Contains("11111111"));
}

TEST_CASE("a value of another type is refused") {
  const std::pair<const char*, const char*> cases[] = {
      {"title = 3", "expected a text in quotes, seen the number 3"},
      {"title = [1]", "expected a text in quotes, seen a list"},
      {"title = 2020-01-01", "expected a text in quotes, seen a date or time"},
      {"title = true", "expected a text in quotes, seen true"},
      {"title = {a = 1}", "expected a text in quotes, seen a table"},
  };
  for (const auto& [line, message] : cases) {
    CAPTURE(line);
    CHECK_THAT(told(with("title = \"Stage\"", line)), Contains(message));
  }
  CHECK_THAT(told(with("[[section]]", "[section]")), Contains("write [[section]] with two brackets, once for each"));
  CHECK_THAT(told("section = [1]\n" + std::string(sound.substr(0, sound.find("[[")))),
             Contains("expected a table [[section]], seen the number 1"));
  CHECK_THAT(told("motion = 3\n" + with("[motion]", "[load]")), Contains("expected a table [motion], seen the number 3"));
  CHECK_THAT(told(with("{ arm = \"200 mm\" }", "3")), Contains("expected a table [mechanism.parameters], seen the number 3"));
}

TEST_CASE("a quantity of another dimension says what was expected") {
  CHECK(told(with("5 deg", "5 mm")) ==
        "a.toml:9:7: error: expected an angle (e.g. \"5 deg\"), seen a length\n"
        "  phi = \"5 mm\"\n"
        "        ^");
  CHECK(told(with("\"5 deg\"", "5")) ==
        "a.toml:9:7: error: expected an angle (e.g. \"5 deg\"), seen the number 5 without a unit\n"
        "  phi = 5\n"
        "        ^\n"
        "  hint: write \"5 deg\", with the unit that you mean");
  CHECK_THAT(told(with("\"200 mm\"", "\"200\"")),
             Contains("expected a length (e.g. \"250 mm\"), seen a plain number") && Contains("hint: give it a unit, such as mm"));
  CHECK(told(with("20 mm * sin(2*pi*t/10 s)", "20 mm * (1 + 2 deg)")) ==
        "a.toml:8:19: error: cannot add a plain number and an angle\n"
        "  x = \"20 mm * (1 + 2 deg)\"\n"
        "                    ^");
}

TEST_CASE("the caret finds its place behind letters of many bytes") {
  CHECK(told(with("phi = \"5 deg\"", "phi = \"90° + 2 µm\" # π")) ==
        "a.toml:9:14: error: cannot add an angle and a length\n"
        "  phi = \"90° + 2 µm\" # π\n"
        "               ^");
  // written with an escape, the place inside the text cannot be known
  CHECK_THAT(told(with("phi = \"5 deg\"", "phi = \"90\\u00b0 + 2 mm\"")), Contains("a.toml:9:7: error: cannot add"));
}

TEST_CASE("what is not finite is refused and named") {
  CHECK_THAT(told(with("\"200 mm\"", "nan")),
             Contains("a.toml:4:22: error: expected a finite number for \"mechanism.parameters.arm\", seen nan"));
  CHECK_THAT(told(with("samples = 21", "samples = inf")), Contains("expected a finite number for \"motion.samples\", seen inf"));
  CHECK_THAT(told(with("samples = 21", "samples = -inf")), Contains("expected a finite number for \"motion.samples\", seen inf"));
  CHECK_THAT(told(with("\"5 deg\"", "\"nan deg\"")), Contains("expected a finite number, seen nan"));
  CHECK_THAT(told(with("\"200 mm\"", "\"1 mm / 0\"")), Contains("expected a finite number, but \"1 mm / 0\" has no such value"));
  CHECK_THAT(told(with_more("[load]\nforce = [nan, inf, \"0 N\"]\n")),
             Contains("\"load.force\", seen nan") && Contains("\"load.force\", seen inf"));
}

TEST_CASE("the number of samples is from two to a million") {
  const auto tell = [](const char* count) { return told(with("samples = 21", std::string("samples = ") + count)); };
  CHECK_THAT(tell("0"), Contains("expected 2 to 1000000 samples, seen 0"));
  CHECK_THAT(tell("1"), Contains("expected 2 to 1000000 samples, seen 1"));
  CHECK_THAT(tell("-5"), Contains("seen -5"));
  CHECK(tell("2").empty());
  CHECK_THAT(tell("1000000000"),
             Contains("expected 2 to 1000000 samples, seen 1000000000; 1e9 samples would take about 3700 GB of memory and 14 h"));
  CHECK_THAT(tell("2.5"), Contains("expected a whole number of samples, seen the number 2.5"));
  CHECK_THAT(tell("\"501\""), Contains("expected a whole number of samples, seen the text \"501\""));
  CHECK_THAT(told(with("\"2 s\"", "\"-2 s\"")), Contains("expected a duration above 0 s, seen -2 s"));
}

TEST_CASE("an unknown key is told with the nearest and with all") {
  CHECK(told(with("samples = 21", "samples = 21\nsampels = 3")) ==
        "a.toml:8:1: error: unknown key \"sampels\" in [motion]; did you mean \"samples\"?\n"
        "  sampels = 3\n"
        "  ^\n"
        "  hint: the keys are duration, samples, until, profile, waypoint, file, unwrap and from; and the coordinates x and phi, or the "
        "actuators "
        "q and "
        "psi, "
        "each also by its rate, x_rate");
  CHECK_THAT(told(with("samples = 21", "samples = 21\nsomething = 3")), Contains("unknown key \"something\" in [motion]\n"));
  CHECK_THAT(told("tilte = 1\n" + std::string(sound)), Contains("did you mean \"title\"?"));
  CHECK_THAT(told("\"\\u001b[31m\" = 1\n" + std::string(sound)),
             Contains("a.toml:1:1: error: expected a key without control characters") && !Contains("\x1b") && !Contains("unknown"));
}

TEST_CASE("a mechanism that is not there is told with those that are") {
  CHECK(told(with("\"stage\"", "\"stge\"")) ==
        "a.toml:3:7: error: no mechanism is called \"stge\"; did you mean \"stage\"?\n"
        "  use = \"stge\"\n"
        "        ^\n"
        "  hint: the mechanisms are stage and stewart");
}

TEST_CASE("what a section's keys name of a mechanism that is not there is no second mistake") {
  const std::string text =
      "title = \"a\"\n[mechanism]\nuse = \"stge\"\n[[section]]\nkind = \"stiffness\"\n"
      "map = { x = [\"-1 mm\", \"1 mm\"], phi = [\"-1 deg\", \"1 deg\"], show = [\"pF_max\"] }\n"
      "[[check]]\nthat = \"stiffness.map_max_pF_max\"\nbelow = \"1 um/N\"\n";
  const std::string said = told(text);
  CHECK_THAT(said, Contains("no mechanism is called \"stge\""));
  CHECK_THAT(said, !Contains("no quantity is called"));
}

TEST_CASE("a parameter out of its range is told in the unit of the reader") {
  CHECK_THAT(told(with("200 mm", "5 mm")), Contains("expected 10 mm to 1000 mm for arm, seen 5 mm"));
  CHECK(told(with("200 mm", "1000 mm")).empty());
  CHECK(told(with("200 mm", "10 mm")).empty());
  CHECK_THAT(told(with("arm = \"200 mm\"", "cone = \"200 deg\"")), Contains("expected 0 deg to 180 deg for cone, seen 200 deg"));
  CHECK(told(with("arm = \"200 mm\"", "cone = \"180 deg\"")).empty());
  CHECK_THAT(told(with("arm = \"200 mm\"", "ratio = 0.5")), Contains("expected 1 to 3 for ratio, seen 0.5"));
  CHECK_THAT(told(with("arm = \"200 mm\"", "grid = [\"1 mm\"]")), Contains("expected a list of 2 to 4 numbers for grid, seen 1"));
  CHECK_THAT(told(with("arm = \"200 mm\"", "grid = \"1 mm\"")),
             Contains("expected a list of 2 to 4 numbers for grid, seen the text \"1 mm\""));
  CHECK_THAT(told(with("arm = \"200 mm\"", "dependent = \"x\"")), Contains("expected \"y\" or \"phi\", seen \"x\""));
}

TEST_CASE("parameters that the mechanism refuses are told where they stand") {
  CHECK_THAT(told(with("arm = \"200 mm\"", "arm = \"200 mm\", stroke_min = \"1 m\"")),
             Contains("a.toml:4:32: error: stage refuses its parameters: stroke_min must be less than stroke_max"));
}

TEST_CASE("a dependent coordinate cannot be given") {
  CHECK(told(with("phi = \"5 deg\"", "y = \"1 mm\"")) ==
        "a.toml:9:1: error: y is a dependent coordinate of stage: it follows from the others and cannot be given\n"
        "  y = \"1 mm\"\n"
        "  ^\n"
        "  hint: leave it out, or let another coordinate follow: dependent = \"phi\" in [mechanism.parameters]");
  std::string chosen = with("phi = \"5 deg\"", "y = \"1 mm\"");
  chosen.replace(chosen.find("arm = \"200 mm\""), 14, "dependent = \"phi\"");
  CHECK(told(chosen).empty());
}

TEST_CASE("the choice of coordinates holds although other parameters are wrong") {
  std::string text = with("phi = \"5 deg\"", "y = \"1 mm\"");
  text.replace(text.find("arm = \"200 mm\""), 14, "dependent = \"phi\", arm = \"9 m\"");
  CHECK(mistakes(text).size() == 1);
}

TEST_CASE("a section has the options of its kind") {
  CHECK_THAT(told(with_more("times = [\"0 s\"]\n")), Contains("unknown key \"times\" in a section of kind \"displacement\""));
  CHECK_THAT(told(with("\"displacement\"", "\"snapshot\"")),
             Contains("expected one of the kinds of section, seen \"snapshot\"; did you mean \"snapshots\"?"));
  CHECK_THAT(told(with_more("[[section]]\nkind = \"displacement\"\n")),
             Contains("a report has one section \"displacement\"; the first is in line 10"));
  const auto snapshots = [](const char* option) { return told(with_more(std::string("[[section]]\nkind = \"snapshots\"\n") + option)); };
  CHECK(snapshots("").empty());
  CHECK_THAT(snapshots("times = [\"3 s\"]"), Contains("expected a time within the motion, 0 s to 2 s, seen 3 s"));
  CHECK_THAT(snapshots("times = []"), Contains("expected a list of 1 to 100 times, seen 0"));
  CHECK_THAT(snapshots("views = [\"front\", \"front\"]"), Contains("the view \"front\" stands here twice"));
  CHECK_THAT(snapshots("views = [{azimuth = \"0 deg\", elevation = \"91 deg\"}]"),
             Contains("expected an elevation from -90 deg to 90 deg, seen 91 deg"));
  CHECK_THAT(snapshots("size = [10, 100000]"), Contains("from 64 to 8000, seen the number 10\n") && Contains("seen the number 100000"));
  CHECK_THAT(snapshots("size = [1]"), Contains("expected a list of width and height in pixels, seen 1 items"));
  CHECK_THAT(snapshots("overlay = 1"), Contains("expected 2 to 12 poses, or 0 for no such picture, seen 1"));
  CHECK_THAT(snapshots("overlay = 13"), Contains("from 0 to 12, seen the number 13"));
  CHECK_THAT(snapshots("ground = \"black\""), Contains("expected \"white\" or \"transparent\", seen \"black\""));
  CHECK_THAT(snapshots("path = 1"), Contains("expected true or false, seen the number 1"));
}

TEST_CASE("a check names columns that the report has, with bounds of their dimension") {
  const auto check = [](const std::string& lines) { return told(with_more("[[check]]\n" + lines)); };
  CHECK(check("that = \"max(x)\"\nbelow = \"1 m\"\n").empty());
  CHECK(check("that = \" rms( abs( x ) ) \"\nabove = \"1 m\"\n").empty());
  CHECK_THAT(check("that = \"max(x)\"\n"), Contains("expected a bound, below, above or equals, and there is none"));
  CHECK_THAT(check("that = \"max(x)\"\nbelow = \"1 N\"\n"), Contains("expected a length (e.g. \"250 mm\"), seen a force"));
  CHECK_THAT(check("that = \"max(x)\"\nbelow = \"1 m\"\nabove = \"2 m\"\n"), Contains("above must be less than below"));
  CHECK_THAT(check("that = \"max(q_force)\"\nbelow = \"1 N\"\n"),
             Contains("a.toml:13:13: error: \"q_force\" belongs to the section \"statics\"") &&
                 Contains("add [[section]] and kind = \"statics\""));
  CHECK_THAT(check("that = \"max(qq)\"\nbelow = \"1 N\"\n"), Contains("no column or group is called \"qq\"; did you mean \"q\"?"));
  CHECK_THAT(check("that = \"max(coordinate)\"\nbelow = \"1 m\"\n"),
             Contains("the columns of \"coordinate\" have different units") && Contains("name one of them: x, phi or y"));
  CHECK_THAT(check("that = \"mean(x)\"\nbelow = \"1 m\"\n"), Contains("expected min, max, rms or at, seen \"mean\""));
  CHECK_THAT(check("that = \"max(sin(x))\"\nbelow = \"1 m\"\n"), Contains("a.toml:13:13: error: expected abs or a column, seen \"sin\""));
  CHECK_THAT(check("that = \"x\"\nbelow = \"1 m\"\n"), Contains("expected a reduction of a column, seen \"x\""));
  CHECK_THAT(check("that = \"\"\nbelow = \"1 m\"\n"), Contains("expected a reduction of a column, seen \"\""));
  CHECK_THAT(check("that = \"at(x)\"\nbelow = \"1 m\"\n"), Contains("expected a comma and a time"));
  CHECK_THAT(check("that = \"at(x, 3 mm)\"\nbelow = \"1 m\"\n"),
             Contains("a.toml:13:15: error: expected a time (e.g. \"2.5 s\"), seen a length"));
  CHECK_THAT(check("that = \"at(x, 3 s)\"\nbelow = \"1 m\"\n"),
             Contains("a.toml:13:15: error: expected a time within the motion, 0 s to 2 s, seen 3 s"));
  CHECK_THAT(check("that = 3\nbelow = \"1 m\"\n"), Contains("expected a text in quotes, seen the number 3"));
}

TEST_CASE("what lies just outside a range does not read like its end") {
  CHECK_THAT(told(with("arm = \"200 mm\"", "arm = \"1000.0000004 mm\"")),
             Contains("expected 10 mm to 1000 mm for arm, seen 1000.0000004 mm"));
  CHECK_THAT(told(with_more("[[check]]\nthat = \"at(x, 2.0000001 s)\"\nbelow = \"1 m\"\n")),
             Contains("expected a time within the motion, 0 s to 2 s, seen 2.0000001 s"));
}

TEST_CASE("a check that equals a number says how near, unless it counts") {
  const auto check = [](const std::string& lines) { return told(with_more("[[check]]\n" + lines)); };
  CHECK(check("that = \"max(x)\"\nequals = \"20 mm\"\nwithin = \"1 um\"\n").empty());
  const std::string counted = "[[section]]\nkind = \"mobility\"\n[[check]]\nthat = \"mobility.freedoms\"\n";
  CHECK(told(with_more(counted + "equals = 2\n")).empty());
  CHECK(told(with_more(counted + "equals = 2\nwithin = 1\n")).empty());
  CHECK_THAT(
      check("that = \"max(x)\"\nequals = \"20 mm\"\n"),
      Contains("a.toml:14:1: error: expected within beside equals, for \"max(x)\" is no whole number") && Contains("within = \"250 mm\""));
  CHECK_THAT(check("that = \"max(x)\"\nequals = \"20 mm\"\nwithin = \"0 mm\"\n"),
             Contains("a.toml:15:10: error: expected a distance above 0, seen \"0 mm\""));
  CHECK_THAT(check("that = \"max(x)\"\nequals = \"20 mm\"\nwithin = \"1 N\"\n"), Contains("seen a force"));
  CHECK_THAT(check("that = \"max(x)\"\nequals = \"20 mm\"\nwithin = \"1 mm\"\nbelow = \"1 m\"\n"),
             Contains("equals says all: below says nothing beside it"));
  CHECK_THAT(check("that = \"max(x)\"\nbelow = \"1 m\"\nwithin = \"1 mm\"\n"), Contains("within is of equals, which is not there"));
}

TEST_CASE("tables nested beyond all sense are refused with their place, whatever else the text is") {
  const auto repeated = [](const std::string& part, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += part;
    return out;
  };
  constexpr int deep = 30000;  // a tree so deep took all of the stack
  const std::string refused = "expected at most 40 levels of tables and lists in each other, seen more";
  CHECK_THAT(told(with_more(repeated("a.", deep) + "a = 1\n")), Contains("a.toml:12:80: error: " + refused));
  CHECK_THAT(told(with_more("[" + repeated("a.", deep) + "a]\n")), Contains("a.toml:12:81: error: " + refused));
  CHECK_THAT(told(with_more(repeated("\"a\" . ", deep) + "a = 1\n")), Contains("a.toml:12:239: error: " + refused));
  CHECK_THAT(told(with_more("a = " + repeated("[", deep) + repeated("]", deep) + "\n")), Contains("a.toml:12:45: error: " + refused));
  CHECK_THAT(told(with_more("a = " + repeated("{a = ", deep) + "1" + repeated("}", deep) + "\n")), Contains(refused));
  CHECK_THAT(told(with_more("a = " + repeated("[", deep))), Contains(refused));
  // Points and brackets in texts and comments nest nothing.
  const std::string idle = repeated("[.", deep);
  CHECK_THAT(told(with_more("# " + idle + "\nauthor = \"" + idle + "\"\nx = '''\n" + idle + "''' # \"\n")), !Contains(refused));
  CHECK_THAT(told(with_more("author = \"\\\"" + idle + "\"\n")), !Contains(refused));
  // A text that is not closed ends with its line, as the parser sees it.
  CHECK_THAT(told(with_more("author = \"open\n" + repeated("a.", deep) + "a = 1\n")), Contains("a.toml:13:80: error: " + refused));
}

TEST_CASE("a load has three components of its dimension") {
  const auto load = [](const std::string& line) { return told(with_more("[load]\n" + line + "\n")); };
  CHECK(load("force = [\"1 N\", \"1 kN * t/1 s\", \"-5 mN\"]").empty());
  CHECK_THAT(load("force = [\"1 N\"]"), Contains("expected a list of three components, x y z in base axes, seen 1 items"));
  CHECK_THAT(load("force = \"1 N\""), Contains("seen the text \"1 N\""));
  CHECK_THAT(load("moment = [\"1 N\", \"1 N*m\", \"1 N*m\"]"),
             Contains("a.toml:13:11: error: expected a moment (e.g. \"10 N*m\"), seen a force"));
  CHECK_THAT(load("gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2 * t/1 s\"]"),
             Contains("expected a constant quantity, seen one that depends on t"));
  CHECK_THAT(load("force = [\"0 N\", \"0 N\", \"1 N * 1 s / t\"]"), Contains("force has no finite value at t = 0 s"));
  CHECK_THAT(load("torque = 1"), Contains("unknown key \"torque\" in [load]"));
}

TEST_CASE("a file is read up to four mebibytes") {
  const Folder folder;
  std::string text(sound);
  text += "#" + std::string((4u << 20) - text.size() - 1, 'x');
  REQUIRE(text.size() == 4u << 20);
  CHECK(load(folder.write("fits.toml", text), stage::source(), section::kinds()).scenario.title == "Stage");
  const auto large = folder.write("large.toml", text + "x");
  CHECK_THROWS_WITH(load(large, stage::source(), section::kinds()),
                    Contains("large.toml: error: expected at most 4 MiB, seen 4194305 bytes"));
  CHECK_THROWS_WITH(load(folder.path() / "none.toml", stage::source(), section::kinds()),
                    Contains("none.toml: error: there is no such file"));
  CHECK_THROWS_WITH(load(folder.path(), stage::source(), section::kinds()), Contains("expected a scenario file, seen a folder"));
  CHECK_THROWS_WITH(load(folder.write("机构.toml", with("5 deg", "5 mm")), stage::source(), section::kinds()),
                    Contains("机构.toml:9:7: error: "));
}

TEST_CASE("a file full of mistakes is told up to a hundred") {
  std::string text(sound);
  for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + " = 1\n";
  CHECK(mistakes(text).size() == 100);
}
