// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_ELEMENT_HPP
#define CANOPEN_GENERATE_ELEMENT_HPP

#include "canopen/cia306/file/device.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::generate
{
/// Where the value of an element is kept.
enum class Home : std::uint8_t
{
    kStored = 0U,   ///< In memory, an entry of the table.
    kConstant = 1U, ///< In program memory, an entry of the table.
    kNowhere = 2U,  ///< A DOMAIN: whoever attaches a hook has it.
    kProduced = 3U, ///< In memory, a variable of the kernel that the application writes.
    kConsumed = 4U, ///< In memory, a variable of the kernel that the channels write.
};

/// Least and greatest value as the dictionary takes them: of signed types as two's complement of 64 bits.
struct Limits
{
    std::uint64_t low{0U};
    std::uint64_t high{0U};
};

/// What a consumed variable reads while its SRDO is not released.
struct SafeRead
{
    std::uint8_t srdo{0U};  ///< Its number.
    std::uint64_t bits{0U}; ///< Its part of the safe value.
};

/// One data element of the device as the generated code has it.
struct Element
{
    const cia306::Entry* entry{nullptr};
    std::string object_name;
    Home home{Home::kStored};
    bool is_text{false};             ///< A string: its length may be less than `size_bytes`.
    bool is_counter{false};          ///< Sub-index 0 of an object with others.
    std::uint32_t size_bytes{0U};    ///< Length, or room of a string.
    std::vector<std::uint8_t> value; ///< As many bytes as the value has now.
    std::optional<Limits> limits;
    std::string name;                         ///< PascalCase, its own.
    std::size_t offset{0U};                   ///< In the memory, or in the constants.
    std::size_t length{0U};                   ///< Place of a string's length among the lengths.
    std::optional<std::uint64_t> node_addend; ///< The value is the node-ID and so much.
    std::optional<std::size_t> inverse;       ///< For a normal variable: the element of its inverse.
    std::optional<SafeRead> safe_read;        ///< For a normal variable that a consumer maps.

    /// Index and sub-index as one ordered number.
    [[nodiscard]] std::uint32_t Key() const noexcept
    {
        return (static_cast<std::uint32_t>(entry->index) << 8U) | entry->sub;
    }
    /// Whether it is a variable that the kernel maps.
    [[nodiscard]] bool IsVariable() const noexcept
    {
        return home == Home::kProduced || home == Home::kConsumed;
    }
    /// Whether its value is kept in RAM.
    [[nodiscard]] bool IsInMemory() const noexcept
    {
        return home == Home::kStored || IsVariable();
    }
};

/// What the generated program is made from.
struct ElementContext
{
    const cia306::Device& device;
    std::optional<std::uint8_t> node_id;
    std::vector<cia306::Finding>& warnings;
};

/// The C++ type of a number; empty for a string or DOMAIN.
[[nodiscard]] std::string CppTypeOf(const cia306::DataType& type);
/// The enumerator of cia301::DataType for its type.
[[nodiscard]] std::string TableTypeOf(const cia306::Entry& entry);
/// The enumerator of cia301::Access for its access right.
[[nodiscard]] std::string TableAccessOf(const Element& element);
/// "rw" as the file writes it.
[[nodiscard]] std::string AccessName(cia306::Access access);

/// Value, room and limits of the element from its file. Throws InputError. [SRS_GEN_003, SRS_GEN_005]
void ReadValue(const ElementContext& context, Element& element);
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_ELEMENT_HPP
