// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_TMS570_CHIP_SHARED_HPP
#define HAL_TMS570_CHIP_SHARED_HPP

namespace counterpoint::tms570
{

/// A byte, half word or word that interrupt and program share: one access each, never torn, and what was written before
/// a Store is seen by whoever has Loaded its value. One side writes; where both do, the last one wins.
template <class Value> class Shared
{
  public:
    Shared() noexcept = default;
    constexpr explicit Shared(const Value value) noexcept : value_{value}
    {
    }

    /// @brief The value that was stored last.
    [[nodiscard]] Value Load() const noexcept
    {
        Value value{};
        __atomic_load(&value_, &value, __ATOMIC_ACQUIRE); // MISRA D-005
        return value;
    }
    /// @brief Stores a value.
    void Store(const Value value) noexcept
    {
        Value stored{value};
        __atomic_store(&value_, &stored, __ATOMIC_RELEASE); // MISRA D-005
    }

  private:
    static_assert(sizeof(Value) <= 4U, "one access of a 32-bit processor");

    Value value_{};
};

} // namespace counterpoint::tms570

#endif
