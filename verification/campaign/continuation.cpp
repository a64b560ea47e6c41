// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/campaign/continuation.hpp"

#include <array>
#include <cstdlib>
#include <cstring>

namespace counterpoint::campaign
{
namespace
{
constexpr std::size_t kCarrierBytes = 65536U;

alignas(16) std::array<std::uint8_t, kCarrierBytes> carrier_stack{};
Continuation* resumed = nullptr;
} // namespace

Continuation::Arrival Continuation::Take(const void* const end)
{
    is_brought_ = false;
    getcontext(&place_);
    if (is_brought_)
    {
        return Arrival::kBrought;
    }
    KeepStack(end);
    return Arrival::kFirst;
}

/// Its own frame lies below that of Take, all of which is kept so.
[[gnu::noinline]] void Continuation::KeepStack(const void* const end)
{
    first_ = static_cast<std::uint8_t*>(__builtin_frame_address(0));
    const std::uint8_t* const first = first_;
    stack_.assign(first, static_cast<const std::uint8_t*>(end));
}

void Continuation::Resume()
{
    is_brought_ = true;
    resumed = this;
    getcontext(&carrier_);
    carrier_.uc_stack.ss_sp = carrier_stack.data();
    carrier_.uc_stack.ss_size = carrier_stack.size();
    carrier_.uc_link = nullptr;
    makecontext(&carrier_, &Continuation::OnOtherStack, 0);
    setcontext(&carrier_);
    std::abort(); // Not reached.
}

void Continuation::OnOtherStack() noexcept
{
    resumed->BringBack();
}

void Continuation::BringBack() noexcept
{
    std::memcpy(first_, stack_.data(), stack_.size());
    setcontext(&place_);
}
} // namespace counterpoint::campaign
