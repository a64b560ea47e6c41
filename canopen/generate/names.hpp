// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_NAMES_HPP
#define CANOPEN_GENERATE_NAMES_HPP

#include "canopen/generate/element.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace counterpoint::generate
{
/// The words of a text in PascalCase: "COB-ID 1 (normal data)" is CobId1NormalData. Empty where it has none.
[[nodiscard]] std::string PascalCase(std::string_view text);

/// Text of a file as it may stand in a comment. [SRS_GEN_012]
[[nodiscard]] std::string CommentText(std::string_view text);

/// Gives every element a name of its own. [SRS_GEN_012]
void NameElements(std::vector<Element>& elements);
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_NAMES_HPP
