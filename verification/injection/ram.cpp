// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/ram.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <sys/mman.h>

namespace counterpoint::injection
{

std::uint8_t* Allocate(const std::uint32_t bytes)
{
    void* const place = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (place == MAP_FAILED)
    {
        throw std::runtime_error{"no memory"};
    }
    return static_cast<std::uint8_t*>(place);
}

Ram::Ram(const RamLayout& layout, const std::uint32_t bytes, const std::uint32_t places)
    : layout_{layout}, bytes_{bytes}, places_{places}, first_{Allocate(bytes)}
{
}

std::vector<std::uint8_t> Ram::Content() const
{
    return {first_, first_ + bytes_};
}

void Ram::Restore(const std::vector<std::uint8_t>& content)
{
    std::memcpy(first_, content.data(), bytes_);
    stuck_at_ = 0U;
}

bool Ram::Equals(const std::vector<std::uint8_t>& content, const std::uint32_t stack)
{
    if (IsStuck())
    {
        // What is stuck is forced again before it is read.
        *At(stuck_at_) =
            static_cast<std::uint8_t>((*At(stuck_at_) & ~stuck_mask_) | (content[PlaceOf(stuck_at_)] & stuck_mask_));
    }
    return (std::memcmp(first_, content.data(), PlaceOf(layout_.live)) == 0) &&
           (std::memcmp(At(stack), &content[PlaceOf(stack)], layout_.top - stack) == 0);
}

void Ram::Add(Digest& to, const std::uint32_t stack) const
{
    to.Add(first_, PlaceOf(layout_.live));
    const std::uint32_t from = std::clamp(stack, layout_.live, layout_.top);
    to.Add(At(from), layout_.top - from);
}

void Ram::Flip(const std::uint32_t address, const std::uint32_t bit)
{
    *At(address) = static_cast<std::uint8_t>(*At(address) ^ (1U << bit));
}

void Ram::Stick(const std::uint32_t address, const std::uint32_t bit, const bool value)
{
    stuck_at_ = address;
    stuck_mask_ = static_cast<std::uint8_t>(1U << bit);
    stuck_value_ = value ? stuck_mask_ : std::uint8_t{0U};
    Force();
}

void Ram::Force()
{
    if (IsStuck())
    {
        *At(stuck_at_) = static_cast<std::uint8_t>((*At(stuck_at_) & ~stuck_mask_) | stuck_value_);
    }
}

void Ram::NoteIn(Accesses* const accesses)
{
    noted_ = accesses;
    if (noted_ != nullptr)
    {
        noted_->zeros.resize(bytes_);
        noted_->ones.resize(bytes_);
        noted_->is_written.resize(bytes_);
    }
}

bool Ram::Has(const std::uint32_t address, const std::uint32_t bytes) const
{
    return (address >= layout_.begin) && ((PlaceOf(address) + bytes) <= bytes_);
}

void Ram::OnRead(const std::uint32_t address, const std::uint32_t bytes)
{
    if (!Has(address, bytes))
    {
        return;
    }
    if ((address <= stuck_at_) && (stuck_at_ < (address + bytes)))
    {
        Force();
    }
    for (std::uint32_t i = 0U; (noted_ != nullptr) && (i < bytes); ++i)
    {
        const std::uint8_t value = *At(address + i);
        const std::uint32_t place = PlaceOf(address + i);
        noted_->ones[place] = static_cast<std::uint8_t>(noted_->ones[place] | value);
        noted_->zeros[place] = static_cast<std::uint8_t>(noted_->zeros[place] | static_cast<std::uint8_t>(~value));
    }
}

void Ram::OnWrite(const std::uint32_t address, const std::uint32_t bytes)
{
    for (std::uint32_t i = 0U; (noted_ != nullptr) && Has(address, bytes) && (i < bytes); ++i)
    {
        noted_->is_written[PlaceOf(address + i)] = true;
    }
}

std::array<ObjectPair, 3> Ram::Objects() const
{
    // Bytes in little-endian order, as on the wire.
    std::array<ObjectPair, 3> objects{};
    for (std::uint32_t i = 0U; i < objects.size(); ++i)
    {
        std::memcpy(&objects[i].normal, At(places_ + (8U * i)), 4U);
        std::memcpy(&objects[i].inverse, At(places_ + (8U * i) + 4U), 4U);
    }
    return objects;
}

void Ram::WriteObjects(const std::uint32_t object, const ObjectPair& values)
{
    std::memcpy(At(places_ + (8U * object)), &values.normal, 4U);
    std::memcpy(At(places_ + (8U * object) + 4U), &values.inverse, 4U);
}

} // namespace counterpoint::injection
