#include <tests/judges/calculix_deck.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace pmreport::judges {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

// Of a beam's bending: what its shear would add to it, 12 E I / (k G A l^2). Its formulas are exact in the limit, and lose no digits there.
constexpr double shear_share = 1e-8;
// Below a half, which CalculiX refuses.
constexpr double largest_poisson = 0.49;
// Of relations whose largest coefficient is one: what rounding leaves of one that follows from others. The geometry is good to 1e-14, and
// poses near a singular one, where a true relation might become so small, are not judged.
constexpr double follows = 1e-9;
constexpr double nothing = 1e-13;  // a coefficient that is rounding

// A folder that goes away with what is in it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "calculix-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder " + name);
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const char* file) const { return path_ / file; }
  std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

// In twenty characters, which is what CalculiX reads of a number, as many digits as fit.
std::string number(double x) {
  for (int digits = 17;; --digits)
    if (std::string out = fmt::format("{:.{}g}", x, digits); out.size() <= 20) return out.find_first_of(".e") == out.npos ? out + "." : out;
}

// A number of Fortran's: an exponent of three digits has taken the place of its letter, and means nothing.
double read_number(const std::string& field) { return field.find('E') == std::string::npos ? 0 : std::strtod(field.c_str(), nullptr); }

}  // namespace

int CalculixDeck::add_node(const Vector3d& at) {
  nodes_.push_back(at);
  return nodes() - 1;
}

int CalculixDeck::add_rigid(const Vector3d& at) {
  const int node = add_node(at), end = add_node(at + 0.1 * Vector3d::UnitZ());  // [m], [N], [N m^2]: whatever, it carries nothing
  add_bar(node, end, {1e8, 1e4, 1e4, 1e4, Vector3d::UnitX()});
  return node;
}

int CalculixDeck::add_spring(double stiffness) {
  springs_.push_back({add_node(Vector3d::Zero()), stiffness});
  return springs_.back().node;
}

int CalculixDeck::add_gauge(std::vector<Term> terms) {
  gauges_.push_back({add_node(Vector3d::Zero()), std::move(terms)});
  return gauges_.back().node;
}

// Twisting is G (Ix + Iy), G = E / 2 (1 + poisson) the shear modulus that makes it right; E is one, and areas and moments are rigidities.
void CalculixDeck::add_bar(int from, int to, const Bar& bar) {
  const Vector3d axis = place(to) - place(from), n = axis.normalized(), y = n.cross(bar.x);
  if (!(std::abs(n.dot(bar.x)) < 1e-9)) throw std::invalid_argument("the x axis of a bar is not across it");
  const double both = bar.bending_x + bar.bending_y, l = axis.norm();
  double poisson = both / (2 * bar.torsion) - 1;
  if (poisson > largest_poisson) {
    poisson = largest_poisson;
    const double missing = l / bar.torsion - 2 * l * (1 + poisson) / both;
    const int end = add_node(place(to)), twist = add_spring(1 / missing);
    for (int k = 0; k < 3; ++k) {
      relate({{to, k, 1}, {end, k, -1}});
      relate({{to, 3 + k, 1}, {end, 3 + k, -1}, {twist, 0, -n(k)}});
    }
    to = end;
  }
  const double shear_modulus = 1 / (2 * (1 + poisson)), area = 0.5 * bar.axial;
  const auto beam = [&](const Vector3d& direction, double second) {
    beams_.push_back({from, to, direction, 1, poisson, area, second, 12 * second / (shear_share * shear_modulus * area * l * l)});
  };
  beam(bar.x, bar.bending_y);
  beam(y, bar.bending_x);
}

// Gauss and Jordan, with the largest coefficient left anywhere as the pivot; then the gauges, in what is left free.
std::string CalculixDeck::equations() const {
  const auto rows = static_cast<Index>(relations_.size()), columns = static_cast<Index>(6 * nodes_.size());
  const auto put = [&](MatrixXd& a, Index row, const std::vector<Term>& terms) {
    for (const Term& t : terms)
      if (t.node != base) a(row, 6 * t.node + t.freedom) += t.coefficient;
  };
  MatrixXd a = MatrixXd::Zero(rows, columns), g = MatrixXd::Zero(static_cast<Index>(gauges_.size()), columns);
  for (Index r = 0; r < rows; ++r) put(a, r, relations_[static_cast<std::size_t>(r)]);
  for (Index r = 0; r < g.rows(); ++r) put(g, r, gauges_[static_cast<std::size_t>(r)].terms);
  std::vector<Index> pivots;
  for (Index done = 0; done < rows; ++done) {
    Index row = 0, column = 0;
    if (!(a.bottomRows(rows - done).cwiseAbs().maxCoeff(&row, &column) > follows)) break;
    a.row(done).swap(a.row(done + row));
    a.row(done) /= a(done, column);
    for (Index r = 0; r < rows; ++r)
      if (const double share = a(r, column); r != done && share != 0) {
        a.row(r) -= share * a.row(done);
        a(r, column) = 0;
      }
    pivots.push_back(column);
  }
  std::string out;
  const auto write = [&](Index dependent, const Eigen::RowVectorXd& row) {
    std::vector<Term> terms{{static_cast<int>(dependent / 6), static_cast<int>(dependent % 6), 1}};
    for (Index c = 0; c < columns; ++c)
      if (c != dependent && std::abs(row(c)) > nothing) terms.push_back({static_cast<int>(c / 6), static_cast<int>(c % 6), row(c)});
    if (terms.size() == 1) {
      out += fmt::format("*BOUNDARY\n{0},{1},{1}\n", terms[0].node + 1, terms[0].freedom + 1);
      return;
    }
    out += fmt::format("*EQUATION\n{}\n", terms.size());
    for (std::size_t k = 0; k < terms.size(); ++k)
      out += fmt::format("{},{},{}{}", terms[k].node + 1, terms[k].freedom + 1, number(terms[k].coefficient),
                         k % 4 == 3 || k + 1 == terms.size() ? "\n" : ",");
  };
  for (std::size_t i = 0; i < pivots.size(); ++i) write(pivots[i], a.row(static_cast<Index>(i)));
  for (Index r = 0; r < g.rows(); ++r) {
    for (std::size_t i = 0; i < pivots.size(); ++i)
      if (const double share = g(r, pivots[i]); share != 0) {
        g.row(r) -= share * a.row(static_cast<Index>(i));
        g(r, pivots[i]) = 0;
      }
    write(6 * gauges_[static_cast<std::size_t>(r)].node, -g.row(r));
  }
  return out;
}

