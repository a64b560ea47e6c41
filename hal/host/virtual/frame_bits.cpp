// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "hal/host/virtual/frame_bits.hpp"

namespace counterpoint::host
{

namespace
{

constexpr std::uint32_t kCrcPolynomial = 0x4599U;
constexpr std::uint32_t kCrcMask = 0x7FFFU;
constexpr std::uint32_t kCrcTopBit = 0x4000U;
constexpr std::uint32_t kCrcBits = 15U;
constexpr std::uint32_t kByteBits = 8U;
constexpr std::uint32_t kByteMask = 0xFFU;
constexpr std::uint32_t kStandardHeaderBits = 19U; // SOF, identifier, RTR, IDE, r0, DLC
constexpr std::uint32_t kExtendedHeaderBits = 39U; // SOF, identifier, SRR, IDE, identifier, RTR, r1, r0, DLC
constexpr std::uint32_t kExtensionBits = 18U;
constexpr std::uint32_t kExtensionMask = 0x3FFFFU;
constexpr std::uint32_t kEqualBitsBeforeStuffing = 5U;

/// State of the stuffing rule: the last level and how many equal bits there were, 1 to 4.
constexpr std::uint32_t kStuffStates = 8U;
constexpr std::uint32_t kStuffStateMask = 7U;
constexpr std::uint32_t kStuffCountShift = 3U;

struct StuffRun
{
    std::uint32_t level;
    std::uint32_t length;
};

[[nodiscard]] constexpr std::uint32_t StateOf(const StuffRun& run)
{
    return (run.level << 2U) | (run.length - 1U);
}

/// State after a byte and the stuff bits in it, for each state and byte.
struct StuffTable
{
    std::uint8_t cell[kStuffStates][256U];
};

[[nodiscard]] constexpr StuffTable MakeStuffTable()
{
    StuffTable table{};
    for (std::uint32_t state = 0U; state < kStuffStates; ++state)
    {
        for (std::uint32_t byte = 0U; byte <= kByteMask; ++byte)
        {
            StuffRun run{state >> 2U, (state & 3U) + 1U};
            std::uint32_t stuffed = 0U;
            for (std::uint32_t bit = kByteBits; bit > 0U; --bit)
            {
                const std::uint32_t level = (byte >> (bit - 1U)) & 1U;
                run = (level == run.level) ? StuffRun{level, run.length + 1U} : StuffRun{level, 1U};
                if (run.length == kEqualBitsBeforeStuffing)
                {
                    run = StuffRun{1U - level, 1U};
                    ++stuffed;
                }
            }
            table.cell[state][byte] = static_cast<std::uint8_t>((stuffed << kStuffCountShift) | StateOf(run));
        }
    }
    return table;
}

struct CrcTable
{
    std::uint16_t cell[256U];
};

[[nodiscard]] constexpr CrcTable MakeCrcTable()
{
    CrcTable table{};
    for (std::uint32_t byte = 0U; byte <= kByteMask; ++byte)
    {
        std::uint32_t crc = byte << (kCrcBits - kByteBits);
        for (std::uint32_t bit = 0U; bit < kByteBits; ++bit)
        {
            const bool top = (crc & kCrcTopBit) != 0U;
            crc = (crc << 1U) & kCrcMask;
            crc ^= top ? kCrcPolynomial : 0U;
        }
        table.cell[byte] = static_cast<std::uint16_t>(crc);
    }
    return table;
}

constexpr StuffTable kStuffTable = MakeStuffTable();
constexpr CrcTable kCrcTable = MakeCrcTable();

[[nodiscard]] bool IsExtended(const CanFrame& frame)
{
    return (frame.kind == FrameKind::kExtended) || (frame.kind == FrameKind::kExtendedRemote);
}

[[nodiscard]] std::uint32_t RemoteBit(const CanFrame& frame)
{
    return ((frame.kind == FrameKind::kRemote) || (frame.kind == FrameKind::kExtendedRemote)) ? 1U : 0U;
}

/// SOF to DLC as a number, SOF the highest of `bits` bits.
struct Header
{
    std::uint64_t value;
    std::uint32_t bits;
};

[[nodiscard]] Header HeaderOf(const CanFrame& frame)
{
    const std::uint64_t length = frame.length_bytes;
    const std::uint64_t identifier = frame.identifier;
    const std::uint64_t remote = RemoteBit(frame);
    if (IsExtended(frame))
    {
        constexpr std::uint64_t kSrrAndIde = 3U;
        const std::uint64_t base = ((identifier >> kExtensionBits) << 2U) | kSrrAndIde;
        const std::uint64_t extended = (base << kExtensionBits) | (identifier & kExtensionMask);
        return Header{(((extended << 1U) | remote) << 6U) | length, kExtendedHeaderBits};
    }
    return Header{(((identifier << 1U) | remote) << 6U) | length, kStandardHeaderBits};
}

[[nodiscard]] std::uint32_t DataBytes(const CanFrame& frame)
{
    return (RemoteBit(frame) != 0U) ? 0U : frame.length_bytes;
}

/// Runs bytes through both rules.
class BitCounter
{
  public:
    void Stuff(const std::uint32_t byte)
    {
        const std::uint32_t cell = kStuffTable.cell[state_][byte & kByteMask];
        state_ = cell & kStuffStateMask;
        stuffed_ += cell >> kStuffCountShift;
    }
    void Check(const std::uint32_t byte)
    {
        const std::uint32_t place = (crc_ >> (kCrcBits - kByteBits)) ^ (byte & kByteMask);
        crc_ = ((crc_ << kByteBits) & kCrcMask) ^ kCrcTable.cell[place];
    }
    [[nodiscard]] std::uint32_t Crc() const
    {
        return crc_;
    }
    [[nodiscard]] std::uint32_t Stuffed() const
    {
        return stuffed_;
    }

