// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_ORDER_HPP
#define RUNTIME_MANAGER_ORDER_HPP

#include "runtime/manager/assembly.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Kinds of orders, and which members of ManagerOrder each uses.
enum class ManagerOrderKind : std::uint8_t
{
    kNothing = 0U, ///< An empty line or a comment.
    kStatus = 1U,
    kCommand = 2U,     ///< command, node (0: all)
    kBoot = 3U,        ///< node
    kWriteSafety = 4U, ///< node
    kHelp = 5U,
    kQuit = 6U,
    kProblem = 7U, ///< `problem` tells.
    kControl = 8U, ///< node, ADS state and device state
    kGet = 9U,     ///< object
    kSet = 10U,    ///< object, value
    kOutput = 11U, ///< node, pdo, bytes
    kNegotiate = 12U,
};

/// An order of a person or a program to a running manager.
struct ManagerOrder
{
    ManagerOrderKind kind{ManagerOrderKind::kNothing};
    cia302::NmtCommand command{cia302::NmtCommand::kInvalid};
    std::uint8_t node{0U};
    std::uint16_t ads_state{0U}; ///< Of kControl, as `device_state`.
    std::uint16_t device_state{0U};
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
    std::uint16_t pdo{0U};
    std::vector<std::uint8_t> bytes;
    std::string problem; ///< What is wrong and what was expected.
};

/// A line of more bytes is no order.
constexpr std::size_t kLongestManagerOrder = 1024U;

/// @brief Reads one line: status, start NODE|all, boot NODE, ... A line that is no order gives kProblem.
/// [SRS_MGR_006, SRS_MGR_134]
[[nodiscard]] ManagerOrder ParseManagerOrder(const std::string& line);
/// @brief The help: all orders, a line each.
[[nodiscard]] std::string ManagerOrderHelp();
/// @brief Carries out a command, a boot, a writing or a negotiation. Answers "taken", or the reason why not; empty for
/// what the owner itself carries out. [SRS_MGR_135, SRS_MGR_136, SRS_MGR_540]
[[nodiscard]] std::string CarryOut(const ManagerOrder& order, ManagerAssembly& assembly, Instant now);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_ORDER_HPP
