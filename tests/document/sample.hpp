// Reports to write in tests: a small one with one of everything, and helpers to look at files.
#pragma once

#include <reports/document/report.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace sample {

// A passing report: two sections with paragraphs, a table, two figures, a gallery, evidence; data with a gap; a check; values.
pmreport::document::Report report();

std::string png(int width, int height, unsigned char grey);  // an image that decodes

// A folder of its own below the temporary one, gone at the end.
class Folder {
 public:
  Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder();
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& file);
std::map<std::string, std::string> content_of(const std::filesystem::path& folder);  // every file below, by its relative name
void put(const std::filesystem::path& file, const std::string& bytes);               // with the folders above it
bool contains(const std::string& text, const std::string& part);
int count(const std::string& text, const std::string& part);

}  // namespace sample