std::string CalculixDeck::input(const std::vector<Loads>& cases, const std::vector<int>& watched) const {
  std::string out = "*NODE\n";
  const auto vector = [](const Vector3d& v) { return fmt::format("{},{},{}", number(v.x()), number(v.y()), number(v.z())); };
  for (std::size_t i = 0; i < nodes_.size(); ++i) out += fmt::format("{},{}\n", i + 1, vector(nodes_[i]));
  for (std::size_t i = 0; i < beams_.size(); ++i)
    out += fmt::format("*ELEMENT,TYPE=U1,ELSET=B{0}\n{0},{1},{2}\n", i + 1, beams_[i].from + 1, beams_[i].to + 1);
  out += "*USER ELEMENT,TYPE=U1,NODES=2,INTEGRATION POINTS=2,MAXDOF=6\n";
  for (std::size_t i = 0; i < springs_.size(); ++i)
    out += fmt::format("*ELEMENT,TYPE=SPRING1,ELSET=S{0}\n{1},{2}\n*SPRING,ELSET=S{0}\n1\n\n{3}\n*BOUNDARY\n{2},2,3\n", i + 1,
                       beams_.size() + i + 1, springs_[i].node + 1, number(springs_[i].stiffness));
  for (std::size_t i = 0; i < beams_.size(); ++i) {
    const Beam& b = beams_[i];
    out += fmt::format("*MATERIAL,NAME=M{0}\n*ELASTIC\n{1},{2}\n*BEAM SECTION,ELSET=B{0},MATERIAL=M{0},SECTION=GENERAL\n", i + 1,
                       number(b.modulus), number(b.poisson));
    out += fmt::format("{},{},0.,0.,{}\n{}\n", number(b.area), number(b.second), number(b.shear), vector(b.direction));
  }
  out += equations();
  out += "*NSET,NSET=WATCHED\n";
  for (const int node : watched) out += fmt::format("{}\n", node + 1);
  for (const Loads& loads : cases) {
    out += "*STEP\n*STATIC\n*CLOAD,OP=NEW\n";
    for (const Load& load : loads)
      for (int k = 0; k < 6; ++k)
        if (load.wrench(k) != 0) out += fmt::format("{},{},{}\n", load.node + 1, k + 1, number(load.wrench(k)));
    out += "*NODE PRINT,NSET=WATCHED\nU\n*END STEP\n";
  }
  return out;
}

std::vector<Displacements> CalculixDeck::solve(const std::vector<Loads>& cases, const std::vector<int>& watched) const {
  const Folder folder;
  std::ofstream(folder / "deck.inp") << input(cases, watched);
  const int status = std::system(fmt::format("cd '{}' && OMP_NUM_THREADS=1 '{}' deck > words 2>&1", folder.name(), CCX).c_str());
  const std::string words = text_of(folder / "words");
  if (status != 0 || words.find("*ERROR") != std::string::npos) throw std::runtime_error("CalculiX: " + words);

  // One line a node: ten characters its number, then fourteen each displacement.
  std::vector<Index> column(nodes_.size(), 0);
  for (std::size_t i = 0; i < watched.size(); ++i) column[static_cast<std::size_t>(watched[i])] = static_cast<Index>(i);
  std::vector<Displacements> out;
  std::ifstream answers(folder / "deck.dat");
  for (std::string line; std::getline(answers, line);) {
    if (line.find("displacements") != std::string::npos) {
      out.emplace_back(Displacements::Zero(6, static_cast<Index>(watched.size())));
    } else if (line.size() >= 94 && !out.empty()) {
      const auto node = static_cast<std::size_t>(std::stoi(line.substr(0, 10)) - 1);
      for (std::size_t k = 0; k < 6; ++k) out.back()(static_cast<Index>(k), column.at(node)) = read_number(line.substr(10 + 14 * k, 14));
    }
  }
  if (out.size() != cases.size())
    throw std::runtime_error(fmt::format("CalculiX answers {} of {} cases: {}", out.size(), cases.size(), words));
  return out;
}

}  // namespace pmreport::judges
