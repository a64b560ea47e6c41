// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_API_PLAIN_MEMORY_HPP
#define HAL_API_PLAIN_MEMORY_HPP

#include "hal/api/memory_access.hpp"

namespace counterpoint::hal
{

/// Accesses the memory itself, on every processor on which an address is a pointer. [SRS_STS_014]
class PlainMemory final : public MemoryAccess
{
  public:
    [[nodiscard]] std::uint32_t Read(Address place) const noexcept override;
    void Write(Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] std::uint32_t Exchange(Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] Address StackPosition() const noexcept override;
    [[nodiscard]] Address PlaceOf(const void* object) const noexcept override;
};

} // namespace counterpoint::hal

#endif
