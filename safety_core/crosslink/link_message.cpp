// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "safety_core/crosslink/link_message.hpp"

namespace counterpoint
{
namespace
{

constexpr std::uint16_t kCoveredBytes = hal::kLinkFrameBytes - 4U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kWordBits = 32U;
constexpr std::uint32_t kStart = 0xFFFFFFFFU;
// CRC-32 of each value of four bits, polynomial 04C11DB7h reflected.
constexpr std::uint32_t kNibbles[16U] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, // MISRA D-001
                                         0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU, 0xEDB88320U, 0xF00F9344U,
                                         0xD6D6A3E8U, 0xCB61B38CU, 0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};

struct Checksum
{
    std::uint32_t value;
};

Checksum ChecksumOf(const hal::LinkFrame& frame) noexcept
{
    std::uint32_t rest = kStart;
    for (std::uint32_t place = 0U; place < kCoveredBytes; ++place)
    {
        rest ^= frame.bytes[place];                  // MISRA D-002
        rest = (rest >> 4U) ^ kNibbles[rest & 0xFU]; // MISRA D-002
        rest = (rest >> 4U) ^ kNibbles[rest & 0xFU]; // MISRA D-002
    }
    return Checksum{~rest};
}

// Puts and gets bytes one behind the other; the layout is the order of the calls.
class Writer
{
  public:
    explicit Writer(hal::LinkFrame& frame) noexcept : frame_{frame}
    {
    }
    void Byte(const std::uint32_t value) noexcept
    {
        frame_.bytes[place_] = static_cast<std::uint8_t>(value & 0xFFU); // MISRA D-002
        ++place_;
    }
    void Half(const std::uint32_t value) noexcept
    {
        Byte(value);
        Byte(value >> kByteBits);
    }
    void Word(const std::uint32_t value) noexcept
    {
        Half(value);
        Half(value >> (2U * kByteBits));
    }
    void Mask(const SrdoMask mask) noexcept
    {
        Word(static_cast<std::uint32_t>(mask & 0xFFFFFFFFU));
        Word(static_cast<std::uint32_t>(mask >> kWordBits));
    }

  private:
    hal::LinkFrame& frame_;
    std::uint32_t place_{0U};
};

class Reader
{
  public:
    Reader(const hal::LinkFrame& frame, const std::uint32_t place) noexcept : frame_{frame}, place_{place}
    {
    }
    [[nodiscard]] std::uint8_t Byte() noexcept
    {
        const std::uint8_t value = frame_.bytes[place_]; // MISRA D-002
        ++place_;
        return value;
    }
    [[nodiscard]] std::uint16_t Half() noexcept
    {
        const std::uint32_t low = Byte();
        const std::uint32_t high = Byte();
        return static_cast<std::uint16_t>(low | (high << kByteBits));
    }
    [[nodiscard]] std::uint32_t Word() noexcept
    {
        const std::uint32_t low = Half();
        const std::uint32_t high = Half();
        return low | (high << (2U * kByteBits));
    }
    [[nodiscard]] SrdoMask Mask() noexcept
    {
        const SrdoMask low = Word();
        const SrdoMask high = Word();
        return low | (high << kWordBits);
    }

