// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/region.hpp"

#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace counterpoint::campaign
{
namespace
{
/// Far from where a system puts programs, heaps and libraries; also with any one bit changed.
constexpr std::uintptr_t kAddress = 0x2000'0000'0000U;
/// No access so far on either side: a change in the lower 32 bits of a pointer stays within.
constexpr std::size_t kAround = std::size_t{1U} << 32U;
} // namespace

Region::Region(const std::size_t capacity_bytes) : capacity_(capacity_bytes)
{
    void* const begin = reinterpret_cast<void*>(kAddress - kAround);
    void* const reserved =
        mmap(begin, 2U * kAround, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED_NOREPLACE, -1, 0);
    if (reserved != begin)
    {
        throw std::runtime_error("the memory of the device under test is not available at its address");
    }
    reserved_ = static_cast<std::uint8_t*>(reserved);
    bytes_ = reserved_ + kAround;
    if (mprotect(bytes_, capacity_bytes, PROT_READ | PROT_WRITE) != 0)
    {
        munmap(reserved_, 2U * kAround);
        throw std::runtime_error("no memory for the device under test");
    }
}

Region::~Region()
{
    munmap(reserved_, 2U * kAround);
}

void Region::Close()
{
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    used_ = ((used_ + page - 1U) / page) * page;
    if (used_ < capacity_ && mprotect(bytes_ + used_, capacity_ - used_, PROT_NONE) != 0)
    {
        throw std::runtime_error("no border behind the device under test");
    }
    capacity_ = used_;
}

std::size_t Region::OffsetOf(const void* const object) const noexcept
{
    return static_cast<std::size_t>(static_cast<const std::uint8_t*>(object) - bytes_);
}

void* Region::Take(const std::size_t size, const std::size_t alignment)
{
    const std::size_t begin = ((used_ + alignment - 1U) / alignment) * alignment;
    if (begin + size > capacity_)
    {
        throw std::runtime_error("the device under test is larger than its memory");
    }
    used_ = begin + size;
    return bytes_ + begin;
}
} // namespace counterpoint::campaign
