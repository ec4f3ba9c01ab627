#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

// What all pages share: escaping, URLs, templates and the table of events. Names are untrusted, so all text is escaped.
namespace vvr::page {

/// Escapes text for HTML content or a quoted attribute.
std::string html_text(std::string_view text);

/// Escapes JSON for a <script> element: without `<`, it can't end the element.
std::string script_json(const std::string& json);

std::string base64(std::span<const std::byte> bytes);

/// Bytes, deflated (zlib), in base64.
/// \throws Error out_of_memory
std::string deflated_base64(std::span<const std::uint8_t> bytes);

/// A `data:` URL that contains the bytes.
std::string data_url(const std::string& type, std::span<const std::byte> bytes);

/// The text's SHA-256 as a source of a Content-Security-Policy, for a script or a style.
std::string policy_hash(std::string_view text);

/// The relative URL from a page to a file, which stays valid if both are moved together. Reserved and non-ASCII bytes
/// are percent-encoded.
std::string relative_url(const std::filesystem::path& page, const std::filesystem::path& file);

/// The relative URL of a path below the page's folder.
std::string url_of_path(std::string_view path);

/// Replaces the placeholders `{{name}}` of a text by values. Values are not searched for placeholders.
/// \throws std::out_of_range for an unknown name
std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values);

/// The kinds of events for the page's scripts, most informative first.
nlohmann::ordered_json json_of_kinds();

}  // namespace vvr::page
