// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_NEAREST_WORD_HPP
#define CANOPEN_CIA306_TEXT_NEAREST_WORD_HPP

#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::cia306
{
/// " (did you mean 'check'?)" with the word of `known` that is nearest to `text`, to stand behind it in a message. One
/// slip, in words of six letters and more two, are near: a letter that is missing, too many or another one, or two that
/// changed places; upper and lower case are the same. Of words equally near the first one; an empty text where none is
/// near. [SRS_EASE_001]
[[nodiscard]] std::string DidYouMean(std::string_view text, const std::vector<std::string>& known);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_NEAREST_WORD_HPP
