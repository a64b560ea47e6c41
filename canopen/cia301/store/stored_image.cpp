// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia301/store/stored_image.hpp"

#include "canopen/cia301/base/little_endian.hpp"

namespace counterpoint::cia301
{
namespace
{

constexpr std::uint32_t kMark = 0x32535043U; ///< "CPS2"
constexpr std::uint32_t kCheckedHeaderBytes = 20U;
constexpr std::uint8_t kErased = 0xFFU;
/// Every bit of a mark differs from those of an erased unit.
constexpr std::uint8_t kMarked[hal::kProgramUnitBytes] = {};

/// CRC of the sixteen values of four bits, reflected.
constexpr std::uint32_t kNibbles[16] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU, 0x76DC4190U, 0x6B6B51F4U,
                                        0x4DB26158U, 0x5005713CU, 0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU,
                                        0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};

std::uint32_t NumberAt(const std::uint8_t* const bytes, const std::uint32_t at) noexcept
{
    return static_cast<std::uint32_t>(FromLittleEndian(&bytes[at], 4U));
}

bool IsErased(const std::uint8_t (&unit)[hal::kProgramUnitBytes]) noexcept
{
    bool is_erased = true;
    for (const std::uint8_t byte : unit)
    {
        is_erased = is_erased && (byte == kErased);
    }
    return is_erased;
}

hal::MemorySection SectionOf(const hal::MemoryBank bank, const BankMark mark) noexcept
{
    return hal::MemorySection{bank, static_cast<std::uint32_t>(mark), hal::kProgramUnitBytes};
}

} // namespace

bool HasMark(hal::ParameterMemory& memory, const hal::MemoryBank bank, const BankMark mark) noexcept
{
    std::uint8_t bytes[hal::kProgramUnitBytes] = {};
    return !memory.Read(SectionOf(bank, mark), bytes) || !IsErased(bytes);
}

void StartMark(hal::ParameterMemory& memory, const hal::MemoryBank bank, const BankMark mark) noexcept
{
    if (!HasMark(memory, bank, mark))
    {
        memory.Program(SectionOf(bank, mark), kMarked);
    }
}

bool IsBlank(hal::ParameterMemory& memory, const hal::MemoryBank bank) noexcept
{
    const std::uint32_t size_bytes = memory.BankBytes();
    bool is_blank = true;
    for (std::uint32_t at = 0U; is_blank && (at < size_bytes); at += hal::kProgramUnitBytes)
    {
        std::uint8_t bytes[hal::kProgramUnitBytes] = {};
        const bool is_mark =
            (at == SectionOf(bank, BankMark::kBegun).offset) || (at == SectionOf(bank, BankMark::kSuperseded).offset);
        is_blank =
            memory.Read(hal::MemorySection{bank, at, hal::kProgramUnitBytes}, bytes) && (is_mark || IsErased(bytes));
    }
    return is_blank;
}

std::uint32_t ContinueCrc32(const std::uint32_t crc, const Bytes& bytes) noexcept
{
    std::uint32_t now = ~crc;
    for (std::uint32_t i = 0U; i < bytes.size_bytes; ++i)
    {
        now ^= bytes.data[i];
        now = (now >> 4U) ^ kNibbles[now & 0x0FU];
        now = (now >> 4U) ^ kNibbles[now & 0x0FU];
    }
    return ~now;
}

ImageReader::ImageReader(hal::ParameterMemory& memory) noexcept
    : memory_(&memory), bank_(hal::MemoryBank::kInvalid), header_{0U, 0U, 0U, 0U}, checked_(0U), crc_(0U)
{
}

bool ImageReader::Open(const hal::MemoryBank bank) noexcept
{
    std::uint8_t bytes[kImageHeaderBytes] = {};
    const bool is_read = memory_->Read(hal::MemorySection{bank, 0U, kImageHeaderBytes}, bytes);
    const bool is_marked = (NumberAt(bytes, 0U) == kMark);
    const bool is_whole =
        (NumberAt(bytes, kCheckedHeaderBytes) == ContinueCrc32(0U, Bytes{bytes, kCheckedHeaderBytes}));
    bank_ = bank;
    checked_ = 0U;
    crc_ = 0U;
    header_ = SetHeader{NumberAt(bytes, 4U), NumberAt(bytes, 8U), NumberAt(bytes, 12U), NumberAt(bytes, 16U)};
    const bool is_open = is_read && is_marked && is_whole;
    const bool is_inside = is_open && (header_.length <= (memory_->BankBytes() - kSetPlace));
    header_.length = is_inside ? header_.length : 0U;
    return is_inside;
}

