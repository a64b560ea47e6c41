// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/world/node/image.hpp"

#include "safety_core/kernel/kernel.hpp"

#include <cstring>

namespace counterpoint::simulator
{
namespace
{
constexpr std::size_t kChannelFunctions = 19U; ///< Of the interface, as the virtual table has them.
constexpr std::size_t kCodeBytes = 128U;       ///< Of each function, from its beginning on.

std::uintptr_t PointerIn(const void* const object) noexcept
{
    std::uintptr_t pointer = 0U;
    std::memcpy(&pointer, object, sizeof pointer);
    return pointer;
}

/// Where a member function that is not virtual begins (Itanium C++ ABI).
template <typename Member> std::uintptr_t BeginOf(const Member member) noexcept
{
    return PointerIn(&member);
}
} // namespace

void NodeImage::CopyCode(const std::uintptr_t function)
{
    const std::size_t words = kCodeBytes / sizeof(std::uint32_t);
    program.resize(program.size() + words);
    std::memcpy(program.data() + program.size() - words, reinterpret_cast<const void*>(function), kCodeBytes);
}

void NodeImage::CopyTable(const Channel& channel)
{
    std::array<std::uintptr_t, kChannelFunctions> table{};
    std::memcpy(table.data(), reinterpret_cast<const void*>(PointerIn(&channel)), sizeof table);
    for (const std::uintptr_t function : table)
    {
        CopyCode(function);
    }
    const std::size_t words = sizeof table / sizeof(std::uint32_t);
    program.resize(program.size() + words);
    std::memcpy(program.data() + program.size() - words, table.data(), sizeof table);
}

void NodeImage::TakeProgram(const Channel& channel_a, const Channel& channel_b)
{
    CopyTable(channel_a);
    CopyTable(channel_b);
    CopyCode(BeginOf(&Kernel::OnFrame));
    CopyCode(BeginOf(&Kernel::OnConfirm));
    CopyCode(BeginOf(&Kernel::OnOverflow));
    CopyCode(BeginOf(&Kernel::Cycle));
    CopyCode(BeginOf(&Kernel::Start));
    CopyCode(BeginOf(&Kernel::WriteObject));
    CopyCode(BeginOf(&ClockSupervisor::OnCycle));
    CopyCode(BeginOf(&SafeStateLatch::Enter));
}

void NodeImage::AddPart(void* const part)
{
    parts.push_back(part);
    pointers_.push_back(PointerIn(part));
}

void NodeImage::RestorePointers()
{
    for (std::size_t part = 0U; part < parts.size(); ++part)
    {
        std::memcpy(parts[part], &pointers_[part], sizeof pointers_[part]);
    }
    may_be_wild_ = false;
}

bool NodeImage::IsWild() const noexcept
{
    for (std::size_t part = 0U; may_be_wild_ && part < parts.size(); ++part)
    {
        if (PointerIn(parts[part]) != pointers_[part])
        {
            return true;
        }
    }
    return false;
}

std::vector<MemoryPiece> NodeImage::Program()
{
    return {{reinterpret_cast<std::uint8_t*>(program.data()), program.size() * sizeof(std::uint32_t)}};
}

std::vector<MemoryPiece> NodeImage::Pointers()
{
    std::vector<MemoryPiece> pieces;
    for (void* const part : parts)
    {
        pieces.push_back({static_cast<std::uint8_t*>(part), sizeof(void*)});
    }
    return pieces;
}

std::vector<MemoryPiece> NodeImage::Guard()
{
    return {{reinterpret_cast<std::uint8_t*>(stack.data()), kGuardWords * sizeof(std::uint32_t)}};
}
} // namespace counterpoint::simulator
