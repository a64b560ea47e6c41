// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
#define RUNTIME_DEVICE_OBJECTS_HOOKS_HPP

#include "canopen/cia301/dictionary/entry.hpp"

#include <algorithm>
#include <cstdint>

namespace counterpoint::runtime
{
/// Hook of values that cannot change while the device runs: writing the same value is accepted, any other value is
/// refused.
class FixedHook final : public cia301::WriteHook
{
  public:
    /// @brief `table` outlives the hook; `refusal` is the answer to another value.
    FixedHook(const cia301::EntryTable& table, const cia301::SdoAbort refusal) noexcept
        : table_(table), refusal_(refusal)
    {
    }
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override
    {
        const auto* const end = table_.entries + table_.count;
        const auto* const entry = std::find_if(table_.entries, end, [&address](const cia301::Entry& each)
                                               { return each.index == address.index && each.sub == address.sub; });
        const bool is_same = entry != end && std::equal(value.data, value.data + value.size_bytes, entry->place);
        return is_same ? cia301::SdoAbort::kNone : refusal_;
    }

  private:
    const cia301::EntryTable& table_;
    cia301::SdoAbort refusal_;
};

/// Hook of 1010h and 1011h of a device without a store, and of their groups that no store has: sub-indices say that
/// nothing is saved, and commands are refused.
class NoStoreHook final : public cia301::ReadHook, public cia301::WriteHook
{
  public:
    [[nodiscard]] cia301::Reading OnRead(const ObjectAddress& address, const cia301::Room& room) noexcept override
    {
        static_cast<void>(address);
        constexpr std::uint32_t kSize = 4U;
        if (room.size_bytes < kSize)
        {
            return {cia301::SdoAbort::kOutOfMemory, 0U};
        }
        std::fill_n(room.data, kSize, std::uint8_t{0U});
        return {cia301::SdoAbort::kNone, kSize};
    }
    [[nodiscard]] cia301::SdoAbort OnWrite(const ObjectAddress& address, const cia301::Bytes& value) noexcept override
    {
        static_cast<void>(address);
        static_cast<void>(value);
        return cia301::SdoAbort::kNotStored;
    }
};
} // namespace counterpoint::runtime

#endif // RUNTIME_DEVICE_OBJECTS_HOOKS_HPP
