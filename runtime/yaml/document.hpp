// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_YAML_DOCUMENT_HPP
#define RUNTIME_YAML_DOCUMENT_HPP

#include "canopen/cia306/text/place.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace counterpoint::runtime
{
using cia306::Place;

/// Refuses a YAML file. what() is one line for a person: FILE:LINE:COLUMN: error: WRONG, expected EXPECTED.
class YamlError : public std::runtime_error
{
  public:
    YamlError(const std::string& file, Place place, const std::string& wrong, const std::string& expected);
};

/// Kinds of YAML nodes.
enum class YamlKind : std::uint8_t
{
    kNull = 0U,
    kScalar = 1U,
    kSequence = 2U,
    kMap = 3U,
};

/// One node of a YAML document with its place. Aliases and tags are refused when the document is parsed.
struct YamlNode
{
    YamlKind kind{YamlKind::kNull};
    bool is_quoted{false};
    Place place;
    std::string scalar;
    std::vector<YamlNode> items; ///< Of a sequence; of a map: key, value, key, value, ...
};

constexpr std::size_t kMaxYamlBytes = 1024U * 1024U;
constexpr std::size_t kMaxYamlDepth = 12U;
constexpr std::size_t kMaxYamlNodes = 50000U;

/// The text of a YAML file; LF line ends, no byte order mark. Throws YamlError for a file that is missing, no regular
/// file, too large or not text. [SRS_SIM_010, SRS_SIM_011]
[[nodiscard]] std::string ReadYamlText(const std::string& file);

/// Parses the one document in `text`. Throws YamlError. [SRS_SIM_010]
[[nodiscard]] YamlNode ParseYaml(const std::string& file, const std::string& text);

/// Text of a file as messages show it: in quotes, printable, shortened.
[[nodiscard]] std::string Shown(std::string_view text);
} // namespace counterpoint::runtime

#endif // RUNTIME_YAML_DOCUMENT_HPP
