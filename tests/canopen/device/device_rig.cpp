// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "tests/canopen/device/device_rig.hpp"

#include <algorithm>

namespace counterpoint::device
{

using cia301::Access;
using cia301::DataType;
using cia301::Entry;
using cia301::kInBoth;

DeviceRig::DeviceRig()
    : facade{core, cia301::EntryTable{entries.data(), 12U}},
      dictionary{cia301::EntryTable{entries.data(), 12U}, facade},
      services{
          cia301::NodeId{2U},
          ServiceParts{emergency, ports, dictionary,
                       ServiceRooms{{supervised.data(), 2U}, {nullptr, 0U}, {nullptr, 0U}, {sdo_buffer.data(), 64U}}}},
      device{DeviceParts{core, watch, dictionary, services, *this, FrameRoom{safety_frames.data(), 8U},
                         FrameRoom{service_frames.data(), 16U}, 3U}}
{
    static_cast<void>(FillTable());
}

cia301::EntryTable DeviceRig::FillTable()
{
    const auto number = [](std::uint16_t index, std::uint8_t sub, DataType type, std::uint32_t size, auto* hook)
    {
        return Entry{index,   sub,  type, Access::kReadWrite, kInBoth, kInBoth, size, nullptr, nullptr,
                     nullptr, hook, hook};
    };
    const auto place = [](std::uint16_t index, Access access, std::uint8_t* bytes)
    {
        return Entry{index,   0U,     DataType::kUnsigned32, access, kInBoth, kInBoth, 4U, bytes, nullptr, nullptr,
                     nullptr, nullptr};
    };
    entries = {place(0x1000U, Access::kConstant, u32.data()),
               number(0x1001U, 0U, DataType::kUnsigned8, 1U, &services.objects),
               number(0x1005U, 0U, DataType::kUnsigned32, 4U, &services.sync),
               number(0x100CU, 0U, DataType::kUnsigned16, 2U, &services.objects),
               number(0x100DU, 0U, DataType::kUnsigned8, 1U, &services.objects),
               number(0x1014U, 0U, DataType::kUnsigned32, 4U, &services.objects),
               number(0x1016U, 1U, DataType::kUnsigned32, 4U, &services.objects),
               number(0x1016U, 2U, DataType::kUnsigned32, 4U, &services.objects),
               number(0x1017U, 0U, DataType::kUnsigned16, 2U, &services.objects),
               number(0x1029U, 1U, DataType::kUnsigned8, 1U, &services.errors),
               place(0x1F80U, Access::kReadWrite, start_up.data()),
               place(0x2500U, Access::kReadWrite, u32.data())};
    start_up = {0x04U, 0U, 0U, 0U}; // Waits for the start command.
    return {entries.data(), 12U};
}

LoadResult DeviceRig::OnResetNode() noexcept
{
    ++node_resets;
    EXPECT_EQ(core.Start(config, FlowCallback::kOff), StartResult::kStarted);
    watchdog.timer.Start(hal::WatchdogWindow{500U, 1600U}, Instant{now_us});
    return node_answer;
}

LoadResult DeviceRig::OnResetCommunication() noexcept
{
    ++communication_resets;
    EXPECT_EQ(dictionary.WriteNumber({0x1017U, 0U}, stored_heartbeat_ms, 2U), cia301::SdoAbort::kNone);
    const ObjectReading valid = core.ReadObject({0x13FEU, 0U});
    if (valid.data.bytes[0] == 0xA5U)
    {
        return LoadResult::kLoaded;
    }
    for (const std::uint32_t off : {0x1301U, 0x1303U})
    {
        EXPECT_EQ(Store(static_cast<std::uint16_t>(off), 1U, 0U, 1U), AbortCode::kNone);
    }
    const auto map = [this](std::uint16_t mapping, std::uint32_t normal, std::uint32_t inverse)
    {
        EXPECT_EQ(Store(mapping, 0U, 0U, 1U), AbortCode::kNone);
        EXPECT_EQ(Store(mapping, 1U, normal, 4U), AbortCode::kNone);
        EXPECT_EQ(Store(mapping, 2U, inverse, 4U), AbortCode::kNone);
        EXPECT_EQ(Store(mapping, 0U, 2U, 1U), AbortCode::kNone);
    };
    map(0x1381U, 0x22000110U, 0x23000110U);
    map(0x1383U, 0x20000110U, 0x21000110U);
    EXPECT_EQ(Store(0x1300U, 0U, 1U, 1U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1301U, 2U, 50U, 2U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1301U, 5U, 0x101U, 4U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1301U, 6U, 0x102U, 4U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1301U, 1U, 2U, 1U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1303U, 5U, 0x103U, 4U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1303U, 6U, 0x104U, 4U), AbortCode::kNone);
    EXPECT_EQ(Store(0x1303U, 1U, 1U, 1U), AbortCode::kNone);
    for (const std::uint8_t number : {std::uint8_t{1U}, std::uint8_t{3U}, std::uint8_t{4U}})
    {
        const SignReply reply = core.Sign(CommunicationIndex{static_cast<std::uint16_t>(0x1300U + number)});
        EXPECT_EQ(Store(0x13FFU, number, reply.signature, 2U), AbortCode::kNone);
    }
    if (is_configured)
    {
        EXPECT_EQ(Store(0x13FEU, 0U, 0xA5U, 1U), AbortCode::kNone);
    }
    return LoadResult::kLoaded;
}

AbortCode DeviceRig::Store(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                           const std::uint8_t size)
{
    ObjectData data{};
    data.size_bytes = size;
    for (std::uint32_t byte = 0U; byte < size; ++byte)
    {
        data.bytes[byte] = static_cast<std::uint8_t>(value >> (8U * byte));
    }
    return core.WriteObject(ObjectAddress{index, sub}, data);
}

void DeviceRig::Start()
{
    ASSERT_EQ(device.PowerOn(Instant{now_us}), LoadResult::kLoaded);
    ConfirmAll();
}

void DeviceRig::Run()
{
    Start();
    Command(1U);
    Cycles(2U); // The channels hear of it in the second one.
    ASSERT_EQ(device.State(), cia301::NodeState::kOperational);
}

void DeviceRig::Cycle(const SrdoMask acknowledge)
{
    now_us += 1000U - (now_us % 1000U);
    device.Cycle(CycleCall{InstantPair{{now_us}, {now_us}}, acknowledge, acknowledge});
    ConfirmAll();
}

void DeviceRig::Cycles(const std::uint32_t count)
{
    for (std::uint32_t cycle = 0U; cycle < count; ++cycle)
    {
        Cycle();
    }
}

void DeviceRig::Frame(const std::uint32_t identifier, const Octets& bytes)
{
    now_us += 10U;
    StampedFrame frame{};
    frame.frame.identifier = identifier;
    frame.frame.kind = FrameKind::kData;
    frame.frame.port = CanPortId::kFirst;
    frame.frame.length_bytes = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.frame.data);
    frame.stamp = InstantPair{{now_us}, {now_us}};
    device.OnFrame(frame);
}

