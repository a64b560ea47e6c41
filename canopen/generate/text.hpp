// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATE_TEXT_HPP
#define CANOPEN_GENERATE_TEXT_HPP

#include "canopen/generate/layout.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::generate
{
/// What both files say about themselves.
struct FileText
{
    const Layout& layout;
    std::string name_space;
    std::string origin; ///< First line, without "//".
    std::optional<std::uint8_t> node_id;
};

/// "0x00FFU"
[[nodiscard]] std::string HexLiteral(std::uint64_t value, int digits);
/// A number of up to 64 bits, with its suffix.
[[nodiscard]] std::string UnsignedLiteral(std::uint64_t value);
/// "0x01U, 0x02U, "
[[nodiscard]] std::string ByteList(const std::vector<std::uint8_t>& bytes);
/// "2200h:01"
[[nodiscard]] std::string AddressName(const cia306::Entry& entry);
/// "2200h:01 Command, UNSIGNED8, rww"
[[nodiscard]] std::string Describe(const Element& element);
/// "counterpoint::VariablePlace{storage.bytes + 12U, 8U}"
[[nodiscard]] std::string PlaceText(const Element& element);
/// Whether there is a function by which the application writes it.
[[nodiscard]] bool HasSetter(const Element& element);
/// The bits of a value as a literal of its type; empty where there is none (a REAL that is no number).
[[nodiscard]] std::string BitsLiteral(const cia306::DataType& type, std::uint64_t bits);
/// The function that reads it as it stands in memory: "GetX", of what the channels write "GetXUnchecked". [SRS_GEN_020]
[[nodiscard]] std::string GetterName(const Element& element);
/// Whether there is a function that answers its value or its safe value. [SRS_GEN_020]
[[nodiscard]] bool HasCheckedGetter(const Element& element);
/// What that function answers while the SRDO is not released.
[[nodiscard]] std::string SafeLiteral(const Element& element);
/// Whether its value is a number.
[[nodiscard]] bool IsNumber(const Element& element);

/// The header file.
[[nodiscard]] std::string HeaderText(const FileText& file);
/// The source file.
[[nodiscard]] std::string SourceText(const FileText& file);
/// The part of the source with memory, constants and entries.
[[nodiscard]] std::string TableText(const Layout& layout);
/// The part with the tables that the kernel is given.
[[nodiscard]] std::string KernelText(const FileText& file);
/// The part that describes the device to the kernel.
[[nodiscard]] std::string DeviceText(const FileText& file);
} // namespace counterpoint::generate

#endif // CANOPEN_GENERATE_TEXT_HPP
