// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_FILE_SECTION_NAME_HPP
#define CANOPEN_CIA306_FILE_SECTION_NAME_HPP

#include <cstdint>
#include <string_view>

namespace counterpoint::cia306
{
/// What a section describes, by its name.
enum class SectionKind : std::uint8_t
{
    kOther = 0U,
    kObject = 1U,     ///< [1018]
    kSub = 2U,        ///< [1018sub1], hexadecimal
    kNames = 3U,      ///< [1018Name]
    kValues = 4U,     ///< [1018Value]
    kObjectPart = 5U, ///< [1018Denotation], [1018ObjectLinks]
    kMisspelt = 6U,   ///< Begins like an object and is none.
};

/// The parts of the name of a section.
struct SectionName
{
    SectionKind kind{SectionKind::kOther};
    std::uint16_t index{0U};
    std::uint8_t sub{0U};
};

/// Takes the name of a section apart. Never fails: a name that is not one of an object has kind kOther or kMisspelt.
[[nodiscard]] SectionName ParseSectionName(std::string_view name);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_FILE_SECTION_NAME_HPP
