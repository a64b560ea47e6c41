// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_LAYOUT_HPP
#define CANOPEN_GENERATE_LAYOUT_HPP

#include "canopen/generate/element.hpp"
#include "canopen/generate/generate.hpp"
#include "canopen/generate/safety_part.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::generate
{
/// A static mapping and where its fields begin in the memory.
struct StaticFieldPlace
{
    StaticPart part;
    std::size_t normal{0U};
    std::size_t inverse{0U};
};

/// The generated program before it is text. Memory holds, without gap: the entries of 1000h to 1FFFh, the other
/// entries, the fields of static mappings, the other variables.
struct Layout
{
    SafetyPart safety;
    std::vector<Element> elements;         ///< By index and sub-index.
    std::vector<std::size_t> memory_order; ///< Elements as they lie in the memory.
    std::vector<StaticFieldPlace> fields;
    std::size_t stored_bytes{0U};
    std::size_t communication_bytes{0U};
    std::size_t constant_bytes{0U};
    std::size_t length_count{0U};
    std::size_t communication_lengths{0U};
    std::size_t entry_count{0U};
    std::size_t variable_count{0U};
    std::uint32_t longest_bytes{8U}; ///< Length of the longest entry.
};

/// Decides where everything lies. Throws InputError. [SRS_GEN_005, SRS_GEN_006, SRS_GEN_007, SRS_GEN_010]
[[nodiscard]] Layout LayOut(const cia306::Device& device, const GenerateOptions& options,
                            std::vector<cia306::Finding>& warnings);
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_LAYOUT_HPP
