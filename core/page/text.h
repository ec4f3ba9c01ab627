#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// How texts and bytes are written in a page. Names come from outside: nothing in them may act as HTML or script.
namespace vvr::page {

/// Text for use between tags, or in a quoted attribute.
std::string html_text(std::string_view text);

/// JSON for use in a <script>: it has no `<`, so it can't end the element.
std::string script_json(const std::string& json);

std::string base64(std::span<const std::byte> bytes);

/// A `data:` URL with the bytes in it.
std::string data_url(const std::string& type, std::span<const std::byte> bytes);

/// The text's SHA-256 in the form in which a Content-Security-Policy allows a script or a style.
std::string policy_hash(std::string_view text);

/// The relative URL from a page to a file: it stays valid when both are moved together. Bytes of the name with a
/// meaning in URLs are escaped, in any encoding.
std::string relative_url(const std::filesystem::path& page, const std::filesystem::path& file);

/// A path below the folder of the page as a relative URL.
std::string url_of_path(std::string_view path);

/// Puts values in the places `{{name}}` of a text. Places inside values are not filled.
/// \throws std::out_of_range for a name that has no value
std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values);

/// Texts one after the other.
/// \param files name and text of each, as they are embedded
std::string joined(std::string_view before, std::span<const std::pair<std::string_view, std::string_view>> files);

}  // namespace vvr::page