  private:
    const hal::LinkFrame& frame_;
    std::uint32_t place_;
};

void Put(Writer& writer, const SlotReport& report) noexcept
{
    writer.Byte(report.slot);
    writer.Byte(static_cast<std::uint32_t>(report.holding));
    writer.Byte(static_cast<std::uint32_t>(report.state));
    writer.Byte(static_cast<std::uint32_t>(report.cause));
    writer.Word(report.ordinal);
    writer.Word(report.age_us);
    writer.Word(report.data.low);
    writer.Word(report.data.high);
}

void Get(Reader& reader, SlotReport& report) noexcept
{
    report.slot = reader.Byte();
    report.holding = static_cast<Holding>(reader.Byte());
    report.state = static_cast<SrdoState>(reader.Byte());
    report.cause = static_cast<SrdoCause>(reader.Byte());
    report.ordinal = reader.Word();
    report.age_us = reader.Word();
    report.data.low = reader.Word();
    report.data.high = reader.Word();
}

void Put(Writer& writer, const ArmedFrame& armed) noexcept
{
    writer.Byte(armed.slot);
    writer.Byte(armed.number);
    writer.Word(armed.frame.identifier);
    writer.Byte(static_cast<std::uint32_t>(armed.frame.kind));
    writer.Byte(static_cast<std::uint32_t>(armed.frame.port));
    writer.Byte(armed.frame.length_bytes);
    for (const std::uint8_t byte : armed.frame.data)
    {
        writer.Byte(byte);
    }
    writer.Byte(0U);
}

void Get(Reader& reader, ArmedFrame& armed) noexcept
{
    armed.slot = reader.Byte();
    armed.number = reader.Byte();
    armed.frame.identifier = reader.Word();
    armed.frame.kind = static_cast<FrameKind>(reader.Byte());
    armed.frame.port = static_cast<CanPortId>(reader.Byte());
    armed.frame.length_bytes = reader.Byte();
    for (std::uint8_t& byte : armed.frame.data)
    {
        byte = reader.Byte();
    }
    static_cast<void>(reader.Byte());
}

void PutHead(Writer& writer, const LinkMessage& message) noexcept
{
    writer.Byte(kLinkVersion);
    writer.Byte(static_cast<std::uint32_t>(message.sender.role));
    writer.Byte(message.sender.node_id);
    writer.Byte(static_cast<std::uint32_t>(message.fault));
    writer.Word(message.sequence);
    writer.Word(message.stamp.us);
    writer.Word(message.echo.sequence);
    writer.Word(message.echo.stamp.us);
    writer.Word(message.echo.hold_us);
    writer.Word(message.flow);
    writer.Word(message.digest.value);
    writer.Byte(message.echo.heard);
    writer.Byte(static_cast<std::uint32_t>(message.statement.guard));
    writer.Byte(message.statement.sct_checked);
    writer.Byte(message.statement.is_tx);
    writer.Byte(message.statement.is_invalid);
    writer.Byte(message.statement.not_operational);
    writer.Byte(message.check.slot);
    writer.Byte(static_cast<std::uint32_t>(message.check.result.fault));
    writer.Half(message.check.result.signature);
    writer.Byte(message.refusal.number);
    writer.Byte(static_cast<std::uint32_t>(message.refusal.cause));
}

// Version, role and node-ID were looked at before.
void GetHead(Reader& reader, LinkMessage& message) noexcept
{
    message.fault = static_cast<DeviceFault>(reader.Byte());
    message.sequence = reader.Word();
    message.stamp.us = reader.Word();
    message.echo.sequence = reader.Word();
    message.echo.stamp.us = reader.Word();
    message.echo.hold_us = reader.Word();
    message.flow = reader.Word();
    message.digest.value = reader.Word();
    message.echo.heard = reader.Byte();
    message.statement.guard = static_cast<GuardView>(reader.Byte());
    message.statement.sct_checked = reader.Byte();
    message.statement.is_tx = reader.Byte();
    message.statement.is_invalid = reader.Byte();
    message.statement.not_operational = reader.Byte();
    message.check.slot = reader.Byte();
    message.check.result.fault = static_cast<ConfigFault>(reader.Byte());
    message.check.result.signature = reader.Half();
    message.refusal.number = reader.Byte();
    message.refusal.cause = static_cast<SrdoCause>(reader.Byte());
}

} // namespace

void Encode(const LinkMessage& message, hal::LinkFrame& frame) noexcept
{
    Writer writer{frame};
    PutHead(writer, message);
    writer.Mask(message.released);
    writer.Mask(message.new_faults);
    writer.Mask(message.due);
    for (const SlotReport& report : message.reports)
    {
        Put(writer, report);
    }
    for (const ArmedFrame& armed : message.armed)
    {
        Put(writer, armed);
    }
    writer.Word(ChecksumOf(frame).value);
    frame.length = hal::kLinkFrameBytes;
}

DecodeResult Decode(const hal::LinkFrame& frame, const LinkSender& expected, LinkMessage& message) noexcept
{
    Reader tail{frame, kCoveredBytes};
    const std::uint32_t told = tail.Word();
    if ((frame.length != hal::kLinkFrameBytes) || (told != ChecksumOf(frame).value))
    {
        return DecodeResult::kInvalid;
    }
    Reader reader{frame, 0U};
    const std::uint32_t version = reader.Byte();
    message.sender.role = static_cast<PeerRole>(reader.Byte());
    message.sender.node_id = reader.Byte();
    const bool is_peer = (message.sender.role == expected.role) && (message.sender.node_id == expected.node_id);
    if ((version != kLinkVersion) || (!is_peer))
    {
        return DecodeResult::kInvalid;
    }
    GetHead(reader, message);
    message.released = reader.Mask();
    message.new_faults = reader.Mask();
    message.due = reader.Mask();
    for (SlotReport& report : message.reports)
    {
        Get(reader, report);
    }
    for (ArmedFrame& armed : message.armed)
    {
        Get(reader, armed);
    }
    return DecodeResult::kIntact;
}

} // namespace counterpoint
