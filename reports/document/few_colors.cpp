#include <reports/document/few_colors.hpp>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <unordered_map>
#include <vector>

namespace pmreport::document {

namespace {

constexpr std::size_t most_colors = 256;

struct Shade {
  std::uint32_t rgb;  // 0x00RRGGBB
  double pixels;      // that have it
  // What a mistake in it counts: less than its pixels, or the shades of a large pale ground would take the colours of small parts; yet
  // enough that the ground's fading shows no steps.
  double weight = std::pow(pixels, 0.75);
  double channel(int c) const { return (rgb >> (8 * c)) & 0xff; }
};

// Shades that become one colour, and what is lost by it: the weighted sum of squares along the channel where it is largest.
struct Group {
  std::span<Shade> shades;
  int widest = 0;
  double middle = 0, loss = 0;

  explicit Group(std::span<Shade> of) : shades(of) {
    double sum = 0;
    std::array<double, 3> first{}, second{};
    for (const Shade& s : shades) {
      sum += s.weight;
      for (int c = 0; c < 3; ++c) {
        const double x = s.channel(c), weighted = s.weight * x;
        first[static_cast<std::size_t>(c)] += weighted, second[static_cast<std::size_t>(c)] += weighted * x;
      }
    }
    for (int c = 0; c < 3; ++c) {
      const double mean = first[static_cast<std::size_t>(c)] / sum,
                   lost = second[static_cast<std::size_t>(c)] - mean * first[static_cast<std::size_t>(c)];
      if (lost > loss) loss = lost, widest = c, middle = mean;
    }
    // Rounding is no loss: shades that are alike in every channel are one.
    if (shades.size() < 2) loss = 0;
  }

  // The shade of most of its pixels, as white is of a ground; else their mean.
  std::uint32_t color() const {
    const Shade& most = *std::ranges::max_element(shades, {}, &Shade::pixels);
    double pixels = 0;
    std::array<double, 3> sum{};
    for (const Shade& s : shades) {
      pixels += s.pixels;
      for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c)] += s.pixels * s.channel(c);
    }
    if (2 * most.pixels > pixels) return most.rgb;
    std::uint32_t out = 0;
    for (int c = 0; c < 3; ++c) out |= static_cast<std::uint32_t>(std::lround(sum[static_cast<std::size_t>(c)] / pixels)) << (8 * c);
    return out;
  }
};

// The group that loses most is split at its mean, until there are as many as there may be.
std::vector<Group> grouped(std::vector<Shade>& shades) {
  std::vector<Group> groups{Group(shades)};
  const auto less = [](const Group& a, const Group& b) { return a.loss < b.loss; };  // a heap: the largest loss first
  while (groups.size() < most_colors && groups.front().loss > 0) {
    std::ranges::pop_heap(groups, less);
    const Group whole = groups.back();
    groups.pop_back();
    const auto upper = std::ranges::partition(whole.shades, [&](const Shade& s) { return s.channel(whole.widest) <= whole.middle; });
    const auto lower = whole.shades.first(whole.shades.size() - upper.size());
    for (const std::span<Shade> half : {lower, std::span<Shade>(upper.begin(), upper.end())}) {
      groups.emplace_back(half);
      std::ranges::push_heap(groups, less);
    }
  }
  return groups;
}

std::vector<Shade> shades_of(const std::vector<std::uint32_t>& pixels) {
  std::unordered_map<std::uint32_t, double> counts;
  for (std::size_t i = 0; i < pixels.size();) {
    std::size_t end = i + 1;  // of a run: most of a picture is ground
    while (end < pixels.size() && pixels[end] == pixels[i]) ++end;
    counts[pixels[i]] += static_cast<double>(end - i);
    i = end;
  }
  std::vector<Shade> shades;
  shades.reserve(counts.size());
  for (const auto& [rgb, count] : counts) shades.push_back({rgb, count});
  std::ranges::sort(shades, {}, &Shade::rgb);  // a table has an order of its own
  return shades;
}

std::string big_endian(std::uint32_t x) {
  std::string out;
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>((x >> shift) & 0xff);
  return out;
}

// Its length, its name, what it holds, and their checksum (PNG 1.2, 3.2).
std::string chunk(const std::string& name, const std::string& bytes) {
  const std::string summed = name + bytes;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(summed.data()), static_cast<uInt>(summed.size()));
  return big_endian(static_cast<std::uint32_t>(bytes.size())) + summed + big_endian(static_cast<std::uint32_t>(sum));
}

std::string deflated(const std::string& bytes) {
  constexpr int level = 7;  // the best, 9, takes three times as long for 4 %
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                level) != Z_OK)
    return "";
  out.resize(size);
  return out;
}

}  // namespace

std::string png_of_few_colors(cairo_surface_t* picture) {
  if (picture == nullptr || cairo_surface_status(picture) != CAIRO_STATUS_SUCCESS ||
      cairo_image_surface_get_format(picture) != CAIRO_FORMAT_RGB24)
    return "";
  cairo_surface_flush(picture);
  const auto width = static_cast<std::size_t>(cairo_image_surface_get_width(picture)),
             height = static_cast<std::size_t>(cairo_image_surface_get_height(picture)),
             stride = static_cast<std::size_t>(cairo_image_surface_get_stride(picture));
  std::vector<std::uint32_t> pixels(width * height);
  for (std::size_t y = 0; y < height; ++y)
    std::memcpy(pixels.data() + y * width, cairo_image_surface_get_data(picture) + y * stride, width * sizeof(std::uint32_t));
  for (std::uint32_t& pixel : pixels) pixel &= 0xffffff;  // the fourth byte is not in use
  std::vector<Shade> shades = shades_of(pixels);
  if (shades.empty()) return "";

  std::string palette;
  std::unordered_map<std::uint32_t, char> index;
  index.reserve(shades.size());
  const std::vector<Group> groups = grouped(shades);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    palette += big_endian(groups[k].color()).substr(1);
    for (const Shade& s : groups[k].shades) index.emplace(s.rgb, static_cast<char>(k));
  }
  // Without a filter: of numbers of colours no difference is small.
  std::string rows;
  rows.reserve(height * (width + 1));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % width == 0) rows += '\0';
    rows += i > 0 && pixels[i] == pixels[i - 1] && i % width != 0 ? rows.back() : index.at(pixels[i]);
  }
  const std::string packed = deflated(rows);
  if (packed.empty()) return "";
  const std::string by_palette("\x08\x03\0\0\0", 5);  // eight bits, colours of a palette; deflated, filtered, not interlaced
  return std::string("\x89PNG\r\n\x1a\n") +
         chunk("IHDR", big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height)) + by_palette) +
         chunk("sRGB", std::string(1, '\0')) + chunk("PLTE", palette) + chunk("IDAT", packed) + chunk("IEND", "");
}

}  // namespace pmreport::document
