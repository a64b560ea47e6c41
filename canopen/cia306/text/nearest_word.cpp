// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/nearest_word.hpp"

#include "canopen/cia306/text/ini_document.hpp"
#include "canopen/cia306/text/input_error.hpp"

#include <algorithm>
#include <cstddef>

namespace counterpoint::cia306
{
namespace
{
constexpr std::size_t kLongWord = 6U;
constexpr std::size_t kLongestWord = 60U; ///< Of a text; nobody means a word by more.

using Row = std::vector<std::size_t>;

/// How many slips lie between two words: row by row, a row for each letter of `left` (Damerau and Levenshtein).
std::size_t SlipsBetween(const std::string_view left, const std::string_view right)
{
    Row before_last(right.size() + 1U);
    Row last(right.size() + 1U);
    Row row(right.size() + 1U);
    for (std::size_t column = 0U; column <= right.size(); ++column)
    {
        row[column] = column;
    }
    for (std::size_t line = 1U; line <= left.size(); ++line)
    {
        before_last.swap(last);
        last.swap(row);
        row[0] = line;
        for (std::size_t column = 1U; column <= right.size(); ++column)
        {
            const std::size_t wrong = (left[line - 1U] == right[column - 1U]) ? 0U : 1U;
            row[column] = std::min({last[column] + 1U, row[column - 1U] + 1U, last[column - 1U] + wrong});
            const bool is_exchanged = line > 1U && column > 1U && left[line - 1U] == right[column - 2U] &&
                                      left[line - 2U] == right[column - 1U];
            if (is_exchanged)
            {
                row[column] = std::min(row[column], before_last[column - 2U] + 1U);
            }
        }
    }
    return row.back();
}
} // namespace

std::string DidYouMean(const std::string_view text, const std::vector<std::string>& known)
{
    const std::string* nearest = nullptr;
    std::size_t least = (text.size() < kLongWord) ? 2U : 3U;
    for (const std::string& word : known)
    {
        const bool can_be_meant = text.size() > 1U && text.size() <= kLongestWord;
        const std::size_t slips = can_be_meant ? SlipsBetween(Lower(text), Lower(word)) : least;
        if (slips < least)
        {
            least = slips;
            nearest = &word;
        }
    }
    return (nearest == nullptr) ? std::string() : " (did you mean " + Quoted(*nearest) + "?)";
}
} // namespace counterpoint::cia306
