#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// What texts and bytes become where they stand in a page. Names come from the world: nothing in them may do anything.
namespace vvr {

/// Text as it stands between tags, or in an attribute in quotes.
std::string html_text(std::string_view text);

/// JSON as it stands in a <script>: no `<` in it, so it can't end the element.
std::string script_json(std::string json);

std::string base64(std::span<const std::byte> bytes);

/// `data:` with the bytes in it.
std::string data_url(const std::string& type, std::span<const std::byte> bytes);

/// The text's SHA-256, as a Content-Security-Policy names a script or a style that may stand in the page.
std::string policy_hash(std::string_view text);

/// The way from a page to a file as a relative URL: it holds as long as both are moved together. Bytes of the name that
/// mean something in a URL are escaped, whatever encoding they are of.
std::string relative_url(const std::filesystem::path& page, const std::filesystem::path& file);

/// A path below the folder of the page as a relative URL.
std::string url_of_path(std::string_view path);

/// Puts values in the places `{{name}}` of a text. What a value holds is not looked at again.
/// \throws std::out_of_range for a name that has no value
std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values);

}  // namespace vvr
