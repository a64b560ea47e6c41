// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_ENTRY_HPP
#define CANOPEN_CIA301_DICTIONARY_ENTRY_HPP

#include "canopen/cia301/base/abort_code.hpp"

#include "safety_core/kernel/object_access.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// Data types by their numbers in CiA 301.
enum class DataType : std::uint8_t
{
    kInvalid = 0U,
    kBoolean = 0x01U,
    kInteger8 = 0x02U,
    kInteger16 = 0x03U,
    kInteger32 = 0x04U,
    kUnsigned8 = 0x05U,
    kUnsigned16 = 0x06U,
    kUnsigned32 = 0x07U,
    kReal32 = 0x08U,
    kVisibleString = 0x09U,
    kOctetString = 0x0AU,
    kUnicodeString = 0x0BU,
    kTimeOfDay = 0x0CU,
    kTimeDifference = 0x0DU,
    kDomain = 0x0FU,
    kInteger24 = 0x10U,
    kReal64 = 0x11U,
    kInteger40 = 0x12U,
    kInteger48 = 0x13U,
    kInteger56 = 0x14U,
    kInteger64 = 0x15U,
    kUnsigned24 = 0x16U,
    kUnsigned40 = 0x18U,
    kUnsigned48 = 0x19U,
    kUnsigned56 = 0x1AU,
    kUnsigned64 = 0x1BU,
};

/// Who may read or write an entry over the bus.
enum class Access : std::uint8_t
{
    kInvalid = 0U, ///< Grants nothing.
    kConstant = 1U,
    kReadOnly = 2U,
    kWriteOnly = 3U,
    kReadWrite = 4U,
};

/// NMT states in which an entry may be reached over the bus, as bits.
constexpr std::uint8_t kInPreOperational = 1U;
constexpr std::uint8_t kInOperational = 2U;
constexpr std::uint8_t kInBoth = 3U;

/// What else an entry takes part in, as bits of `uses`.
constexpr std::uint8_t kInTpdo = 1U; ///< May be mapped into a TPDO.
constexpr std::uint8_t kInRpdo = 2U; ///< May be mapped into an RPDO.
constexpr std::uint8_t kStored = 4U; ///< Kept by 1010h.

/// Bytes that are only read.
struct Bytes
{
    const std::uint8_t* data;
    std::uint32_t size_bytes;
};

/// Room that is written.
struct Room
{
    std::uint8_t* data;
    std::uint32_t size_bytes;
};

/// Result of a reading: the length with kNone, else the reason.
struct Reading
{
    SdoAbort abort;
    std::uint32_t size_bytes;
};

/// Supplies the value of an entry in place of the memory at its `place`.
class ReadHook
{
  public:
    /// @brief Writes the value, little-endian, to `room`; kOutOfMemory if it does not fit.
    [[nodiscard]] virtual Reading OnRead(const ObjectAddress& address, const Room& room) noexcept = 0;

  protected:
    ReadHook() noexcept = default;
    ~ReadHook() noexcept = default;
    ReadHook(const ReadHook&) = default;
    ReadHook& operator=(const ReadHook&) = default;
};

/// Whether a write is a new one, or asks again for the end of one that was answered with kPending.
enum class Attempt : std::uint8_t
{
    kInvalid = 0U,
    kFirst = 1U,
    kAgain = 2U,
};

/// Is asked before a value is stored; length and limits were checked before.
class WriteHook
{
  public:
    /// @brief kNone accepts the value. kPending: not ready, ask again with the same value. Everything else refuses it
    /// and is sent to the client as it is. [SRS_OBD_007, SRS_OBD_015]
    [[nodiscard]] virtual SdoAbort OnWrite(const ObjectAddress& address, const Bytes& value) noexcept = 0;
    /// @brief Asks again after kPending. A hook that has begun something overrides it: whoever writes the same value
    /// anew is not told the end of what was begun for another write. [SRS_OBD_015]
    [[nodiscard]] virtual SdoAbort OnWriteAgain(const ObjectAddress& address, const Bytes& value) noexcept
    {
        return OnWrite(address, value);
    }

  protected:
    WriteHook() noexcept = default;
    ~WriteHook() noexcept = default;
    WriteHook(const WriteHook&) = default;
    WriteHook& operator=(const WriteHook&) = default;
};

/// Bounds of a numeric value; of a signed type as two's complement of 64 bits. Both are allowed values.
struct ValueLimits
{
    std::uint64_t low;
    std::uint64_t high;
};

/// One sub-index of the dictionary. Values stand in little-endian order at `place` on every processor.
struct Entry
{
    std::uint16_t index;
    std::uint8_t sub;
    DataType type;
    Access access;
    std::uint8_t readable_in; ///< kInPreOperational, kInOperational.
    std::uint8_t writable_in;
    std::uint32_t size_bytes;    ///< Length, or room if there is `length_bytes`.
    std::uint8_t* place;         ///< May be null if there are hooks.
    std::uint32_t* length_bytes; ///< Length now of a string or domain; null: always `size_bytes`.
    const ValueLimits* limits;   ///< Null: the whole range of the type.
    ReadHook* read_hook;
    WriteHook* write_hook;
    std::uint8_t uses{0U}; ///< kInTpdo, kInRpdo, kStored.
};

/// A constant table, strictly ordered by index and sub-index.
struct EntryTable
{
    const Entry* entries;
    std::uint32_t count;
};

/// @brief Index and sub-index as one ordered number.
[[nodiscard]] constexpr std::uint32_t KeyOf(const std::uint16_t index, const std::uint8_t sub) noexcept
{
    return (static_cast<std::uint32_t>(index) << 8U) | sub;
}

constexpr std::uint16_t kFirstKernelIndex = 0x1300U;
constexpr std::uint16_t kLastKernelIndex = 0x13FFU;

/// @brief Whether a table may be used, also for a static_assert on a generated one. O(n) [SRS_OBD_001]
[[nodiscard]] constexpr bool IsUsable(const EntryTable& table) noexcept
{
    bool is_usable = true;
    for (std::uint32_t i = 0U; i < table.count; ++i)
    {
        const Entry& entry = table.entries[i];
        const bool is_kernels = (entry.index >= kFirstKernelIndex) && (entry.index <= kLastKernelIndex);
        const bool is_ordered = (i == 0U) || (KeyOf(table.entries[i - 1U].index, table.entries[i - 1U].sub) <
                                              KeyOf(entry.index, entry.sub));
        is_usable = is_usable && is_ordered && !is_kernels;
    }
    return is_usable;
}

} // namespace counterpoint::cia301

#endif
