// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef EXAMPLES_FIRMWARE_COMMON_CELL_HPP
#define EXAMPLES_FIRMWARE_COMMON_CELL_HPP

#include <cstdint>
#include <new>
#include <utility>

namespace counterpoint::firmware
{

/// Room for one object in a section of the linker script, zero until Make. The object lives as long as the device runs.
template <class Kept> class Cell
{
  public:
    template <class... Arguments> Kept& Make(Arguments&&... arguments) noexcept
    {
        return *new (bytes_) Kept{std::forward<Arguments>(arguments)...};
    }

  private:
    alignas(Kept) std::uint8_t bytes_[sizeof(Kept)];
};

} // namespace counterpoint::firmware

#endif
