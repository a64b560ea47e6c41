// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_NUMBER_HPP
#define RUNTIME_NODE_NUMBER_HPP

#include "runtime/node/order.hpp"

#include "canopen/cia301/dictionary/dictionary.hpp"
#include "canopen/cia306/file/device.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>

namespace counterpoint::runtime
{
/// How the numbers of an object are told and taken.
struct NumberForm
{
    bool is_signed{false};
    std::uint32_t bits{64U}; ///< Of a signed one; of others its object knows the length.
};

/// @brief The form of an object that the kernel has: as the file says. [SRS_NODE_054]
[[nodiscard]] NumberForm FormOf(const cia306::Device& file, const ObjectAddress& object);
/// @brief The form of any object of a device; what a service keeps has that of the service. [SRS_NODE_054]
[[nodiscard]] NumberForm FormOf(const cia306::Device& file, const cia301::Dictionary& dictionary,
                                const ObjectAddress& object);

/// @brief The number of these bits, for people. [SRS_NODE_054]
[[nodiscard]] std::string NumberText(const NumberForm& form, std::uint64_t bits);
/// @brief The same for programs.
[[nodiscard]] nlohmann::ordered_json NumberJson(const NumberForm& form, std::uint64_t bits);

/// What is written, or why nothing is.
struct NumberBits
{
    cia301::SdoAbort abort{cia301::SdoAbort::kNone};
    std::uint64_t bits{0U};
};

/// @brief The bits of the number of an order, as a file has them: decimal is a value, hexadecimal a pattern of bits.
/// [SRS_NODE_054]
[[nodiscard]] NumberBits BitsOf(const NumberForm& form, const NodeOrder& order);
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_NUMBER_HPP
