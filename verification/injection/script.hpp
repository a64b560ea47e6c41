// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_SCRIPT_HPP
#define VERIFICATION_INJECTION_SCRIPT_HPP

#include "verification/injection/image/mailbox.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::injection
{

constexpr std::uint32_t kAnyPins = 0xFFU;

/// What a step shows without a fault, so that it is the scene that it is called.
struct Shown
{
    std::uint32_t pins{kAnyPins};
    std::uint32_t event{0U}; ///< 0: any.
    std::uint32_t frames{0U};
    std::uint32_t device_fault{0U};
};

/// One step of the script, and the scene that it belongs to.
struct ScriptStep
{
    std::string scene;
    Mailbox mail;
    Shown shown{};
    bool is_operational{false};
};

/// @brief The whole script, from the first cycle to the device safe state.
[[nodiscard]] std::vector<ScriptStep> MakeScript();

/// @brief Both frames of a pair of consumer `slot`, received in this step.
void AddPair(Mailbox& mail, std::uint32_t slot, std::uint32_t value);

/// @brief The steps at the end of the script in which no fault comes: a pin that does not close is told a cycle later.
constexpr std::uint32_t kTailSteps = 5U;

/// SCT of the consumers, in steps.
constexpr std::uint32_t kSctSteps = 6U;

} // namespace counterpoint::injection

#endif
