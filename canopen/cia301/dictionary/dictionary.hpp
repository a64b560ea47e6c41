// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA301_DICTIONARY_DICTIONARY_HPP
#define CANOPEN_CIA301_DICTIONARY_DICTIONARY_HPP

#include "canopen/cia301/dictionary/entry.hpp"
#include "canopen/cia301/dictionary/foreign_objects.hpp"

#include "safety_core/contract/channel.hpp"

#include <cstdint>

namespace counterpoint::cia301
{

/// Stands for a length that a client did not state.
constexpr std::uint32_t kUnknownLength = 0xFFFFFFFFU;

/// A value as a number, sign-extended for signed types, or why there is none.
struct NumberReading
{
    SdoAbort abort;
    std::uint64_t value;
};

/// The object dictionary: own entries from a constant table, all others from the kernel. Keeps its arguments by
/// reference, needs a table for which IsUsable holds. Not reentrant. A hook may read and write other entries.
class Dictionary
{
  public:
    Dictionary(const EntryTable& table, ForeignObjects& foreign) noexcept;

    /// @brief The state that decides about access over the bus; kInitialising at first. [SRS_OBD_004]
    void SetNmtState(NmtState state) noexcept;

    /// @brief Reads as a client on the bus does. O(log n + length) [SRS_OBD_002, SRS_OBD_003, SRS_OBD_004, SRS_OBD_005,
    /// SRS_OBD_006, SRS_OBD_007, SRS_OBD_008, SRS_OBD_009]
    [[nodiscard]] Reading Read(const ObjectAddress& address, const Room& room) noexcept;
    /// @brief Writes as a client on the bus does. O(log n + length) [SRS_OBD_002, SRS_OBD_003, SRS_OBD_004,
    /// SRS_OBD_005, SRS_OBD_006, SRS_OBD_007, SRS_OBD_008]
    [[nodiscard]] SdoAbort Write(const ObjectAddress& address, const Bytes& value) noexcept;
    /// @brief Asks again for the end of a Write that answered kPending. O(log n + length) [SRS_OBD_015]
    [[nodiscard]] SdoAbort WriteAgain(const ObjectAddress& address, const Bytes& value) noexcept;
    /// @brief Whether Write can succeed for a value of `size_bytes` (or kUnknownLength). O(log n) [SRS_OBD_011]
    [[nodiscard]] SdoAbort MayWrite(const ObjectAddress& address, std::uint32_t size_bytes) noexcept;
    /// @brief Present length of the value in bytes, for uploads whose length nobody states. O(log n)
    [[nodiscard]] Reading SizeOf(const ObjectAddress& address) noexcept;

    /// @brief Reads an object as a number for the device itself: access right and NMT state are not looked at. O(log n)
    /// [SRS_OBD_010]
    [[nodiscard]] NumberReading ReadNumber(const ObjectAddress& address) noexcept;
    /// @brief Writes the low `size_bytes` (1 to 8) of a number for the device itself: access right and NMT state are
    /// not looked at. O(log n) [SRS_OBD_010]
    [[nodiscard]] SdoAbort WriteNumber(const ObjectAddress& address, std::uint64_t value,
                                       std::uint32_t size_bytes) noexcept;
    /// @brief Asks again for the end of a WriteNumber that answered kPending. O(log n) [SRS_OBD_015]
    [[nodiscard]] SdoAbort WriteNumberAgain(const ObjectAddress& address, std::uint64_t value,
                                            std::uint32_t size_bytes) noexcept;

    /// @brief The own entry at an address, or null. O(log n) [SRS_OBD_001]
    [[nodiscard]] const Entry* Find(const ObjectAddress& address) const noexcept;

  private:
    [[nodiscard]] std::uint32_t Position(std::uint32_t key) const noexcept;
    [[nodiscard]] SdoAbort Missing(const ObjectAddress& address, AbortCode answer) const noexcept;
    [[nodiscard]] bool IsNow(std::uint8_t states) const noexcept;
    [[nodiscard]] SdoAbort WriteRight(const Entry& entry) const noexcept;
    [[nodiscard]] SdoAbort ReadRight(const Entry& entry) const noexcept;
    [[nodiscard]] Reading ReadForeign(const ObjectAddress& address, const Room& room) noexcept;
    [[nodiscard]] SdoAbort Put(const ObjectAddress& address, const Bytes& value, Attempt attempt) noexcept;
    [[nodiscard]] SdoAbort PutNumber(const ObjectAddress& address, std::uint64_t value, std::uint32_t size_bytes,
                                     Attempt attempt) noexcept;
    [[nodiscard]] SdoAbort WriteForeign(const ObjectAddress& address, const Bytes& value) noexcept;

    EntryTable table_;
    ForeignObjects& foreign_;
    NmtState state_;
};

} // namespace counterpoint::cia301

#endif
