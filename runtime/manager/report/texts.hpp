// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_REPORT_TEXTS_HPP
#define RUNTIME_MANAGER_REPORT_TEXTS_HPP

#include "canopen/cia302/flying_master/flying_master.hpp"
#include "canopen/manager/manager.hpp"
#include "canopen/network_plan/network_plan.hpp"
#include "runtime/yaml/value.hpp"

#include <string>

// The words in which people and programs read the numbers of the network manager.
namespace counterpoint::runtime
{
inline constexpr Word<network_plan::StartProfile> kProfileWords[] = {
    {"cia302", network_plan::StartProfile::kCia302},
    {"el6751", network_plan::StartProfile::kEl6751},
    {"plc_designer", network_plan::StartProfile::kPlcDesigner}};

/// @brief The word for a value in log, table and scenarios. Every value has one; the text is never empty.
[[nodiscard]] std::string WordOf(cia302::SlaveState state);
[[nodiscard]] std::string WordOf(cia302::NodeEvent event);
[[nodiscard]] std::string WordOf(cia302::StartUpStep step);
[[nodiscard]] std::string WordOf(cia302::NmtCommand command);
[[nodiscard]] std::string WordOf(cia302::NmtAnswer answer);
[[nodiscard]] std::string WordOf(cia302::GateState state);
[[nodiscard]] std::string WordOf(cia302::FlyingEvent event);
[[nodiscard]] std::string WordOf(cia301::NodeState state);
[[nodiscard]] std::string WordOf(network_plan::StartProfile profile);
/// @brief What an error letter of CiA 302-2 means; empty for none.
[[nodiscard]] std::string LetterText(char letter);
/// @brief What a NodeState or nStatus means in its profile; empty where it has none.
[[nodiscard]] std::string CodeText(network_plan::StartProfile profile, int code);
/// @brief What a MasterState means in its profile.
[[nodiscard]] std::string MasterText(network_plan::StartProfile profile, int state);
/// @brief A finding of the gate: "0x1301:02 is 60, expected 50", "0x1000:00: 0x06020000 (no such object)"; empty where
/// nothing is wrong.
[[nodiscard]] std::string FindingText(const cia302::GateFinding& finding);
/// @brief The same for a status that tells an error in its profile.
[[nodiscard]] std::string FindingText(network_plan::StartProfile profile, const cia302::NodeStatus& status);
/// @brief Whether a slave under el6751 was started, by a hand, though its start-up failed.
[[nodiscard]] bool IsDespite(const cia302::NodeStatus& status) noexcept;
/// @brief Whether a slave under cia302 refused or did not answer 1000h, and is asked again.
[[nodiscard]] bool IsAskedAgain(const cia302::NodeStatus& status) noexcept;
/// @brief Whether an update under cia302 waits for the flash of the slave: 1F57h, bit 0. [SRS_MGR_230]
[[nodiscard]] bool IsFlashBusy(const cia302::NodeStatus& status) noexcept;
/// @brief Letter or code in words, and the finding: "O: serial number differs (0x1018:04 is 0x21, expected 0x22)";
/// "operational" where the slave runs without either. [SRS_MGR_026]
[[nodiscard]] std::string StatusText(network_plan::StartProfile profile, const cia302::NodeStatus& status);
/// @brief The same without letter or code, for a table that has a column for it; empty where nothing is to be told.
[[nodiscard]] std::string ResultText(network_plan::StartProfile profile, const cia302::NodeStatus& status);
/// @brief What letters and codes of all profiles mean, as lines.
[[nodiscard]] std::string ResultHelp();
/// @brief An abort code with its meaning: "0x06020000 (no such object)". [SRS_MGR_026]
[[nodiscard]] std::string AbortText(cia301::SdoAbort abort);
/// @brief The command with this word; kInvalid: there is none.
[[nodiscard]] cia302::NmtCommand CommandOf(const std::string& word);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_REPORT_TEXTS_HPP
