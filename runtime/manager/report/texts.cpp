// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/report/texts.hpp"

#include "canopen/cia306/text/input_error.hpp"
#include "canopen/monitor/decoder.hpp"
#include "runtime/device/names.hpp"

namespace counterpoint::runtime
{
namespace
{
using cia302::FlyingEvent;
using cia302::GateState;
using cia302::NmtAnswer;
using cia302::NmtCommand;
using cia302::NodeEvent;
using cia302::SlaveState;
using cia302::StartUpStep;
using network_plan::StartProfile;

constexpr Word<SlaveState> kStates[] = {{"unknown", SlaveState::kUnknown},
                                        {"missing", SlaveState::kMissing},
                                        {"stopped", SlaveState::kStopped},
                                        {"operational", SlaveState::kOperational},
                                        {"pre-operational", SlaveState::kPreOperational}};
constexpr Word<NodeEvent> kEvents[] = {{"boot_up", NodeEvent::kBootUp},
                                       {"supervision_started", NodeEvent::kStarted},
                                       {"state", NodeEvent::kChanged},
                                       {"heartbeat_lost", NodeEvent::kHeartbeatLost},
                                       {"guard_missed", NodeEvent::kGuardMissed},
                                       {"guard_lost", NodeEvent::kGuardLost},
                                       {"toggle_error", NodeEvent::kToggleError},
                                       {"never_seen", NodeEvent::kNeverSeen},
                                       {"unexpected", NodeEvent::kUnexpected}};
constexpr Word<StartUpStep> kSteps[] = {{"-", StartUpStep::kNone},
                                        {"reset", StartUpStep::kReset},
                                        {"wait for boot-up", StartUpStep::kWaitBootUp},
                                        {"device type", StartUpStep::kDeviceType},
                                        {"vendor-ID", StartUpStep::kVendorId},
                                        {"product code", StartUpStep::kProductCode},
                                        {"revision", StartUpStep::kRevisionNumber},
                                        {"serial number", StartUpStep::kSerialNumber},
                                        {"state check", StartUpStep::kStateCheck},
                                        {"software version", StartUpStep::kSoftwareVersion},
                                        {"software update", StartUpStep::kSoftwareUpdate},
                                        {"configuration date", StartUpStep::kConfigurationDate},
                                        {"restore", StartUpStep::kRestore},
                                        {"configure", StartUpStep::kConfigure},
                                        {"error control", StartUpStep::kErrorControl},
                                        {"safety", StartUpStep::kSafety},
                                        {"start", StartUpStep::kStart},
                                        {"done", StartUpStep::kDone},
                                        {"SYNC period", StartUpStep::kSyncPeriod},
                                        {"PDO", StartUpStep::kPdo},
                                        {"PDO read-back", StartUpStep::kPdoReadBack},
                                        {"heartbeat", StartUpStep::kHeartbeat},
                                        {"guarding", StartUpStep::kGuarding},
                                        {"user objects", StartUpStep::kUserObjects},
                                        {"wait for PDOs", StartUpStep::kWaitPdos},
                                        {"running", StartUpStep::kRunning},
                                        {"by hand", StartUpStep::kManual},
                                        {"settling", StartUpStep::kSettling}};
constexpr Word<NmtCommand> kCommands[] = {{"start", NmtCommand::kStart},
                                          {"stop", NmtCommand::kStop},
                                          {"preop", NmtCommand::kPreOperational},
                                          {"reset", NmtCommand::kResetNode},
                                          {"reset-comm", NmtCommand::kResetCommunication}};
constexpr Word<NmtAnswer> kAnswers[] = {
    {"taken", NmtAnswer::kTaken},
    {"too many commands wait, expected one later", NmtAnswer::kQueueFull},
    {"this manager is not the active master, expected the command at that one", NmtAnswer::kNotActive},
    {"a start of all while a safety slave is assigned, expected a start of each slave", NmtAnswer::kNoBroadcast},
    {"the safety configuration of the slave is not verified, expected boot NODE first", NmtAnswer::kNotVerified},
    {"the start-up did not find the expected device at this node-ID, expected that one, and boot NODE",
     NmtAnswer::kOtherDevice},
    {"no slave of the network, or its state does not allow it, expected a slave in a state that does",
     NmtAnswer::kWrong},
    {"taken, but not by all slaves, expected each in a state that allows it", NmtAnswer::kPartly}};
constexpr Word<GateState> kGates[] = {{"closed", GateState::kClosed},
                                      {"busy", GateState::kBusy},
                                      {"differs", GateState::kDiffers},
                                      {"failed", GateState::kFailed},
                                      {"open", GateState::kOpen}};
constexpr Word<FlyingEvent> kFlying[] = {{"slave_mode", FlyingEvent::kSlaveMode},
                                         {"force_negotiation", FlyingEvent::kForceNegotiation},
                                         {"power_on_reset", FlyingEvent::kPowerOnReset},
                                         {"master_mode", FlyingEvent::kMasterMode},
                                         {"configuration_error", FlyingEvent::kConfigurationError}};
constexpr Word<cia301::NodeState> kOwnStates[] = {{"initialising", cia301::NodeState::kInitialising},
                                                  {"pre-operational", cia301::NodeState::kPreOperational},
                                                  {"operational", cia301::NodeState::kOperational},
                                                  {"stopped", cia301::NodeState::kStopped}};
constexpr Word<char> kLetters[] = {
    {"not in the network list", 'A'},
    {"no answer to device type (1000h)", 'B'},
    {"device type differs", 'C'},
    {"vendor-ID differs", 'D'},
    {"no heartbeat when its state was asked for", 'E'},
    {"no guarding answer when its state was asked for", 'F'},
    {"program objects are not configured", 'G'},
    {"software differs and may not be updated", 'H'},
    {"software update failed", 'I'},
    {"configuration failed", 'J'},
    {"no heartbeat or guarding answer when supervision began, or none that toggles", 'K'},
    {"was OPERATIONAL already", 'L'},
    {"product code differs", 'M'},
    {"revision differs", 'N'},
    {"serial number differs", 'O'}};
constexpr Word<int> kNodeStates[] = {{"no error", 0},
                                     {"deactivated", 1},
                                     {"not found", 2},
                                     {"SDO aborted or of wrong length", 4},
                                     {"SDO value differs", 5},
                                     {"starts up", 8},
                                     {"bus-off", 11},
                                     {"pre-operational", 12},
                                     {"controller does not start", 13},
                                     {"toggle error", 14},
                                     {"TxPDO too short", 20},
                                     {"TxPDO missing", 22},
                                     {"waits for TxPDOs", 23},
                                     {"synchronous TxPDO missing in its cycle", 40}};
constexpr Word<int> kPlcStates[] = {{"reset", -1},
                                    {"waits for boot-up", 1},
                                    {"settles", 2},
                                    {"is configured", 3},
                                    {"pre-operational", 4},
                                    {"operational", 5},
                                    {"optional, absent", 97},
                                    {"device type differs", 98},
                                    {"lost", 99}};
constexpr const char* kFlashIsBusy = "its flash is busy";
constexpr const char* kDespite = "started though its start-up failed";
constexpr const char* kFailed = "its start-up failed";
constexpr Word<int> kMasterSteps[] = {{"idle", 0},  {"resets", 1},      {"boots slaves", 2}, {"halted", 3},
                                      {"ready", 4}, {"operational", 5}, {"stopped", 6}};
constexpr Word<int> kEl6751Masters[] = {
    {"ended", 0}, {"starts slaves", 1}, {"all started", 2}, {"no bus", 3}, {"too many PDOs", 4}};

/// What is wrong with a slave of el6751 stays wrong, whatever it was told since: its NodeState says that alone.
/// [SRS_ELM_520]
std::string WithFailure(const std::string& meaning, const cia302::NodeStatus& status, const bool is_good)
{
    constexpr int kSyntax = 4;
    constexpr int kMismatch = 5;
    const bool is_said = !status.has_failed || status.code == kSyntax || status.code == kMismatch;
    const std::string failure = IsDespite(status) ? kDespite : kFailed;
    const std::string both = is_good ? failure : meaning + ", " + failure;
    return is_said ? meaning : both;
}

std::string ValueText(const ObjectAddress& object, const cia301::SdoAbort abort, const std::uint64_t expected,
                      const std::uint64_t read)
{
    const std::string name = cia306::ObjectName(object.index, object.sub);
    if (object.index == 0U && abort == cia301::SdoAbort::kGeneral)
    {
        return "two devices seem to have this node-ID, expected one and a reset";
    }
    if (object.index == 0U && abort == cia301::SdoAbort::kToggle)
    {
        return "the toggle bit of its guarding answers does not change, expected another one in each answer";
    }
    if (abort != cia301::SdoAbort::kNone)
    {
        return name + ": " + AbortText(abort);
    }
    return name + " is " + cia306::Hex(read, 1) + ", expected " + cia306::Hex(expected, 1);
}
} // namespace

std::string WordOf(const SlaveState state)
{
    return NameOf(kStates, state, "unknown");
}

std::string WordOf(const NodeEvent event)
{
    return NameOf(kEvents, event, "event");
}

std::string WordOf(const StartUpStep step)
{
    return NameOf(kSteps, step, "-");
}

std::string WordOf(const NmtCommand command)
{
    return NameOf(kCommands, command, "none");
}

std::string WordOf(const NmtAnswer answer)
{
    return NameOf(kAnswers, answer, "refused");
}

std::string WordOf(const GateState state)
{
    return NameOf(kGates, state, "closed");
}

std::string WordOf(const FlyingEvent event)
{
    return NameOf(kFlying, event, "event");
}

std::string WordOf(const cia301::NodeState state)
{
    return NameOf(kOwnStates, state, "initialising");
}

std::string WordOf(const StartProfile profile)
{
    return NameOf(kProfileWords, profile, "cia302");
}

std::string LetterText(const char letter)
{
    return NameOf(kLetters, letter, "");
}

std::string CodeText(const StartProfile profile, const int code)
{
    std::string text;
    text = (profile == StartProfile::kEl6751) ? NameOf(kNodeStates, code, "") : text;
    return (profile == StartProfile::kPlcDesigner) ? NameOf(kPlcStates, code, "") : text;
}

std::string MasterText(const StartProfile profile, const int state)
{
    const std::string number = std::to_string(state);
    std::string text = (profile == StartProfile::kCia302) ? NameOf(kMasterSteps, state, number.c_str()) : number;
    return (profile == StartProfile::kEl6751) ? NameOf(kEl6751Masters, state, number.c_str()) : text;
}

std::string AbortText(const cia301::SdoAbort abort)
{
    const auto code = static_cast<std::uint32_t>(abort);
    const std::string known = monitor::AbortText(code); // "0602 0000h (no such object)"
    const std::size_t place = known.find(" (");
    std::string meaning = (place == std::string::npos) ? "" : known.substr(place);
    meaning = (abort == cia301::SdoAbort::kTimeOut) ? " (no answer)" : meaning;
    meaning = (abort == cia301::SdoAbort::kLengthMismatch) ? " (another length)" : meaning;
    return cia306::Hex(code, 8) + meaning;
}

std::string FindingText(const cia302::GateFinding& finding)
{
    const bool is_any = finding.object.index != 0U || finding.abort != cia301::SdoAbort::kNone;
    return is_any ? ValueText(finding.object, finding.abort, finding.expected, finding.read) : "";
}

std::string FindingText(const StartProfile profile, const cia302::NodeStatus& status)
{
    constexpr int kNotFound = 2;
    constexpr int kSyntax = 4;
    constexpr int kMismatch = 5;
    constexpr int kWrongType = 98;
    const bool is_aborted = status.abort != cia301::SdoAbort::kNone;
    bool is_wrong = status.letter != 0 && status.letter != 'L' && (is_aborted || status.expected != status.read);
    const bool is_refused = status.code == kNotFound || status.code == kSyntax || status.code == kMismatch;
    is_wrong = is_wrong || IsAskedAgain(status) || IsFlashBusy(status);
    is_wrong = (profile == StartProfile::kEl6751) ? is_refused || status.has_failed : is_wrong;
    is_wrong = (profile == StartProfile::kPlcDesigner) ? is_aborted || status.code == kWrongType : is_wrong;
    if (is_wrong && status.object.index == 0U && status.abort == cia301::SdoAbort::kTimeOut)
    {
        return WordOf(status.step) + ": no boot-up message came, expected one"; // [SRS_BOOT_471]
    }
    return is_wrong ? ValueText(status.object, status.abort, status.expected, status.read) : "";
}

bool IsDespite(const cia302::NodeStatus& status) noexcept
{
    return status.has_failed && status.is_started;
}

bool IsFlashBusy(const cia302::NodeStatus& status) noexcept
{
    constexpr std::uint16_t kFlashStatus = 0x1F57U;
    const bool is_read = status.object.index == kFlashStatus && status.abort == cia301::SdoAbort::kNone;
    const bool is_updated = status.is_busy && status.step == StartUpStep::kSoftwareUpdate;
    return status.letter == 0 && is_updated && is_read && (status.read & 1U) != 0U;
}

bool IsAskedAgain(const cia302::NodeStatus& status) noexcept
{
    const bool is_refused = status.abort != cia301::SdoAbort::kNone;
    return status.letter == 0 && status.is_busy && status.step == StartUpStep::kDeviceType && is_refused;
}

std::string ResultText(const StartProfile profile, const cia302::NodeStatus& status)
{
    constexpr int kPlcStarted = 5;
    const bool is_cia302 = profile == StartProfile::kCia302;
    const int good = (profile == StartProfile::kEl6751) ? 0 : kPlcStarted;
    const std::string code = (status.code == good) ? "" : CodeText(profile, status.code);
    std::string meaning = is_cia302 ? LetterText(status.letter) : code;
    meaning = (is_cia302 && IsAskedAgain(status)) ? "asked again each second" : meaning;
    meaning = (is_cia302 && IsFlashBusy(status)) ? kFlashIsBusy : meaning;
    meaning = WithFailure(meaning, status, status.code == good);
    const std::string finding = FindingText(profile, status);
    return meaning + (meaning.empty() || finding.empty() ? "" : ": ") + finding;
}

std::string StatusText(const StartProfile profile, const cia302::NodeStatus& status)
{
    const std::string code = (profile == StartProfile::kCia302) ? "" : std::to_string(status.code);
    const std::string head = (status.letter != 0) ? std::string(1U, status.letter) : code;
    std::string meaning = (status.letter != 0) ? LetterText(status.letter) : CodeText(profile, status.code);
    meaning = (profile == StartProfile::kCia302 && IsAskedAgain(status)) ? "asked again each second" : meaning;
    meaning = (profile == StartProfile::kCia302 && IsFlashBusy(status)) ? kFlashIsBusy : meaning;
    meaning = WithFailure(meaning, status, status.code == 0);
    const std::string finding = FindingText(profile, status);
    return (head.empty() ? "" : head + ": ") + meaning + (finding.empty() ? "" : " (" + finding + ")");
}

std::string ResultHelp()
{
    std::string text = "result of cia302 (letter of CiA 302-2):\n";
    for (const Word<char>& row : kLetters)
    {
        text += std::string("  ") + row.meaning + "    " + row.text + "\n";
    }
    const auto add = [&text](const std::string& head, const auto& rows)
    {
        text += head;
        for (const Word<int>& row : rows)
        {
            const std::string number = std::to_string(row.meaning);
            text += "  " + number + std::string(5U - number.size(), ' ') + row.text + "\n";
        }
    };
    add("result of el6751 (NodeState):\n", kNodeStates);
    add("result of plc_designer (nStatus):\n", kPlcStates);
    return text;
}

NmtCommand CommandOf(const std::string& word)
{
    NmtCommand command = NmtCommand::kInvalid;
    for (const Word<NmtCommand>& row : kCommands)
    {
        command = (word == row.text) ? row.meaning : command;
    }
    return command;
}
} // namespace counterpoint::runtime
