// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/bench/service_node.hpp"

namespace counterpoint::bench
{
namespace
{

using cia301::Access;
using cia301::DataType;
using cia301::Entry;
using cia301::kInBoth;
using cia301::SdoAbort;
using device::LoadResult;

constexpr std::uint32_t kInterval = 1000000U; ///< The device diagnoses itself completely once a second.
constexpr std::uint16_t kValueIndex = 0x2000U;
constexpr std::uint32_t kFirstTpdoIdentifier = 0x1A0U;
constexpr std::uint8_t kOnSync = 1U;
constexpr std::uint8_t kOnEvent = 255U;
constexpr std::uint32_t kSupervisionMs = 250U;
constexpr std::uint32_t kFnvPrime = 0x01000193U;

} // namespace

ServiceNode::ServiceNode(hal::CanPorts& can) noexcept
    : kernel_{KernelParts{channel_a_, channel_b_, can, output_, watchdog_, watch_}},
      facade_{kernel_, cia301::EntryTable{entries_, kEntries}}, dictionary_{Fill(*this), facade_},
      services_{cia301::NodeId{kNodeId}, device::ServiceParts{emergency_, can, dictionary_, Rooms()}},
      device_{device::DeviceParts{kernel_, watch_, dictionary_, services_, *this,
                                  device::FrameRoom{safety_frames_, kSafetyRoom},
                                  device::FrameRoom{service_frames_, kServiceRoom}, kMaxSrdoCount}}
{
}

cia301::EntryTable ServiceNode::Fill(ServiceNode& node) noexcept
{
    for (std::uint32_t field = 0U; field < kFields; ++field)
    {
        node.entries_[field] = Entry{kValueIndex,
                                     static_cast<std::uint8_t>(field + 1U),
                                     DataType::kUnsigned32,
                                     Access::kReadWrite,
                                     kInBoth,
                                     kInBoth,
                                     4U,
                                     node.values_[field],
                                     nullptr,
                                     nullptr,
                                     nullptr,
                                     nullptr,
                                     cia301::kInTpdo};
    }
    node.entries_[kFields] = Entry{kDomainIndex, 0U,           DataType::kDomain, Access::kReadWrite,   kInBoth,
                                   kInBoth,      kDomainBytes, node.domain_,      &node.domain_length_, nullptr,
                                   nullptr,      nullptr};
    return cia301::EntryTable{node.entries_, kEntries};
}

device::ServiceRooms ServiceNode::Rooms() noexcept
{
    for (std::uint8_t place = 0U; place < kTpdos; ++place)
    {
        const auto number = static_cast<std::uint16_t>(place + 1U);
        tpdos_[place] = cia301::Tpdo{number, cia301::PdoTrigger::kRequest, cia301::PdoMap{fields_[place], kFieldsEach}};
    }
    return device::ServiceRooms{
        {supervised_, kSupervised}, {tpdos_, kTpdos}, {nullptr, 0U}, {sdo_buffer_, kDomainBytes}};
}

LoadResult ServiceNode::OnResetNode() noexcept
{
    const DeviceConfig& config = setup_.Describe(
        {DeviceRole::kConsumers, kMaxSrdoCount, kInterval, kTwoWords, static_cast<std::uint16_t>(2U * kSrdoPeriodMs)});
    Take(kernel_.Start(config, FlowCallback::kOff) == StartResult::kStarted);
    return LoadResult::kLoaded;
}

LoadResult ServiceNode::OnResetCommunication() noexcept
{
    Take(setup_.Configure(kernel_));
    for (std::uint8_t place = 0U; place < kTpdos; ++place)
    {
        Take(SetTpdo(place));
    }
    for (std::uint8_t node = 1U; node <= kSupervised; ++node)
    {
        const std::uint32_t config = (static_cast<std::uint32_t>(node) << 16U) | kSupervisionMs;
        Take(services_.consumer.Write(node, config) == SdoAbort::kNone);
    }
    const std::uint8_t period[2] = {static_cast<std::uint8_t>(kHeartbeatMs), 0U};
    Take(services_.objects.OnWrite({0x1017U, 0U}, {period, 2U}) == SdoAbort::kNone);
    return LoadResult::kLoaded;
}

bool ServiceNode::SetTpdo(const std::uint8_t place) noexcept
{
    const auto number = static_cast<std::uint16_t>(place + 1U);
    const bool is_on_sync = place < (kTpdos / 2U);
    cia301::Tpdos& tpdos = services_.tpdos;
    bool good = tpdos.StoreSetting(number, 1U, 0x40000000U | (kFirstTpdoIdentifier + place)) == SdoAbort::kNone;
    good = (tpdos.StoreSetting(number, 2U, is_on_sync ? kOnSync : kOnEvent) == SdoAbort::kNone) && good;
    good = (tpdos.StoreSetting(number, 5U, is_on_sync ? 0U : std::uint32_t{kTpdoMs}) == SdoAbort::kNone) && good;
    for (std::uint8_t field = 1U; field <= kFieldsEach; ++field)
    {
        const std::uint32_t sub = (kFieldsEach * static_cast<std::uint32_t>(place)) + field;
        const std::uint32_t mapping = (static_cast<std::uint32_t>(kValueIndex) << 16U) | (sub << 8U) | 32U;
        good = (tpdos.StoreMapping(number, field, mapping) == SdoAbort::kNone) && good;
    }
    return (tpdos.StoreMapping(number, 0U, kFieldsEach) == SdoAbort::kNone) && good;
}

void ServiceNode::Take(const bool good) noexcept
{
    well_ = well_ && good;
}

bool ServiceNode::Start(const Instant now) noexcept
{
    output_.Advance(now);
    Take(device_.PowerOn(now) == LoadResult::kLoaded);
    return IsWell();
}

void ServiceNode::OnFrame(const StampedFrame& frame) noexcept
{
    device_.OnFrame(frame);
}

void ServiceNode::OnConfirm(const StampedFrame& frame) noexcept
{
    device_.OnConfirm(frame);
}

void ServiceNode::Prepare(const Instant now) noexcept
{
    output_.Advance(now);
    ++counter_;
    for (auto& value : values_)
    {
        value[0] = static_cast<std::uint8_t>(counter_);
        value[1] = static_cast<std::uint8_t>(counter_ >> 8U);
    }
}

void ServiceNode::Cycle(const Instant now) noexcept
{
    device_.Cycle({{now, Instant{now.us + 7U}}, 0U, 0U});
}

bool ServiceNode::IsOperational() const noexcept
{
    return device_.State() == cia301::NodeState::kOperational;
}

std::uint32_t ServiceNode::Released() const noexcept
{
    return application_.Events();
}

bool ServiceNode::IsWell() const noexcept
{
    return well_ && (kernel_.DeviceState().fault == DeviceFault::kNone) && (application_.Errors() == 0U) &&
           (watchdog_.WrongAnswers() == 0U) && (emergency_.Register() == 0U);
}

void FrameDigest::Add(const CanFrame& frame) noexcept
{
    AddByte(frame.identifier);
    AddByte(frame.identifier >> 8U);
    AddByte(frame.length_bytes);
    for (std::uint32_t i = 0U; i < frame.length_bytes; ++i)
    {
        AddByte(frame.data[i]);
    }
}

void FrameDigest::AddByte(const std::uint32_t byte) noexcept
{
    value_ = (value_ ^ (byte & 0xFFU)) * kFnvPrime;
}

std::uint32_t FrameDigest::Value() const noexcept
{
    return value_;
}

} // namespace counterpoint::bench
