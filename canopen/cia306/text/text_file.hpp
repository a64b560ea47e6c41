// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_TEXT_FILE_HPP
#define CANOPEN_CIA306_TEXT_TEXT_FILE_HPP

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::cia306
{
constexpr std::size_t kMaxFileBytes = 16U * 1024U * 1024U;

/// The whole content of a regular file. Throws InputError for anything else, without waiting and without reading a
/// file that is larger than kMaxFileBytes. [SRS_EDS_017]
[[nodiscard]] std::string ReadTextFile(const std::string& path);

/// Where the bytes of a file go: a symbolic link stays one, and the file behind it is replaced, or made if there is
/// none. Throws InputError for links in a circle. [SRS_CLI_035]
[[nodiscard]] std::string TargetOf(const std::string& path);

/// Throws InputError where WriteTextFile would for this path, and leaves nothing behind. For commands that
/// write their result only after long work. [SRS_CLI_240, SRS_CLI_650]
void RequireWritable(const std::string& path);

/// Replaces or creates the file in one step (a new file beside it, then a rename); an existing file keeps its
/// permissions and its owner, a link stays one, also where nothing is behind it. Refuses the file into which standard
/// output or standard error of the program go. Throws InputError. [SRS_CLI_035, SRS_CLI_120, SRS_CLI_170]
void WriteTextFile(const std::string& path, std::string_view text);

/// Writes the next piece of a text.
using TextPiece = std::function<void(std::string_view)>;

/// As WriteTextFile, of a text that is too large to be had as a whole: `write` is called once and hands over its
/// pieces. What it throws leaves the file as it was. [SRS_CLI_035]
void WriteTextInPieces(const std::string& path, const std::function<void(const TextPiece&)>& write);

struct NamedText
{
    std::string path;
    std::string text;
};

/// Files that belong together: none takes its place before all of them lie beside theirs. Throws InputError.
void WriteTextFiles(const std::vector<NamedText>& texts);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_TEXT_FILE_HPP
