// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_TRAP_HPP
#define VERIFICATION_CAMPAIGN_TRAP_HPP

#include <csetjmp>
#include <cstdint>

namespace counterpoint::campaign
{
/// How a run came back.
enum class Return : std::uint8_t
{
    kEnded = 0U,
    kException = 1U, ///< A signal of the processor: what a device answers with its exception handler.
    kNever = 2U,     ///< It would not have come back.
};

/// Brings a run back that ends with an exception or not at all. One a process; the run may own nothing that has to be
/// destroyed. While no trap is there a run is not brought back. [SRS_CMG_006]
class Trap
{
  public:
    /// @brief Installs the handlers of signals.
    Trap();
    ~Trap();
    Trap(const Trap&) = delete;
    Trap& operator=(const Trap&) = delete;

    /// @brief Calls `run`.
    template <typename Action> [[nodiscard]] static Return Run(const Action& run)
    {
        const int came_back = sigsetjmp(Place(), 0);
        if (came_back == 0)
        {
            Arm();
            run();
        }
        Disarm();
        return static_cast<Return>(came_back);
    }

  private:
    [[nodiscard]] static sigjmp_buf& Place() noexcept;
    static void Arm() noexcept;
    static void Disarm() noexcept;
};

/// @brief Whether a process, by its status for waitpid, was ended by a signal that is none of the processor: by a
/// person, a batch system, or a system that has no memory left.
[[nodiscard]] bool IsEndFromOutside(int status) noexcept;
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_TRAP_HPP
