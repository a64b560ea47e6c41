// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// State, addressing and identification, then what is configured and inquired.
#include "canopen/cia305/lss_slave.hpp"

#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/objects/service_table.hpp"

namespace counterpoint::cia305
{
namespace
{

constexpr std::uint32_t kToSlaves = 0x7E5U;
constexpr std::uint32_t kToMaster = 0x7E4U;
constexpr std::uint8_t kFrameBytes = 8U;
constexpr std::uint8_t kAddressParts = 4U;
constexpr std::uint8_t kLastNode = 127U;

constexpr std::uint8_t kSwitchGlobal = 0x04U;
constexpr std::uint8_t kSelectVendor = 0x40U;
constexpr std::uint8_t kSelectSerial = 0x43U;
constexpr std::uint8_t kSelected = 0x44U;
constexpr std::uint8_t kIdentifyVendor = 0x46U;
constexpr std::uint8_t kIdentifySerialHigh = 0x4BU;
constexpr std::uint8_t kIdentified = 0x4FU;
constexpr std::uint8_t kIdentifyUnconfigured = 0x4CU;
constexpr std::uint8_t kUnconfigured = 0x50U;
constexpr std::uint8_t kFastScan = 0x51U;
constexpr std::uint8_t kScanStart = 0x80U;
constexpr std::uint8_t kHighestBit = 31U;

bool IsNode(const std::uint8_t node_id) noexcept
{
    return (node_id >= 1U) && (node_id <= kLastNode);
}

constexpr std::uint8_t kConfigureNodeId = 0x11U;
constexpr std::uint8_t kConfigureTiming = 0x13U;
constexpr std::uint8_t kActivateTiming = 0x15U;
constexpr std::uint8_t kStore = 0x17U;
constexpr std::uint8_t kInquireVendor = 0x5AU;
constexpr std::uint8_t kInquireNodeId = 0x5EU;
constexpr std::uint32_t kDone = 0U;
constexpr std::uint32_t kOutOfRange = 1U; ///< Of a node-ID or bit timing; of a store: not supported.
constexpr std::uint32_t kMediaError = 2U;
constexpr std::uint8_t kStandardTable = 0U;
constexpr std::uint32_t kUsPerMs = 1000U;

} // namespace

LssSlave::LssSlave(const LssParts& parts) noexcept
    : parts_(parts), pending_(parts.settings), storing_(parts.settings), state_(LssState::kWaiting),
      switching_(Switching::kNone), switched_at_{0U}, delay_us_(0U), active_node_id_(kNoNodeId), selected_(0U),
      identified_(0U), scanned_(0U), is_storing_(false), is_sending_(false), waiting_{}
{
}

void LssSlave::OnFrame(const CanFrame& frame, const Moment& moment) noexcept
{
    const bool is_command =
        (frame.kind == FrameKind::kData) && (frame.identifier == kToSlaves) && (frame.length_bytes == kFrameBytes);
    const bool is_nameless = (moment.state == cia301::NodeState::kResetCommunication) && (active_node_id_ == kNoNodeId);
    const bool is_allowed = is_nameless || cia301::IsAllowed(cia301::Service::kLss, moment.state);
    if (is_command && is_allowed && !IsSilent())
    {
        Obey(frame, moment);
    }
}

NodeId LssSlave::TakeNodeId() noexcept
{
    active_node_id_ = IsNode(pending_.node_id) ? pending_.node_id : kNoNodeId;
    return NodeId{active_node_id_};
}

bool LssSlave::MayBoot() const noexcept
{
    return (active_node_id_ == kNoNodeId) && IsNode(pending_.node_id) && (state_ == LssState::kWaiting);
}

bool LssSlave::IsSilent() const noexcept
{
    return switching_ != Switching::kNone;
}

LssState LssSlave::State() const noexcept
{
    return state_;
}

std::uint8_t LssSlave::ActiveNodeId() const noexcept
{
    return active_node_id_;
}

const LssSettings& LssSlave::Settings() const noexcept
{
    return pending_;
}

void LssSlave::Obey(const CanFrame& frame, const Moment& moment) noexcept
{
    const std::uint8_t command = frame.data[0];
    const auto value = static_cast<std::uint32_t>(cia301::FromLittleEndian(&frame.data[1], 4U));
    if (command == kSwitchGlobal)
    {
        SwitchGlobal(frame.data[1]);
    }
    else if ((command >= kSelectVendor) && (command <= kSelectSerial))
    {
        SwitchSelective(static_cast<std::uint8_t>(command - kSelectVendor), value);
    }
    else if ((command >= kIdentifyVendor) && (command <= kIdentifySerialHigh))
    {
        IdentifyRemote(static_cast<std::uint8_t>(command - kIdentifyVendor), value);
    }
    else if (command == kIdentifyUnconfigured)
    {
        if (active_node_id_ == kNoNodeId)
        {
            Answer(kUnconfigured, 0U);
        }
    }
    else if (command == kFastScan)
    {
        FastScan(frame);
    }
    else if (state_ == LssState::kConfiguration)
    {
        Configure(frame, moment);
    }
}

void LssSlave::SwitchGlobal(const std::uint8_t mode) noexcept
{
    if (mode == 0U)
    {
        state_ = LssState::kWaiting;
        selected_ = 0U;
    }
    else if (mode == 1U)
    {
        state_ = LssState::kConfiguration;
    }
}

/// Parts match one after the other; any other part starts anew.
void LssSlave::SwitchSelective(const std::uint8_t part, const std::uint32_t value) noexcept
{
    const bool is_next = (part == 0U) || (part == selected_);
    const bool is_match = is_next && (state_ == LssState::kWaiting) && (value == AddressPart(part));
    selected_ = is_match ? static_cast<std::uint8_t>(part + 1U) : std::uint8_t{0U};
    if (selected_ == kAddressParts)
    {
        selected_ = 0U;
        state_ = LssState::kConfiguration;
        Answer(kSelected, 0U);
    }
}

/// 0 vendor, 1 product, 2 and 3 lowest and highest revision, 4 and 5 lowest and highest serial number.
void LssSlave::IdentifyRemote(const std::uint8_t part, const std::uint32_t value) noexcept
{
    constexpr std::uint8_t kSteps = 6U;
    const bool is_next = (part == 0U) || (part == identified_);
    const std::uint32_t own = AddressPart((part < 2U) ? part : (1U + (part / 2U)));
    bool is_match = (value == own);
    if (part >= 2U)
    {
        is_match = ((part % 2U) == 0U) ? (own >= value) : (own <= value);
    }
    identified_ = (is_next && is_match) ? static_cast<std::uint8_t>(part + 1U) : std::uint8_t{0U};
    if (identified_ == kSteps)
    {
        identified_ = 0U;
        Answer(kIdentified, 0U);
    }
}

void LssSlave::FastScan(const CanFrame& frame) noexcept
{
    const auto value = static_cast<std::uint32_t>(cia301::FromLittleEndian(&frame.data[1], 4U));
    const std::uint8_t bit = frame.data[5];
    const std::uint8_t part = frame.data[6];
    const std::uint8_t next = frame.data[7];
    const bool is_taking_part = (state_ == LssState::kWaiting) && (active_node_id_ == kNoNodeId);
    const bool is_valid = (bit <= kHighestBit) && (part < kAddressParts) && (next < kAddressParts);
    if (is_taking_part && (bit == kScanStart))
    {
        scanned_ = 0U;
        Answer(kIdentified, 0U);
    }
    else if (is_taking_part && is_valid && (part == scanned_))
    {
        const std::uint32_t mask = 0xFFFFFFFFU << bit;
        if ((AddressPart(part) & mask) == (value & mask))
        {
            scanned_ = next;
            const bool is_whole = (bit == 0U) && (next < part);
            state_ = is_whole ? LssState::kConfiguration : state_;
            Answer(kIdentified, 0U);
        }
    }
}

std::uint32_t LssSlave::AddressPart(const std::uint32_t part) const noexcept
{
    const Identity& own = parts_.identity;
    std::uint32_t value = own.serial;
    if (part == 0U)
    {
        value = own.vendor;
    }
    else if (part == 1U)
    {
        value = own.product;
    }
    else if (part == 2U)
    {
        value = own.revision;
    }
    return value;
}

void LssSlave::Answer(const std::uint8_t command, const std::uint32_t value) noexcept
{
    waiting_ = CanFrame{kToMaster, FrameKind::kData, CanPortId::kFirst, kFrameBytes, {command}};
    cia301::ToLittleEndian(value, &waiting_.data[1], 4U);
    is_sending_ = true;
    Flush();
}

void LssSlave::Flush() noexcept
{
    if (is_sending_ && !IsSilent())
    {
        is_sending_ = !parts_.sink.Send(waiting_);
    }
}

/// Commands that only a slave in configuration obeys.
void LssSlave::Configure(const CanFrame& frame, const Moment& moment) noexcept
{
    const std::uint8_t command = frame.data[0];
    if (command == kConfigureNodeId)
    {
        ConfigureNodeId(frame.data[1]);
    }
    else if (command == kConfigureTiming)
    {
        ConfigureTiming(frame.data[1], frame.data[2]);
    }
    else if (command == kActivateTiming)
    {
        ActivateTiming(static_cast<std::uint16_t>(frame.data[1] | (frame.data[2] << 8U)), moment);
    }
    else if (command == kStore)
    {
        is_storing_ = true;
        storing_ = pending_;
        FinishStore();
    }
    else if ((command >= kInquireVendor) && (command <= kInquireNodeId))
    {
        Inquire(command);
    }
}

void LssSlave::OnCycle(const Moment& moment) noexcept
{
    const std::uint32_t since_us = moment.now.us - switched_at_.us;
    if (moment.state == cia301::NodeState::kOperational)
    {
        switching_ = Switching::kNone;
    }
    else if ((switching_ == Switching::kBefore) && (since_us >= delay_us_))
    {
        parts_.device.SwitchTo(pending_.timing);
        switching_ = Switching::kAfter;
        switched_at_ = moment.now;
    }
    else if ((switching_ == Switching::kAfter) && (since_us >= delay_us_))
    {
        switching_ = Switching::kNone;
    }
    if (is_storing_)
    {
        FinishStore();
    }
    Flush();
}

void LssSlave::ConfigureNodeId(const std::uint8_t node_id) noexcept
{
    const bool is_node = (node_id >= 1U) && (node_id <= kLastNode);
    const bool is_taken = is_node || (node_id == kNoNodeId);
    pending_.node_id = is_taken ? node_id : pending_.node_id;
    Answer(kConfigureNodeId, is_taken ? kDone : kOutOfRange);
}

void LssSlave::ConfigureTiming(const std::uint8_t table, const std::uint8_t index) noexcept
{
    const bool is_taken = (table == kStandardTable) && parts_.device.IsSupported(BitTiming{index});
    pending_.timing = is_taken ? BitTiming{index} : pending_.timing;
    Answer(kConfigureTiming, is_taken ? kDone : kOutOfRange);
}

/// Silence for the delay, the change, silence for the delay again: so all nodes have changed before one sends. In
/// OPERATIONAL the kernel sends its SRDOs, whatever LSS says.
void LssSlave::ActivateTiming(const std::uint16_t delay_ms, const Moment& moment) noexcept
{
    const bool is_quiet = moment.state != cia301::NodeState::kOperational;
    if (is_quiet && parts_.device.IsSupported(pending_.timing))
    {
        delay_us_ = delay_ms * kUsPerMs;
        switched_at_ = moment.now;
        switching_ = Switching::kBefore;
    }
}

void LssSlave::FinishStore() noexcept
{
    const LssStored stored = parts_.device.Store(storing_);
    is_storing_ = (stored == LssStored::kPending);
    if (stored == LssStored::kDone)
    {
        Answer(kStore, kDone);
    }
    else if (stored == LssStored::kUnsupported)
    {
        Answer(kStore, kOutOfRange);
    }
    else if (!is_storing_)
    {
        Answer(kStore, kMediaError);
    }
}

void LssSlave::Inquire(const std::uint8_t command) noexcept
{
    const bool is_node = (command == kInquireNodeId);
    const std::uint32_t part = static_cast<std::uint32_t>(command) - kInquireVendor;
    Answer(command, is_node ? std::uint32_t{active_node_id_} : AddressPart(part));
}

} // namespace counterpoint::cia305
