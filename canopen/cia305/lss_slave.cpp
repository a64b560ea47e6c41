// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// State, addressing and identification. What is configured and inquired is in lss_configuration.cpp.
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

} // namespace

LssSlave::LssSlave(const LssParts& parts) noexcept
    : parts_(parts), pending_(parts.settings), state_(LssState::kWaiting), switching_(Switching::kNone),
      switched_at_{0U}, delay_us_(0U), active_node_id_(kNoNodeId), selected_(0U), identified_(0U), scanned_(0U),
      is_storing_(false), is_sending_(false), waiting_{}
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
        Obey(frame, moment.now);
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

void LssSlave::Obey(const CanFrame& frame, const Instant now) noexcept
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
        Configure(frame, now);
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

} // namespace counterpoint::cia305
