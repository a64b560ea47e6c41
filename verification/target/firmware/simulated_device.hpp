// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_TARGET_FIRMWARE_SIMULATED_DEVICE_HPP
#define VERIFICATION_TARGET_FIRMWARE_SIMULATED_DEVICE_HPP

#include "examples/firmware/common/device.hpp"
#include "verification/target/firmware/scenario.hpp"
#include "verification/target/firmware/simulated_board.hpp"

namespace counterpoint::target
{

/// Cost of the dearest cycle, in the platform's unit.
struct Cost
{
    std::uint32_t greatest;
    std::uint32_t cycles;
};

/// Runs one firmware example through one scenario, cycle by cycle, and prints what it does: each frame it sends, each
/// change of gate, outputs, states and device fault. The same source on host and target. [SRS_FW_009]
class SimulatedDevice
{
  public:
    explicit SimulatedDevice(hal::MemoryProtection& protection) noexcept;

    /// @brief True if the device started and every expectation held. Calls `non_safety` once a cycle.
    [[nodiscard]] bool Run(const char* scenario, void (*non_safety)() noexcept) noexcept;
    [[nodiscard]] Cost GreatestCost() const noexcept;

  private:
    [[nodiscard]] bool Start() noexcept;
    void PassTime(Scenario& scenario, std::uint32_t until_us) noexcept;
    void ConfirmBefore(std::uint32_t until_us) noexcept;
    void Do(const Event& event) noexcept;
    void Expect(const Event& event) noexcept;
    void Cycle() noexcept;
    void Show() noexcept;
    void ShowSent() noexcept;
    void ShowState(std::uint8_t srdo) noexcept;
    void Note(const char* what, std::uint32_t value) noexcept;
    void Judge(const Event& event, bool holds, const char* what, std::uint32_t got) noexcept;
    [[nodiscard]] InstantPair StampOf(std::uint32_t at_us) const noexcept;
    [[nodiscard]] StateReply StateOf(std::uint32_t srdo) const noexcept;

    static constexpr std::uint32_t kMostShown = 8U;

    SimulatedCan can_{};
    SimulatedOutput output_{};
    SimulatedWatchdog watchdog_{};
    firmware::DrivenDevice driven_;
    Event event_{};
    Cost cost_{0U, 0U};
    SrdoMask open_{0U};
    std::uint32_t now_us_{0U};
    std::uint32_t cycle_at_us_{0U};
    std::uint32_t bus_free_us_{0U};
    std::uint32_t lost_b_us_{0U}; ///< By how much counter B is behind.
    std::uint32_t late_us_{0U};
    std::uint32_t inputs_{0U};
    std::uint32_t outputs_{0U};
    std::uint32_t shown_sent_{0U};
    std::uint32_t shown_gate_{0U};
    std::uint32_t shown_outputs_{0U};
    std::uint32_t shown_fault_{static_cast<std::uint32_t>(DeviceFault::kNone)};
    SrdoState shown_states_[kMostShown]{};
    bool counter_b_stands_{false};
    bool is_good_{true};
    bool has_ended_{false};
};

} // namespace counterpoint::target

#endif
