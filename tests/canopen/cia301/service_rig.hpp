// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA301_SERVICE_RIG_HPP
#define TESTS_CANOPEN_CIA301_SERVICE_RIG_HPP

#include "canopen/cia301/pdo/objects.hpp"
#include "canopen/cia301/time/sync.hpp"
#include "tests/canopen/cia301/fake_objects.hpp"
#include "tests/canopen/cia301/keeping_sink.hpp"
#include "verification/trace/verifies.hpp"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace counterpoint::cia301
{

inline CanFrame FrameOf(const std::uint32_t identifier, const std::initializer_list<std::uint8_t> bytes)
{
    CanFrame frame{identifier, FrameKind::kData, CanPortId::kFirst, static_cast<std::uint8_t>(bytes.size()), {}};
    std::size_t at = 0U;
    for (const std::uint8_t byte : bytes)
    {
        frame.data[at] = byte;
        ++at;
    }
    return frame;
}

inline CanFrame RemoteOf(const std::uint32_t identifier)
{
    return CanFrame{identifier, FrameKind::kRemote, CanPortId::kFirst, 0U, {}};
}

constexpr ValueLimits kTens{10U, 20U};

/// SYNC and two PDOs of each kind of node 5, in OPERATIONAL, over a small dictionary:
///     2100h:00 u8, 2101h:00 u16, 2102h:00 u32, 2103h:00 BOOLEAN, 2104h:00 u64, 2105h:00 u24: both ways
///     2106h:00 u8 of 10 to 20: both ways; 2107h:00 u8 TPDO only, 2108h:00 u8 RPDO only, 2109h:01 u8 neither
class ServiceRig : public ::testing::Test, public RpdoListener
{
  public:
    ServiceRig()
    {
        for (int i = 0; i < 3; ++i)
        {
            static_cast<void>(slave.Advance());
        }
        slave.OnFrame(FrameOf(0U, {1U, 5U}));
    }
    void OnRpdo(std::uint16_t number, Instant) noexcept override
    {
        written.push_back(number);
    }
    [[nodiscard]] Moment Now() const
    {
        return Moment{slave.State(), Instant{now_us}};
    }
    SdoAbort Write(NumberHook& hook, std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        const std::uint8_t bytes[4] = {
            static_cast<std::uint8_t>(value & 0xFFU), static_cast<std::uint8_t>((value >> 8U) & 0xFFU),
            static_cast<std::uint8_t>((value >> 16U) & 0xFFU), static_cast<std::uint8_t>(value >> 24U)};
        return hook.OnWrite({index, sub}, {bytes, 4U});
    }
    SdoAbort WritePdo(std::uint16_t index, std::uint8_t sub, std::uint32_t value)
    {
        return Write(objects, index, sub, value);
    }
    /// The value with its length in the upper half: 0x0000'0001'0000'0005 is one byte, 05h.
    std::uint64_t Read(NumberHook& hook, std::uint16_t index, std::uint8_t sub)
    {
        std::uint8_t bytes[4] = {};
        const Reading reading = hook.OnRead({index, sub}, {bytes, 4U});
        abort = reading.abort;
        std::uint64_t value = std::uint64_t{reading.size_bytes} << 32U;
        for (std::uint32_t i = 0U; i < reading.size_bytes; ++i)
        {
            value |= std::uint64_t{bytes[i]} << (8U * i);
        }
        return value;
    }
    /// TPDO 1 with 2100h and 2101h on 185h, of this type.
    void UseTpdo(std::uint8_t type)
    {
        ASSERT_EQ(WritePdo(0x1A00U, 1U, 0x21000008U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1A00U, 2U, 0x21010010U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1A00U, 0U, 2U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1800U, 2U, type), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1800U, 1U, 0x185U), SdoAbort::kNone);
    }
    /// RPDO 1 with 2100h and 2101h on 205h, of this type.
    void UseRpdo(std::uint8_t type)
    {
        ASSERT_EQ(WritePdo(0x1600U, 1U, 0x21000008U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1600U, 2U, 0x21010010U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1600U, 0U, 2U), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1400U, 2U, type), SdoAbort::kNone);
        ASSERT_EQ(WritePdo(0x1400U, 1U, 0x205U), SdoAbort::kNone);
    }
    void Cycle()
    {
        sync.OnCycle(Now());
        rpdos.OnCycle(Now());
        tpdos.OnCycle(Now());
    }
    void Sync0(std::initializer_list<std::uint8_t> bytes = {})
    {
        sync.OnFrame(FrameOf(0x80U, bytes), Now());
    }
    void Hear(std::initializer_list<std::uint8_t> bytes)
    {
        rpdos.OnFrame(FrameOf(0x205U, bytes), Now());
    }
    void Command(std::uint8_t command)
    {
        slave.OnFrame(FrameOf(0U, {command, 5U}));
    }
    /// Code of the next emergency message; FFFFFFFFh: none.
    std::uint32_t Emergency()
    {
        const FrameToSend sent = emergency.Poll(NodeState::kOperational, Instant{now_us});
        source = sent.frame.data[3];
        source_high = sent.frame.data[4];
        error_register = sent.frame.data[2];
        return sent.is_present ? (sent.frame.data[0] | (static_cast<std::uint32_t>(sent.frame.data[1]) << 8U))
                               : 0xFFFFFFFFU;
    }

    std::uint32_t now_us{0xFFFFFF00U}; // The counter wraps in every test that lets time pass.
    SdoAbort abort{SdoAbort::kNone};
    std::uint8_t source{0U}; ///< Of the last emergency message, low byte; then its high byte.
    std::uint8_t source_high{0U};
    std::uint8_t error_register{0U};      ///< 1001h in that message.
    std::vector<std::uint16_t> written{}; ///< Numbers of RPDOs.
    std::array<std::uint8_t, 1> u8{0x11U};
    std::array<std::uint8_t, 2> u16{0x22U, 0x33U};
    std::array<std::uint8_t, 4> u32{0x44U, 0x55U, 0x66U, 0x77U};
    std::array<std::uint8_t, 1> bit{1U};
    std::array<std::uint8_t, 8> u64{1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U};
    std::array<std::uint8_t, 3> u24{0xAAU, 0xBBU, 0xCCU};
    std::array<std::uint8_t, 1> tens{15U};
    std::array<std::uint8_t, 3> other{7U, 8U, 9U};
    std::array<Entry, 10> entries{{
        {0x2100U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, u8.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2101U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2102U, 0U, DataType::kUnsigned32, Access::kReadWrite, kInBoth, kInBoth, 4U, u32.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2103U, 0U, DataType::kBoolean, Access::kReadWrite, kInBoth, kInBoth, 1U, bit.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2104U, 0U, DataType::kUnsigned64, Access::kReadWrite, kInBoth, kInBoth, 8U, u64.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2105U, 0U, DataType::kUnsigned24, Access::kReadWrite, kInBoth, kInBoth, 3U, u24.data(), nullptr, nullptr,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2106U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, tens.data(), nullptr, &kTens,
         nullptr, nullptr, kInTpdo | kInRpdo},
        {0x2107U, 0U, DataType::kUnsigned8, Access::kReadOnly, kInBoth, kInBoth, 1U, &other[0], nullptr, nullptr,
         nullptr, nullptr, kInTpdo},
        {0x2108U, 0U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &other[1], nullptr, nullptr,
         nullptr, nullptr, kInRpdo},
        {0x2109U, 1U, DataType::kUnsigned8, Access::kReadWrite, kInBoth, kInBoth, 1U, &other[2], nullptr, nullptr,
         nullptr, nullptr},
    }};
    FakeObjects foreign{};
    Dictionary dictionary{EntryTable{entries.data(), 10U}, foreign};
    KeepingSink sink{};
    NmtSlave slave{NodeId{5U}, StartUp{false, 0U}};
    std::array<std::uint32_t, 8> history{};
    EmergencyProducer emergency{NodeId{5U}, ErrorHistory{history.data(), 8U}};
    CommunicationErrors errors{emergency, slave};
    std::array<PdoField, 64> tpdo_fields{};
    std::array<PdoField, 4> rpdo_fields{};
    std::array<PdoField, 1> small_fields{};
    std::array<Tpdo, 2> tpdo_room{{{1U, PdoTrigger::kRequest, {tpdo_fields.data(), 64U}},
                                   {512U, PdoTrigger::kRequest, {small_fields.data(), 1U}}}};
    std::array<PdoField, 1> last_rpdo_fields{};
    std::array<Rpdo, 2> rpdo_room{{{1U, {rpdo_fields.data(), 4U}}, {512U, {last_rpdo_fields.data(), 1U}}}};
    Tpdos tpdos{TpdoParts{sink, dictionary, TpdoTable{tpdo_room.data(), 2U}}};
    Rpdos rpdos{RpdoParts{errors, dictionary, RpdoTable{rpdo_room.data(), 2U}, this}};
    PdoObjects objects{tpdos, rpdos};
    Sync sync{SyncParts{sink, errors, objects}};
};

} // namespace counterpoint::cia301

#endif
