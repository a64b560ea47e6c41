// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_MEMORY_HPP
#define HAL_HOST_MEMORY_HPP

#include "hal/api/memory_access.hpp"

#include <cstdint>

namespace counterpoint::host
{

/// The memory of this process; it may also access the guard zones of a sanitizer. [SRS_STS_014]
class HostMemory final : public hal::MemoryAccess
{
  public:
    [[nodiscard]] std::uint32_t Read(hal::Address place) const noexcept override;
    void Write(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] std::uint32_t Exchange(hal::Address place, std::uint32_t value) noexcept override;
    [[nodiscard]] hal::Address StackPosition() const noexcept override;
    [[nodiscard]] hal::Address PlaceOf(const void* object) const noexcept override;
};

} // namespace counterpoint::host

#endif
