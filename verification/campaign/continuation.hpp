// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_CONTINUATION_HPP
#define VERIFICATION_CAMPAIGN_CONTINUATION_HPP

#include <cstdint>
#include <ucontext.h>
#include <vector>

namespace counterpoint::campaign
{
/// A place in a running program, with the stack as it is there, to which the program can be brought back once more: how
/// a part of a function runs twice, or behind the one that follows it. Memory is not brought back. [SRS_CMG_028]
class Continuation
{
  public:
    enum class Arrival : std::uint8_t
    {
        kFirst = 0U,   ///< The place was taken.
        kBrought = 1U, ///< Somebody called Resume.
    };

    Continuation() = default;
    Continuation(const Continuation&) = delete; // What the processor kept points into itself.
    Continuation& operator=(const Continuation&) = delete;

    /// @brief Takes this place; returns once more for each Resume. Stack below `end` is what is kept: the frame address
    /// of a function that goes on running until the last Resume.
    [[nodiscard]] Arrival Take(const void* end);
    /// @brief Goes on there.
    [[noreturn]] void Resume();

  private:
    void KeepStack(const void* end);
    void BringBack() noexcept;
    static void OnOtherStack() noexcept;

    ucontext_t place_{};
    ucontext_t carrier_{}; ///< Runs on a stack of its own, for nobody can write over what it stands on.
    std::vector<std::uint8_t> stack_{};
    std::uint8_t* first_{nullptr}; ///< Where it was.
    volatile bool is_brought_{false};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_CONTINUATION_HPP
