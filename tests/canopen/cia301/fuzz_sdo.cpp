// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Any frames at any time to an SDO server, or as answers to an SDO client. The input is a list of steps: one byte of
// what happens, then the bytes that it needs; what is missing is 0.
#include "canopen/cia301/base/little_endian.hpp"
#include "canopen/cia301/dictionary/no_objects.hpp"
#include "canopen/cia301/sdo/client.hpp"
#include "canopen/cia301/sdo/server.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kRoomBytes = 40U;
constexpr std::uint32_t kTimeOut = 1000U;

void Require(const bool holds)
{
    if (!holds)
    {
        std::abort();
    }
}

/// Bytes of the input, one by one.
class Steps
{
  public:
    Steps(const std::uint8_t* data, std::size_t size) : data_(data), left_(size)
    {
    }
    [[nodiscard]] bool IsOver() const
    {
        return left_ == 0U;
    }
    std::uint8_t Next()
    {
        std::uint8_t byte = 0U;
        if (left_ > 0U)
        {
            byte = *data_;
            ++data_;
            --left_;
        }
        return byte;
    }
    SdoFrame Frame()
    {
        SdoFrame frame{};
        for (std::uint8_t& byte : frame.bytes)
        {
            byte = Next();
        }
        return frame;
    }

  private:
    const std::uint8_t* data_;
    std::size_t left_;
};

/// Accepts after it was asked three times.
class SlowHook final : public WriteHook
{
  public:
    SdoAbort OnWrite(const ObjectAddress&, const Bytes&) noexcept override
    {
        ++asked_;
        return ((asked_ % 3) == 0) ? SdoAbort::kNone : SdoAbort::kPending;
    }

  private:
    int asked_{0};
};

bool IsCode(const std::uint32_t code)
{
    constexpr std::array<std::uint32_t, 31> kCodes{
        0x05030000U, 0x05040000U, 0x05040001U, 0x05040002U, 0x05040003U, 0x05040004U, 0x05040005U, 0x06010000U,
        0x06010001U, 0x06010002U, 0x06020000U, 0x06040041U, 0x06040042U, 0x06040043U, 0x06040047U, 0x06060000U,
        0x06070010U, 0x06070012U, 0x06070013U, 0x06090011U, 0x06090030U, 0x06090031U, 0x06090032U, 0x06090036U,
        0x060A0023U, 0x08000000U, 0x08000020U, 0x08000021U, 0x08000022U, 0x08000023U, 0x08000024U};
    bool is_code = false;
    for (const std::uint32_t one : kCodes)
    {
        is_code = is_code || (one == code);
    }
    return is_code;
}

void RequireAnswer(const SdoServer& server, const SdoAnswer& answer)
{
    if ((answer.presence == SdoPresence::kFrame) && (answer.frame.bytes[0] == 0x80U))
    {
        Require(IsCode(static_cast<std::uint32_t>(FromLittleEndian(&answer.frame.bytes[4], 4U))));
        Require(!server.IsBusy());
    }
}

/// A dictionary whose values and buffer stand alone on the heap, so that the sanitizer sees each byte beside them.
void RunServer(Steps steps)
{
    const auto u16 = std::make_unique<std::uint8_t[]>(2U);
    const auto domain = std::make_unique<std::uint8_t[]>(2U * kRoomBytes);
    const auto buffer = std::make_unique<std::uint8_t[]>(kRoomBytes);
    std::uint32_t length = 33U;
    SlowHook slow{};
    const std::array<Entry, 4> entries{{
        {0x0100U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.get(), nullptr, nullptr,
         nullptr, nullptr},
        {0x0200U, 0U, DataType::kDomain, Access::kReadWrite, kInBoth, kInBoth, 2U * kRoomBytes, domain.get(), &length,
         nullptr, nullptr, nullptr},
        {0x0300U, 0U, DataType::kUnsigned16, Access::kReadWrite, kInBoth, kInBoth, 2U, u16.get(), nullptr, nullptr,
         nullptr, &slow},
        {0x0400U, 0U, DataType::kDomain, Access::kReadOnly, kInBoth, kInBoth, kRoomBytes, domain.get(), nullptr,
         nullptr, nullptr, nullptr},
    }};
    NoObjects foreign{};
    Dictionary dictionary{EntryTable{entries.data(), 4U}, foreign};
    dictionary.SetNmtState(NmtState::kPreOperational);
    SdoServer server{SdoServerParts{dictionary, Room{buffer.get(), kRoomBytes}, kTimeOut, 5U}};
    Instant now{0xFFFFF000U};
    while (!steps.IsOver())
    {
        const std::uint8_t what = steps.Next();
        const std::uint32_t passed_us = static_cast<std::uint32_t>(what >> 3U) * 50U;
        now.us += passed_us;
        if ((what & 7U) < 5U)
        {
            RequireAnswer(
                server, server.OnFrame(steps.Frame(), ((what & 7U) == 4U) ? std::uint8_t{7U} : std::uint8_t{8U}, now));
        }
        else if ((what & 7U) < 7U)
        {
            RequireAnswer(server, server.Poll(now));
        }
        else
        {
            RequireAnswer(server, server.Close(SdoAbort::kDeviceState));
        }
        Require(length <= (2U * kRoomBytes));
    }
}

/// Counts frames; every third one finds no room.
class LeakySink final : public FrameSink
{
  public:
    bool Send(const CanFrame& frame) noexcept override
    {
        Require((frame.identifier == 0x605U) && (frame.length_bytes == 8U));
        ++frames_;
        return (frames_ % 3) != 0;
    }

  private:
    int frames_{0};
};

void RunClient(Steps steps)
{
    const auto room = std::make_unique<std::uint8_t[]>(kRoomBytes);
    LeakySink sink{};
    SdoClient client{SdoClientParts{sink, NodeId{5U}, kTimeOut, 5U}};
    Instant now{0xFFFFF000U};
    while (!steps.IsOver())
    {
        const std::uint8_t what = steps.Next();
        const std::uint32_t size = what % (kRoomBytes + 1U);
        const SdoMode mode = ((what & 0x80U) != 0U) ? SdoMode::kBlock : SdoMode::kNormal;
        now.us += what;
        if ((what & 3U) != 3U)
        {
            CanFrame frame{0x585U, FrameKind::kData, CanPortId::kFirst, 8U, {}};
            const SdoFrame answer = steps.Frame();
            std::copy(answer.bytes, answer.bytes + 8, frame.data);
            client.OnFrame(frame, now);
        }
        else if (client.State() != SdoClientState::kBusy)
        {
            const bool is_started = ((what & 0x40U) != 0U)
                                        ? client.StartUpload({0x0100U, 0U}, Room{room.get(), size}, mode, now)
                                        : client.StartDownload({0x0100U, 0U}, Bytes{room.get(), size}, mode, now);
            Require(is_started);
        }
        else if ((what & 0x0CU) == 0x0CU)
        {
            client.OnServerRestart();
        }
        client.OnCycle(now);
        Require((client.State() != SdoClientState::kDone) || (client.Outcome().size_bytes <= kRoomBytes));
    }
    // Silence ends whatever is left
    now.us += kTimeOut;
    client.OnCycle(now);
    Require(client.State() != SdoClientState::kBusy);
}

} // namespace
} // namespace counterpoint::cia301

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* const data, const std::size_t size)
{
    counterpoint::cia301::Steps steps{data, size};
    if ((steps.Next() & 1U) == 0U)
    {
        counterpoint::cia301::RunServer(steps);
    }
    else
    {
        counterpoint::cia301::RunClient(steps);
    }
    return 0;
}
