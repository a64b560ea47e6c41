// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/target/manager/drive_node.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::target
{
namespace
{

constexpr cia301::NodeId kNode{33U};
constexpr std::uint32_t kSerial = 33U;
constexpr std::uint32_t kDigest = 0xBEE7CE1CU; ///< That the kernel of the drive expects.

InstantPair Both(const Instant now) noexcept
{
    return InstantPair{now, now};
}

/// An entry of bytes that are only read.
cia301::Entry Constant(const ObjectAddress& at, const cia301::DataType type, const cia301::Room& place) noexcept
{
    cia301::Entry entry{};
    entry.index = at.index;
    entry.sub = at.sub;
    entry.type = type;
    entry.access = cia301::Access::kConstant;
    entry.readable_in = cia301::kInBoth;
    entry.size_bytes = place.size_bytes;
    entry.place = place.data;
    return entry;
}

/// An entry that a service keeps.
template <class Service>
cia301::Entry Kept(const ObjectAddress& at, const cia301::DataType type, const std::uint32_t size_bytes,
                   Service& service) noexcept
{
    cia301::Entry entry{};
    entry.index = at.index;
    entry.sub = at.sub;
    entry.type = type;
    entry.access = cia301::Access::kReadWrite;
    entry.readable_in = cia301::kInBoth;
    entry.writable_in = cia301::kInBoth;
    entry.size_bytes = size_bytes;
    entry.read_hook = &service;
    entry.write_hook = &service;
    return entry;
}

} // namespace

DriveNode::DriveNode(const DriveDifference& difference) noexcept
    : difference_{difference}, emergency_{kNode, cia301::ErrorHistory{history_, kHistory}},
      watch_{emergency_, actuator_}, kernel_{KernelParts{a_, b_, can_, output_, watchdog_, watch_}},
      objects_{kernel_, cia301::EntryTable{entries_, kEntries}},
      dictionary_{cia301::EntryTable{entries_, kEntries}, objects_},
      services_{kNode, device::ServiceParts{emergency_, can_, dictionary_,
                                            device::ServiceRooms{{supervised_, 1U},
                                                                 {nullptr, 0U},
                                                                 {nullptr, 0U},
                                                                 {sdo_buffer_, sizeof(sdo_buffer_)}}}},
      device_{device::DeviceParts{kernel_, watch_, dictionary_, services_, *this, device::FrameRoom{safety_frames_, 4U},
                                  device::FrameRoom{service_frames_, 16U}, 1U}}
{
    FillTable();
}

void DriveNode::FillTable() noexcept
{
    using cia301::DataType;
    constexpr std::uint32_t kIdentity[4U]{0U, 3U, 0x00010000U, kSerial};
    for (std::uint8_t number = 0U; number < 4U; ++number)
    {
        cia301::ToLittleEndian(kIdentity[number], identity_[number], 4U);
    }
    if (difference_.serial != 0U)
    {
        cia301::ToLittleEndian(difference_.serial, identity_[3], 4U);
    }
    entries_[0] = Constant({0x1000U, 0U}, DataType::kUnsigned32, {identity_[4], 4U});
    entries_[1] = Kept({0x1001U, 0U}, DataType::kUnsigned8, 1U, services_.objects);
    entries_[2] = Kept({0x1014U, 0U}, DataType::kUnsigned32, 4U, services_.objects);
    entries_[3] = Kept({0x1016U, 1U}, DataType::kUnsigned32, 4U, services_.objects);
    entries_[4] = Kept({0x1017U, 0U}, DataType::kUnsigned16, 2U, services_.objects);
    entries_[5] = Constant({0x1018U, 0U}, DataType::kUnsigned8, {&identity_count_, 1U});
    for (std::uint8_t number = 0U; number < 4U; ++number)
    {
        const ObjectAddress at{0x1018U, static_cast<std::uint8_t>(number + 1U)};
        entries_[6U + number] = Constant(at, DataType::kUnsigned32, {identity_[number], 4U});
    }
    cia301::ToLittleEndian(kDigest, digest_, 4U);
    entries_[10] = Constant({0x5F04U, 0U}, DataType::kUnsigned32, {digest_, 4U});
}

device::LoadResult DriveNode::OnResetNode() noexcept
{
    const bool has_started = kernel_.Start(actuator_.Describe(), FlowCallback::kOff) == StartResult::kStarted;
    watchdog_.Start(now_);
    return has_started ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

/// The settings are written once; a reset communication finds them as they are.
device::LoadResult DriveNode::OnResetCommunication() noexcept
{
    const bool is_valid = kernel_.ReadObject({0x13FEU, 0U}).data.bytes[0] == kConfigurationValidValue;
    const bool is_loaded = is_valid || ((examples::Actuator::Configure(kernel_) == AbortCode::kNone) && ChangeSct());
    return is_loaded ? device::LoadResult::kLoaded : device::LoadResult::kFailed;
}

/// SRDO off, SCT, on, signature, valid: in the order that the objects want.
bool DriveNode::ChangeSct() noexcept
{
    if (difference_.sct_ms == 0U)
    {
        return true;
    }
    const examples::Setting before[]{
        {{0x1301U, 1U}, 1U, 0U}, {{0x1301U, 2U}, 2U, difference_.sct_ms}, {{0x1301U, 1U}, 1U, kDirectionConsumer}};
    bool is_written = examples::WriteSettings(kernel_, {before, 3U}) == AbortCode::kNone;
    const SignReply reply = kernel_.Sign(CommunicationIndex{0x1301U});
    const examples::Setting after[]{{{0x13FFU, 1U}, 2U, reply.signature},
                                    {{0x13FEU, 0U}, 1U, kConfigurationValidValue}};
    is_written = is_written && (examples::WriteSettings(kernel_, {after, 2U}) == AbortCode::kNone);
    return is_written;
}

void DriveNode::Cycle(const Instant now) noexcept
{
    now_ = now;
    output_.SetTime(now);
    watchdog_.SetTime(now);
    if (is_on_)
    {
        device_.Cycle(CycleCall{Both(now), 0U, 0U});
    }
    else
    {
        is_on_ = device_.PowerOn(now) == device::LoadResult::kLoaded;
    }
}

CanFrame DriveNode::Waiting() const noexcept
{
    return can_.Waiting();
}

void DriveNode::Sent(const Instant now) noexcept
{
    const StampedFrame sent{can_.Waiting(), Both(now)};
    can_.Confirm();
    device_.OnConfirm(sent);
    device_.Serve(now);
}

void DriveNode::Hear(const CanFrame& frame, const Instant now) noexcept
{
    if (is_on_)
    {
        device_.OnFrame(StampedFrame{frame, Both(now)});
        device_.Serve(now);
    }
}

} // namespace counterpoint::target
