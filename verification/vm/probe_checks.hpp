// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_VM_PROBE_CHECKS_HPP
#define VERIFICATION_VM_PROBE_CHECKS_HPP

#include "hal/host/live/bus.hpp"

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace counterpoint::vm
{

/// What was expected and did not happen.
class Failure : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// @brief Throws Failure with `expected` unless `holds`.
void Expect(bool holds, const std::string& expected);
[[nodiscard]] host::LiveFrame Frame(std::uint32_t identifier, const std::vector<std::uint8_t>& data);
/// @brief The next frame within ten seconds; throws Failure with `expected`.
[[nodiscard]] host::LiveFrame Next(host::LiveBus& bus, const std::string& expected);
/// @brief Serves the bus until `is_done`, at most ten seconds; frames are dropped. Throws Failure with `expected`.
void ServeUntil(host::LiveBus& bus, const std::function<bool()>& is_done, const std::string& expected);
/// @brief Serves the bus for a time; returns what came.
[[nodiscard]] std::vector<host::LiveFrame> Serve(host::LiveBus& bus, std::uint32_t milliseconds);
/// @brief Runs a shell command after `. /lib.sh`; throws Failure when it fails.
void Shell(const std::string& command);

using Names = std::vector<std::string>;

// Each check throws Failure; what they do is said where they are defined.
void CheckExchange(const Names& buses);
void CheckOwn(const Names& buses);
void CheckFilters(const Names& buses);
void CheckLostFrames(const Names& buses);
void CheckAbsent(const Names& buses);
void CheckErrorFrames(const Names& buses);
void CheckTwoInterfaces(const Names& buses);
void CheckDownAndUp(const Names& buses);
void CheckRemade(const Names& buses);
void CheckFullQueue(const Names& buses);
void CheckManualRestart(const Names& buses);
void CheckTimedRestart(const Names& buses);
void CheckKernelRestart(const Names& buses);
void CheckRestartBySwitch(const Names& buses);
void CheckStates(const Names& buses);
void CheckUnplugged(const Names& buses);

} // namespace counterpoint::vm

#endif