  private:
    std::uint32_t state_{StateOf(StuffRun{0U, 1U})};
    std::uint32_t stuffed_{0U};
    std::uint32_t crc_{0U};
};

void Append(WireImage& image, const std::uint64_t value, const std::uint32_t bits)
{
    for (std::uint32_t bit = bits; bit > 0U; --bit)
    {
        image.level[image.count] = static_cast<std::uint8_t>((value >> (bit - 1U)) & 1U);
        ++image.count;
    }
}

void AppendStuffed(WireImage& image, const WireImage& plain)
{
    StuffRun run{1U, 0U};
    for (std::uint16_t place = 0U; place < plain.count; ++place)
    {
        const std::uint32_t level = plain.level[place];
        run = (level == run.level) ? StuffRun{level, run.length + 1U} : StuffRun{level, 1U};
        Append(image, level, 1U);
        if (run.length == kEqualBitsBeforeStuffing)
        {
            run = StuffRun{1U - level, 1U};
            Append(image, run.level, 1U);
        }
    }
}

} // namespace

bool IsClassicalFrame(const CanFrame& frame)
{
    const bool standard = (frame.kind == FrameKind::kData) || (frame.kind == FrameKind::kRemote);
    const bool standard_fits = standard && (frame.identifier <= kGreatestStandardIdentifier);
    const bool extended_fits = IsExtended(frame) && (frame.identifier <= kGreatestExtendedIdentifier);
    return (standard_fits || extended_fits) && (frame.length_bytes <= kMaxPayloadBytes);
}

FrameBits MeasureFrame(const CanFrame& frame)
{
    const Header header = HeaderOf(frame);
    // The header is filled up to whole bytes in front of SOF: with 0 for the CRC, where leading zeros count for
    // nothing, and with alternating levels, the last one recessive, for the stuffing rule, where they make no run.
    constexpr std::uint64_t kAlternating = 0x15U;
    const std::uint32_t bytes = (header.bits + kByteBits - 1U) / kByteBits;
    const std::uint64_t filler = kAlternating << header.bits;
    BitCounter counter;
    for (std::uint32_t byte = bytes; byte > 0U; --byte)
    {
        const std::uint32_t shift = (byte - 1U) * kByteBits;
        counter.Check(static_cast<std::uint32_t>(header.value >> shift));
        counter.Stuff(static_cast<std::uint32_t>((header.value | filler) >> shift));
    }
    const std::uint32_t data_bytes = DataBytes(frame);
    for (std::uint32_t place = 0U; place < data_bytes; ++place)
    {
        counter.Check(frame.data[place]);
        counter.Stuff(frame.data[place]);
    }
    // One bit more than the CRC makes whole bytes; it is the opposite of the last one and ends no run of five.
    const std::uint32_t crc = counter.Crc();
    const std::uint32_t tail = (crc << 1U) | (~crc & 1U);
    counter.Stuff(tail >> kByteBits);
    counter.Stuff(tail);
    const std::uint32_t stuffable = header.bits + (data_bytes * kByteBits) + kCrcBits;
    return FrameBits{static_cast<std::uint16_t>(stuffable), static_cast<std::uint16_t>(counter.Stuffed()),
                     static_cast<std::uint16_t>(crc)};
}

WireImage DrawFrame(const CanFrame& frame)
{
    const Header header = HeaderOf(frame);
    WireImage plain{};
    Append(plain, header.value, header.bits);
    const std::uint32_t data_bytes = DataBytes(frame);
    for (std::uint32_t place = 0U; place < data_bytes; ++place)
    {
        Append(plain, frame.data[place], kByteBits);
    }
    Append(plain, MeasureFrame(frame).crc, kCrcBits);
    WireImage image{};
    AppendStuffed(image, plain);
    constexpr std::uint64_t kTrailer = 0x2FFU; // CRC delimiter 1, ACK slot 0, ACK delimiter and EOF 1
    image.ack_slot = static_cast<std::uint16_t>(image.count + 1U);
    Append(image, kTrailer, kTrailerBits);
    return image;
}

std::uint32_t ArbitrationKey(const CanFrame& frame)
{
    // identifier 28..18 | RTR or SRR | IDE | identifier 17..0 | RTR: 32 bits
    const std::uint32_t remote = RemoteBit(frame);
    if (IsExtended(frame))
    {
        constexpr std::uint32_t kSrrAndIde = 3U;
        const std::uint32_t base = ((frame.identifier >> kExtensionBits) << 2U) | kSrrAndIde;
        return (((base << kExtensionBits) | (frame.identifier & kExtensionMask)) << 1U) | remote;
    }
    return ((frame.identifier << 1U) | remote) << (kExtensionBits + 2U);
}

} // namespace counterpoint::host
