// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_START_ANSWER_HPP
#define RUNTIME_MANAGER_START_ANSWER_HPP

#include "runtime/manager/order.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// A slave, and what an answer says of it.
struct NamedSlave
{
    std::uint8_t node;
    std::string text;
};

/// Slaves of which the answer to a start says more than "taken". Empty for all that is no start.
struct StartOutlook
{
    bool is_all{false};
    std::string left_out;            ///< Who does not take it, and why.
    std::string left_out_by_state;   ///< The same, with the state alone.
    std::vector<NamedSlave> despite; ///< Who takes it though something is wrong with it, and what.
    std::string not_heard;           ///< Nobody can say that they take it. [SRS_MGR_080]
    std::string doubted;             ///< Safety slaves that may be two devices. [SRS_MGR_472]
};

/// @brief Looks at the slaves before an order is carried out: `start`, or a set of 1F82h that is one. Behind it what
/// was found may be gone, and who was left out may not be seen any more. [SRS_MGR_522]
[[nodiscard]] StartOutlook OutlookOf(const ManagerOrder& order, const ManagerAssembly& assembly);
/// @brief The answer to a start that was taken, but not by all; `is_by_state`: plc_designer refuses by its states.
[[nodiscard]] std::string PartlyTaken(const StartOutlook& outlook, bool is_by_state);
/// @brief The answer to a start that nobody took.
[[nodiscard]] std::string NotTaken(const StartOutlook& outlook, bool is_by_state);
/// @brief What follows the answer to a start that was taken, by all or by some.
[[nodiscard]] std::string BehindTaken(const StartOutlook& outlook, const ManagerAssembly& assembly);
/// @brief The answer to a set that the objects of the manager have answered: 1F82h starts slaves as an order does.
/// [SRS_MGR_470, SRS_MGR_472, SRS_MGR_544]
[[nodiscard]] std::string AnswerToSet(const StartOutlook& outlook, const ManagerAssembly& assembly,
                                      const std::string& answer);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_START_ANSWER_HPP
