// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "runtime/manager/report/texts.hpp"

#include "canopen/cia306/text/input_error.hpp"

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

/// A number and its word.
template <typename Meaning> struct Row
{
    Meaning meaning;
    const char* word;
};

template <typename Meaning, std::size_t kCount>
std::string WordIn(const Row<Meaning> (&rows)[kCount], const Meaning meaning, const char* otherwise)
{
    const char* word = otherwise;
    for (const Row<Meaning>& row : rows)
    {
        word = (row.meaning == meaning) ? row.word : word;
    }
    return word;
}

constexpr Row<SlaveState> kStates[] = {{SlaveState::kUnknown, "unknown"},
                                       {SlaveState::kMissing, "missing"},
                                       {SlaveState::kStopped, "stopped"},
                                       {SlaveState::kOperational, "operational"},
                                       {SlaveState::kPreOperational, "pre-operational"}};
constexpr Row<NodeEvent> kEvents[] = {{NodeEvent::kBootUp, "boot_up"},
                                      {NodeEvent::kStarted, "supervision_started"},
                                      {NodeEvent::kChanged, "state"},
                                      {NodeEvent::kHeartbeatLost, "heartbeat_lost"},
                                      {NodeEvent::kGuardMissed, "guard_missed"},
                                      {NodeEvent::kGuardLost, "guard_lost"},
                                      {NodeEvent::kToggleError, "toggle_error"},
                                      {NodeEvent::kNeverSeen, "never_seen"},
                                      {NodeEvent::kUnexpected, "unexpected"}};
constexpr Row<StartUpStep> kSteps[] = {{StartUpStep::kNone, "-"},
                                       {StartUpStep::kReset, "reset"},
                                       {StartUpStep::kWaitBootUp, "wait for boot-up"},
                                       {StartUpStep::kDeviceType, "device type"},
                                       {StartUpStep::kVendorId, "vendor-ID"},
                                       {StartUpStep::kProductCode, "product code"},
                                       {StartUpStep::kRevisionNumber, "revision"},
                                       {StartUpStep::kSerialNumber, "serial number"},
                                       {StartUpStep::kStateCheck, "state check"},
                                       {StartUpStep::kSoftwareVersion, "software version"},
                                       {StartUpStep::kSoftwareUpdate, "software update"},
                                       {StartUpStep::kConfigurationDate, "configuration date"},
                                       {StartUpStep::kRestore, "restore"},
                                       {StartUpStep::kConfigure, "configure"},
                                       {StartUpStep::kErrorControl, "error control"},
                                       {StartUpStep::kSafety, "safety"},
                                       {StartUpStep::kStart, "start"},
                                       {StartUpStep::kDone, "done"},
                                       {StartUpStep::kSyncPeriod, "SYNC period"},
                                       {StartUpStep::kPdo, "PDO"},
                                       {StartUpStep::kPdoReadBack, "PDO read-back"},
                                       {StartUpStep::kHeartbeat, "heartbeat"},
                                       {StartUpStep::kGuarding, "guarding"},
                                       {StartUpStep::kUserObjects, "user objects"},
                                       {StartUpStep::kWaitPdos, "wait for PDOs"},
                                       {StartUpStep::kRunning, "running"},
                                       {StartUpStep::kManual, "by hand"},
                                       {StartUpStep::kSettling, "settling"}};
constexpr Row<NmtCommand> kCommands[] = {{NmtCommand::kStart, "start"},
                                         {NmtCommand::kStop, "stop"},
                                         {NmtCommand::kPreOperational, "preop"},
                                         {NmtCommand::kResetNode, "reset"},
                                         {NmtCommand::kResetCommunication, "reset-comm"}};
constexpr Row<NmtAnswer> kAnswers[] = {
    {NmtAnswer::kTaken, "taken"},
    {NmtAnswer::kQueueFull, "too many commands wait, expected one later"},
    {NmtAnswer::kNotActive, "this manager is not the active master, expected the command at that one"},
    {NmtAnswer::kNoBroadcast, "a start of all while a safety slave is assigned, expected a start of each slave"},
    {NmtAnswer::kNotVerified, "the safety configuration of the slave is not verified, expected boot NODE first"},
    {NmtAnswer::kOtherDevice,
     "the start-up did not find the expected device at this node-ID, expected that one, and boot NODE"},
    {NmtAnswer::kWrong, "no such command or node in this state, expected another"},
    {NmtAnswer::kPartly, "taken, but not by all slaves, expected each in a state that allows it"}};
constexpr Row<GateState> kGates[] = {{GateState::kClosed, "closed"},
                                     {GateState::kBusy, "busy"},
                                     {GateState::kDiffers, "differs"},
                                     {GateState::kFailed, "failed"},
                                     {GateState::kOpen, "open"}};
constexpr Row<FlyingEvent> kFlying[] = {{FlyingEvent::kSlaveMode, "slave_mode"},
                                        {FlyingEvent::kForceNegotiation, "force_negotiation"},
                                        {FlyingEvent::kPowerOnReset, "power_on_reset"},
                                        {FlyingEvent::kMasterMode, "master_mode"},
                                        {FlyingEvent::kConfigurationError, "configuration_error"}};
