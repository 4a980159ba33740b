// Text that anybody may have typed, made fit for a file format.
#pragma once

#include <string>
#include <string_view>

namespace pmreport::document {

// Valid UTF-8 without control characters (tab and line ends stay), those included that turn the direction of reading, and without what is
// never a character, such as U+FDD0: what XML 1.0, HTML and Cairo all allow. A byte that is no UTF-8 becomes U+FFFD.
std::string clean(std::string_view raw);

// Cleaned, with & < > " ' as entities: fit for the content and the quoted attributes of HTML and XML.
std::string escape(std::string_view raw);

std::string base64(std::string_view bytes);

std::string size_of(std::size_t bytes);  // "812 B", "3.4 kB", "12 MB": of a file

}  // namespace pmreport::document
