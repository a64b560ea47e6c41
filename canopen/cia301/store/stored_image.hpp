// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_STORE_STORED_IMAGE_HPP
#define CANOPEN_CIA301_STORE_STORED_IMAGE_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include "hal/api/parameter_memory.hpp"

namespace counterpoint::cia301
{

constexpr std::uint32_t kStoreStepBytes = 64U;
constexpr std::uint32_t kImageHeaderBytes = 24U;
constexpr std::uint32_t kSetPlace = 40U;     ///< Behind the header and two marks.
constexpr std::uint32_t kItemHeadBytes = 4U; ///< Group, part, length.

/// One bank holds, all little-endian:
///     0  mark   "CPS2"          8  bytes of the items       16  groups that were lost before
///     4  generation            12  CRC-32 of the items      20  CRC-32 of bytes 0 to 19
///    24  mark kBegun, about the other bank           32  mark kSuperseded, about the other bank
///    40  items: group, part, 2 bytes of length, bytes; then FFh to the next unit, which counts as items
/// The header is written last: where it is whole, so is the rest. The marks tell what became of the other bank while
/// this one was kept, so that a set that was never complete and one that has decayed are told apart:
///     this bank   -> kBegun -> other: erased, items, header, read back -> kSuperseded in this bank -> answer
struct SetHeader
{
    std::uint32_t generation;
    std::uint32_t length;
    std::uint32_t crc;
    std::uint32_t lost; ///< Groups that were lost with a damaged set, and not saved since.
};

/// What a bank tells of the other one, by its place. A mark is there as soon as one of its bits is.
enum class BankMark : std::uint8_t
{
    kBegun = 24U,      ///< A set was begun there.
    kSuperseded = 32U, ///< It is complete: the set of this bank is never loaded again.
};

/// Head of an item.
struct ItemHead
{
    bool is_present; ///< False: the end of the set.
    std::uint8_t group;
    std::uint8_t part;
    std::uint32_t size_bytes;
};

/// @brief CRC-32 (IEEE 802.3) from `crc`, 0 at first. O(length)
[[nodiscard]] std::uint32_t ContinueCrc32(std::uint32_t crc, const Bytes& bytes) noexcept;

/// @brief Whether a bank has a mark; also where that cannot be read. O(1)
[[nodiscard]] bool HasMark(hal::ParameterMemory& memory, hal::MemoryBank bank, BankMark mark) noexcept;
/// @brief Starts to write a mark, unless it is there.
void StartMark(hal::ParameterMemory& memory, hal::MemoryBank bank, BankMark mark) noexcept;
/// @brief Whether a bank is erased beside its marks: no set was ever begun in it. O(bank)
[[nodiscard]] bool IsBlank(hal::ParameterMemory& memory, hal::MemoryBank bank) noexcept;

/// How far the check of a bank is.
enum class ImageCheck : std::uint8_t
{
    kInvalid = 0U, ///< No valid set.
    kMore = 1U,
    kValid = 0x5AU,
};

/// A set in a bank. The memory is kept by reference and must be ready whenever something is called.
class ImageReader
{
  public:
    /// @brief Reads nothing before Open.
    explicit ImageReader(hal::ParameterMemory& memory) noexcept;

    /// @brief Begins the check of a bank; whether its header is whole. O(1)
    [[nodiscard]] bool Open(hal::MemoryBank bank) noexcept;
    /// @brief Goes on with the check; at most kStoreStepBytes. [SRS_STO_001]
    [[nodiscard]] ImageCheck Continue() noexcept;
    /// @brief The bank that was opened.
    [[nodiscard]] hal::MemoryBank Bank() const noexcept;
    /// @brief Generation of its set, modular: a newer set has the next one.
    [[nodiscard]] std::uint32_t Generation() const noexcept;
    /// @brief Groups that were lost before this set was saved, and are not in it.
    [[nodiscard]] std::uint8_t Lost() const noexcept;
    /// @brief The item at a place, from 0; the next one is kItemHeadBytes + size_bytes behind it. O(1)
    [[nodiscard]] ItemHead HeadAt(std::uint32_t place) noexcept;
    /// @brief Bytes of the set from a place; false beyond its end. O(length)
    [[nodiscard]] bool Read(std::uint32_t place, const Room& room) noexcept;

  private:
    hal::ParameterMemory* memory_;
    hal::MemoryBank bank_;
    SetHeader header_;
    std::uint32_t checked_; ///< Bytes in `crc_`.
    std::uint32_t crc_;
};

/// Writes a set into a bank, unit by unit. The memory is kept by reference.
class ImageWriter
{
  public:
    /// @brief Writes nothing before Begin.
    explicit ImageWriter(hal::ParameterMemory& memory) noexcept;

    /// @brief Starts to erase the bank.
    void Begin(hal::MemoryBank bank) noexcept;
    /// @brief How many bytes Put takes at present.
    [[nodiscard]] std::uint32_t Space() const noexcept;
    /// @brief Whether the set may still grow by so many bytes.
    [[nodiscard]] bool HasRoom(std::uint32_t count) const noexcept;
    /// @brief Adds bytes, at most Space().
    void Put(const Bytes& bytes) noexcept;
    /// @brief Starts to write what is complete, if it fills the buffer or `is_last`; whether there was something.
    bool Flush(bool is_last) noexcept;
    /// @brief Starts to write the header; the set is complete with it. `lost`: groups, see SetHeader.
    void Close(std::uint32_t generation, std::uint8_t lost) noexcept;

  private:
    hal::ParameterMemory* memory_;
    hal::MemoryBank bank_;
    std::uint32_t written_; ///< Bytes behind the header that are in the memory.
    std::uint32_t length_;  ///< And those in the buffer.
    std::uint32_t crc_;
    std::uint8_t buffer_[kStoreStepBytes];
    std::uint32_t filled_;
};

} // namespace counterpoint::cia301

#endif