void DeviceRig::Remote(const std::uint32_t identifier)
{
    StampedFrame frame{};
    frame.frame.identifier = identifier;
    frame.frame.kind = FrameKind::kRemote;
    frame.frame.port = CanPortId::kFirst;
    frame.stamp = InstantPair{{now_us}, {now_us}};
    device.OnFrame(frame);
}

void DeviceRig::Command(const std::uint8_t command, const std::uint8_t node)
{
    Frame(0U, {command, node});
}

void DeviceRig::Pair()
{
    Frame(0x101U, {0x12U, 0x34U});
    Frame(0x102U, {0xEDU, 0xCBU});
}

void DeviceRig::ConfirmAll()
{
    while (confirmed < ports.sent.size())
    {
        const CanFrame frame = ports.sent[confirmed];
        ++confirmed;
        device.OnConfirm(StampedFrame{frame, InstantPair{{now_us}, {now_us}}});
        device.Serve(Instant{now_us}); // An inverse frame follows, and what waited.
    }
}

std::vector<Octets> DeviceRig::Sent(const std::uint32_t identifier) const
{
    std::vector<Octets> found{};
    for (std::size_t place = forgotten; place < ports.sent.size(); ++place)
    {
        const CanFrame& frame = ports.sent[place];
        if (frame.identifier == identifier)
        {
            found.emplace_back(frame.data, frame.data + frame.length_bytes);
        }
    }
    return found;
}

std::vector<std::uint32_t> DeviceRig::IdentifiersSent() const
{
    std::vector<std::uint32_t> found{};
    for (std::size_t place = forgotten; place < ports.sent.size(); ++place)
    {
        const std::uint32_t identifier = ports.sent[place].identifier;
        const bool is_srdo = identifier > 0x100U && identifier <= 0x180U;
        if (!is_srdo && (identifier & 0x780U) != 0x700U)
        {
            found.push_back(identifier);
        }
    }
    return found;
}

void DeviceRig::Forget()
{
    forgotten = ports.sent.size();
}

std::uint32_t DeviceRig::Download(const std::uint16_t index, const std::uint8_t sub, const std::uint32_t value,
                                  const std::uint8_t size)
{
    Forget();
    const auto command = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
    const auto byte = [](std::uint32_t number, unsigned place)
    { return static_cast<std::uint8_t>(number >> (8U * place)); };
    Frame(0x602U, {command, byte(index, 0U), byte(index, 1U), sub, byte(value, 0U), byte(value, 1U), byte(value, 2U),
                   byte(value, 3U)});
    device.Serve(Instant{now_us});
    ConfirmAll();
    const std::vector<Octets> answers = Sent(0x582U);
    EXPECT_EQ(answers.size(), 1U);
    std::uint32_t code = 0xFFFFFFFFU;
    if (!answers.empty())
    {
        const Octets& answer = answers[0];
        code = (answer[0] == 0x60U) ? 0U
                                    : answer[4] | (static_cast<std::uint32_t>(answer[5]) << 8U) |
                                          (static_cast<std::uint32_t>(answer[6]) << 16U) |
                                          (static_cast<std::uint32_t>(answer[7]) << 24U);
    }
    return code;
}

std::uint32_t DeviceRig::Upload(const std::uint16_t index, const std::uint8_t sub)
{
    Forget();
    Frame(0x602U, {0x40U, static_cast<std::uint8_t>(index & 0xFFU), static_cast<std::uint8_t>(index >> 8U), sub, 0U, 0U,
                   0U, 0U});
    device.Serve(Instant{now_us});
    ConfirmAll();
    const std::vector<Octets> answers = Sent(0x582U);
    std::uint32_t value = 0xFFFFFFFFU;
    if (!answers.empty())
    {
        const Octets& answer = answers[0];
        value = answer[4] | (static_cast<std::uint32_t>(answer[5]) << 8U) |
                (static_cast<std::uint32_t>(answer[6]) << 16U) | (static_cast<std::uint32_t>(answer[7]) << 24U);
    }
    return value;
}

std::vector<unsigned> DeviceRig::Emergencies() const
{
    std::vector<unsigned> codes{};
    for (const Octets& message : Sent(0x82U))
    {
        codes.push_back(message[0] | (static_cast<unsigned>(message[1]) << 8U));
    }
    return codes;
}

} // namespace counterpoint::device