ImageCheck ImageReader::Continue() noexcept
{
    std::uint8_t bytes[kStoreStepBytes] = {};
    const std::uint32_t left = header_.length - checked_;
    const std::uint32_t count = (left < kStoreStepBytes) ? left : kStoreStepBytes;
    ImageCheck check = ImageCheck::kInvalid;
    if (Read(checked_, Room{bytes, count}))
    {
        crc_ = ContinueCrc32(crc_, Bytes{bytes, count});
        checked_ += count;
        check = (crc_ == header_.crc) ? ImageCheck::kValid : ImageCheck::kInvalid;
        check = (checked_ < header_.length) ? ImageCheck::kMore : check;
    }
    return check;
}

hal::MemoryBank ImageReader::Bank() const noexcept
{
    return bank_;
}

std::uint32_t ImageReader::Generation() const noexcept
{
    return header_.generation;
}

std::uint8_t ImageReader::Lost() const noexcept
{
    return static_cast<std::uint8_t>(header_.lost & 0xFFU);
}

ItemHead ImageReader::HeadAt(const std::uint32_t place) noexcept
{
    std::uint8_t bytes[kItemHeadBytes] = {};
    ItemHead head{false, 0U, 0U, 0U};
    if (Read(place, Room{bytes, kItemHeadBytes}))
    {
        const auto size_bytes = static_cast<std::uint32_t>(FromLittleEndian(&bytes[2], 2U));
        const bool is_inside = size_bytes <= (header_.length - (place + kItemHeadBytes));
        head = ItemHead{is_inside, bytes[0], bytes[1], size_bytes};
    }
    return head;
}

bool ImageReader::Read(const std::uint32_t place, const Room& room) noexcept
{
    const bool is_inside = (place <= header_.length) && (room.size_bytes <= (header_.length - place));
    return is_inside && memory_->Read(hal::MemorySection{bank_, kSetPlace + place, room.size_bytes}, room.data);
}

ImageWriter::ImageWriter(hal::ParameterMemory& memory) noexcept
    : memory_(&memory), bank_(hal::MemoryBank::kInvalid), written_(0U), length_(0U), crc_(0U), buffer_{}, filled_(0U)
{
}

void ImageWriter::Begin(const hal::MemoryBank bank) noexcept
{
    bank_ = bank;
    written_ = 0U;
    length_ = 0U;
    crc_ = 0U;
    filled_ = 0U;
    memory_->Erase(bank);
}

std::uint32_t ImageWriter::Space() const noexcept
{
    return kStoreStepBytes - filled_;
}

bool ImageWriter::HasRoom(const std::uint32_t count) const noexcept
{
    return count <= ((memory_->BankBytes() - kSetPlace) - length_);
}

void ImageWriter::Put(const Bytes& bytes) noexcept
{
    for (std::uint32_t i = 0U; i < bytes.size_bytes; ++i)
    {
        buffer_[filled_ + i] = bytes.data[i];
    }
    filled_ += bytes.size_bytes;
    length_ += bytes.size_bytes;
    crc_ = ContinueCrc32(crc_, bytes);
}

bool ImageWriter::Flush(const bool is_last) noexcept
{
    const bool is_due = (filled_ == kStoreStepBytes) || (is_last && (filled_ > 0U));
    if (is_due)
    {
        while ((filled_ % hal::kProgramUnitBytes) != 0U)
        {
            Put(Bytes{&kErased, 1U});
        }
        memory_->Program(hal::MemorySection{bank_, kSetPlace + written_, filled_}, buffer_);
        written_ += filled_;
        filled_ = 0U;
    }
    return is_due;
}

void ImageWriter::Close(const std::uint32_t generation, const std::uint8_t lost) noexcept
{
    for (std::uint32_t i = 0U; i < kImageHeaderBytes; ++i)
    {
        buffer_[i] = 0U;
    }
    ToLittleEndian(kMark, &buffer_[0], 4U);
    ToLittleEndian(generation, &buffer_[4], 4U);
    ToLittleEndian(length_, &buffer_[8], 4U);
    ToLittleEndian(crc_, &buffer_[12], 4U);
    ToLittleEndian(lost, &buffer_[16], 4U);
    ToLittleEndian(ContinueCrc32(0U, Bytes{buffer_, kCheckedHeaderBytes}), &buffer_[kCheckedHeaderBytes], 4U);
    memory_->Program(hal::MemorySection{bank_, 0U, kImageHeaderBytes}, buffer_);
}

} // namespace counterpoint::cia301
