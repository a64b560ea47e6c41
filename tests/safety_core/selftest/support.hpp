// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_SELFTEST_SUPPORT_HPP
#define TESTS_SAFETY_CORE_SELFTEST_SUPPORT_HPP

#include "hal/api/interrupt_lock.hpp"
#include "hal/api/safety_output.hpp"
#include "hal/host/defective_memory.hpp"
#include "safety_core/selftest/slice.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <ostream>

namespace counterpoint::selftest
{

inline void PrintTo(const SliceResult result, std::ostream* const out)
{
    *out << "SliceResult " << static_cast<int>(result);
}

/// Counts, and shows each moment to the test.
class WatchedLock final : public hal::InterruptLock
{
  public:
    void Lock() noexcept override
    {
        ++locks;
        is_locked = true;
        moment();
    }
    void Unlock() noexcept override
    {
        moment();
        is_locked = false;
    }

    std::uint32_t locks{0U};
    bool is_locked{false};
    std::function<void()> moment{[] {}};
};

/// Another memory with a stack position of the test's choice.
class PlacedMemory final : public hal::MemoryAccess
{
  public:
    PlacedMemory(hal::MemoryAccess& cells, const hal::Address stack) : stack_position(stack), cells_(cells)
    {
    }
    [[nodiscard]] std::uint32_t Read(const hal::Address place) const noexcept override
    {
        Note();
        return cells_.Read(place);
    }
    void Write(const hal::Address place, const std::uint32_t value) noexcept override
    {
        Note();
        cells_.Write(place, value);
    }
    [[nodiscard]] std::uint32_t Exchange(const hal::Address place, const std::uint32_t value) noexcept override
    {
        Note();
        return cells_.Exchange(place, value);
    }
    [[nodiscard]] hal::Address StackPosition() const noexcept override
    {
        return stack_position;
    }
    [[nodiscard]] hal::Address PlaceOf(const void* const object) const noexcept override
    {
        return cells_.PlaceOf(object);
    }

    hal::Address stack_position;
    const WatchedLock* lock{nullptr};   ///< Under which each access should be; null: does not matter.
    mutable std::uint32_t accesses{0U}; ///< With such a lock.
    mutable std::uint32_t unlocked{0U}; ///< Of them, those while it was not locked.

  private:
    void Note() const noexcept
    {
        if (lock != nullptr)
        {
            ++accesses;
            unlocked += lock->is_locked ? 0U : 1U;
        }
    }

    hal::MemoryAccess& cells_;
};

} // namespace counterpoint::selftest

#endif
