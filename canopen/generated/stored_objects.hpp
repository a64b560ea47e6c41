// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_GENERATED_STORED_OBJECTS_HPP
#define CANOPEN_GENERATED_STORED_OBJECTS_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <cstdint>

namespace counterpoint::generated
{

constexpr std::uint8_t kMaxHookedRanges = 8U;

/// A range of indices, both ends included.
struct IndexRange
{
    std::uint16_t first;
    std::uint16_t last;
};

/// The hooks that keep the objects of a range; null: the stored value is used.
struct ObjectHooks
{
    cia301::ReadHook* read;
    cia301::WriteHook* write;
};

/// Whether hooks were attached.
enum class AttachResult : std::uint8_t
{
    kInvalid = 0U,
    kAttached = 0x69U,
    kOverlap = 1U, ///< The range is empty, or a part of it has hooks already.
    kFull = 2U,    ///< kMaxHookedRanges have hooks.
};

/// What Preset came to: how many values were refused, and the first of them; kNone: all were taken.
struct PresetReply
{
    cia301::SdoAbort abort;
    ObjectAddress object;
    std::uint32_t refused;
};

/// Hook of all entries that have a place: asks the hook that is attached to the object, else reads and writes the
/// place. The number of sub-indices of a service's object, and a sub-index that its hook has not, are those of the
/// place. Attached hooks are kept by reference. Not reentrant. [SRS_GEN_008, SRS_GEN_027]
class StoredObjects final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    /// @brief `table` may be defined after this object: it is read only when an entry is accessed.
    explicit constexpr StoredObjects(const cia301::EntryTable& table) noexcept : table_(table)
    {
    }

    /// @brief From now on these hooks keep the objects of the range. O(ranges)
    [[nodiscard]] AttachResult Attach(const IndexRange& range, const ObjectHooks& hooks) noexcept;
    /// @brief Tells the hook of each entry of the range the value of the file, whatever its access right, and all of
    /// them whatever is refused; but for sub-index 0 of an object that has others, of mappings excepted, and for what a
    /// device has of its own (cia301::IsOwnObject). Within a reset of canopen/device services take them in any order;
    /// elsewhere the rules for clients hold. O(entries) [SRS_GEN_019]
    [[nodiscard]] PresetReply Preset(const IndexRange& range) noexcept;
    /// @brief Behind the reset: the values of the range that a hook has not as they are stored, because they do not go
    /// with the others. O(entries) [SRS_GEN_019]
    [[nodiscard]] PresetReply Compare(const IndexRange& range) noexcept;

    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override;
    [[nodiscard]] cia301::SdoAbort OnWriteAgain(const ObjectAddress& address,
                                                const cia301::Bytes& value) noexcept override;

  private:
    struct HookedRange
    {
        IndexRange range;
        ObjectHooks hooks;
    };

    [[nodiscard]] ObjectHooks AttachedTo(std::uint16_t index) const noexcept;
    [[nodiscard]] ObjectHooks HooksOf(const ObjectAddress& address) const noexcept;
    [[nodiscard]] const cia301::Entry* Find(const ObjectAddress& address) const noexcept;
    [[nodiscard]] bool IsPreset(std::uint32_t position, const IndexRange& range) const noexcept;
    [[nodiscard]] static cia301::SdoAbort CompareEntry(const cia301::Entry& entry, cia301::ReadHook& hook) noexcept;

    cia301::EntryTable table_;
    HookedRange ranges_[kMaxHookedRanges]{}; ///< The first `count_`.
    std::uint8_t count_{0U};
};

} // namespace counterpoint::generated

#endif