constexpr Row<cia301::NodeState> kOwnStates[] = {{cia301::NodeState::kInitialising, "initialising"},
                                                 {cia301::NodeState::kPreOperational, "pre-operational"},
                                                 {cia301::NodeState::kOperational, "operational"},
                                                 {cia301::NodeState::kStopped, "stopped"}};
constexpr Row<StartProfile> kProfiles[] = {
    {StartProfile::kCia302, "cia302"}, {StartProfile::kEl6751, "el6751"}, {StartProfile::kPlcDesigner, "plc_designer"}};
constexpr Row<char> kLetters[] = {{'A', "not in the network list"},
                                  {'B', "no answer to device type (1000h)"},
                                  {'C', "device type differs"},
                                  {'D', "vendor-ID differs"},
                                  {'E', "no heartbeat when its state was asked for"},
                                  {'F', "no guarding answer when its state was asked for"},
                                  {'G', "program objects are not configured"},
                                  {'H', "software differs and may not be updated"},
                                  {'I', "software update failed"},
                                  {'J', "configuration failed"},
                                  {'K', "no heartbeat when supervision began"},
                                  {'L', "was OPERATIONAL already"},
                                  {'M', "product code differs"},
                                  {'N', "revision differs"},
                                  {'O', "serial number differs"}};
constexpr Row<int> kNodeStates[] = {{0, "no error"},
                                    {1, "deactivated"},
                                    {2, "not found"},
                                    {4, "SDO aborted or of wrong length"},
                                    {5, "SDO value differs"},
                                    {8, "starts up"},
                                    {11, "bus-off"},
                                    {12, "pre-operational"},
                                    {13, "controller does not start"},
                                    {14, "toggle error"},
                                    {20, "TxPDO too short"},
                                    {22, "TxPDO missing"},
                                    {23, "waits for TxPDOs"},
                                    {40, "synchronous TxPDO missing in its cycle"}};
constexpr Row<int> kPlcStates[] = {{-1, "reset"},
                                   {1, "waits for boot-up"},
                                   {2, "settles"},
                                   {3, "is configured"},
                                   {4, "pre-operational"},
                                   {5, "operational"},
                                   {97, "optional, absent"},
                                   {98, "device type differs"},
                                   {99, "lost"}};
constexpr Row<int> kMasterSteps[] = {{0, "idle"},  {1, "resets"},      {2, "boots slaves"}, {3, "halted"},
                                     {4, "ready"}, {5, "operational"}, {6, "stopped"}};
constexpr Row<int> kEl6751Masters[] = {
    {0, "ended"}, {1, "starts slaves"}, {2, "all started"}, {3, "no bus"}, {4, "too many PDOs"}};

std::string ValueText(const ObjectAddress& object, const cia301::SdoAbort abort, const std::uint64_t expected,
                      const std::uint64_t read)
{
    const std::string name = cia306::ObjectName(object.index, object.sub);
    if (object.index == 0U && abort == cia301::SdoAbort::kGeneral)
    {
        return "two devices seem to have this node-ID, expected one and a reset";
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
    return WordIn(kStates, state, "unknown");
}

std::string WordOf(const NodeEvent event)
{
    return WordIn(kEvents, event, "event");
}

std::string WordOf(const StartUpStep step)
{
    return WordIn(kSteps, step, "-");
}

std::string WordOf(const NmtCommand command)
{
    return WordIn(kCommands, command, "none");
}

std::string WordOf(const NmtAnswer answer)
{
    return WordIn(kAnswers, answer, "refused");
}

std::string WordOf(const GateState state)
{
    return WordIn(kGates, state, "closed");
}

std::string WordOf(const FlyingEvent event)
{
    return WordIn(kFlying, event, "event");
}

std::string WordOf(const cia301::NodeState state)
{
    return WordIn(kOwnStates, state, "initialising");
}

std::string WordOf(const StartProfile profile)
{
    return WordIn(kProfiles, profile, "cia302");
}

std::string LetterText(const char letter)
{
    return WordIn(kLetters, letter, "");
}

std::string CodeText(const StartProfile profile, const int code)
{
    std::string text;
    text = (profile == StartProfile::kEl6751) ? WordIn(kNodeStates, code, "") : text;
    return (profile == StartProfile::kPlcDesigner) ? WordIn(kPlcStates, code, "") : text;
}

std::string MasterText(const StartProfile profile, const int state)
{
    const std::string number = std::to_string(state);
    std::string text = (profile == StartProfile::kCia302) ? WordIn(kMasterSteps, state, number.c_str()) : number;
    return (profile == StartProfile::kEl6751) ? WordIn(kEl6751Masters, state, number.c_str()) : text;
}

std::string AbortText(const cia301::SdoAbort abort)
{
    const auto code = static_cast<std::uint32_t>(abort);
    std::string meaning;
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
    is_wrong = (profile == StartProfile::kEl6751) ? is_refused : is_wrong;
    is_wrong = (profile == StartProfile::kPlcDesigner) ? is_aborted || status.code == kWrongType : is_wrong;
    return is_wrong ? ValueText(status.object, status.abort, status.expected, status.read) : "";
}

NmtCommand CommandOf(const std::string& word)
{
    NmtCommand command = NmtCommand::kInvalid;
    for (const Row<NmtCommand>& row : kCommands)
    {
        command = (word == row.word) ? row.meaning : command;
    }
    return command;
}
} // namespace counterpoint::runtime
