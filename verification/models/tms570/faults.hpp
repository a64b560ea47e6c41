// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_MODELS_TMS570_FAULTS_HPP
#define VERIFICATION_MODELS_TMS570_FAULTS_HPP

#include <cstdint>
#include <set>

namespace counterpoint::tms570::model
{

/// Everything that a register model can be made to do wrong. docs/tms570_faults.md has one row for each, with the
/// reaction of the drivers. [SRS_TMS_070]
enum class Fault : std::uint8_t
{
    kDcanBusyForEver,
    kDcanInitStuck,
    kDcanTimingLost,
    kDcanObjectLost,
    kDcanLostMessage,
    kDcanParityError,
    kDcanWrongReadBack,
    kDcanControlChanged,
    kDcanBusOff,
    kDcanTwoPending,
    kDcanForeignObject,
    kCounterAStoppedAtStart,
    kCounterBStoppedAtStart,
    kCounterAStops,
    kCounterBFast,
    kCounterSetUpChanged,
    kWatchdogNotEnabled,
    kWatchdogPeriodLost,
    kWatchdogReactionLost,
    kWatchdogWindowLost,
    kWatchdogOff,
    kPinStuckHighAtStart,
    kPinStuckHigh,
    kPinStuckLow,
    kPinNotOutput,
    kPinStaysOutput,
    kMpuWithoutRegions,
    kMpuRegionLost,
    kMpuTurnedOff,
    kEsmGroup2Before,
    kEsmGroup3Before,
    kEsmPinStuckHigh,
    kEsmPinStuckLow,
    kEsmWriteLost,
    kEsmLowTimeLost,
    kEsmReservedChannel,
    kEsmUncorrectable,
    kEsmCorrectedAgain,
    kCcmSelfTestFails,
    kCcmSelfTestEndless,
    kCcmForcedErrorUnseen,
    kCcmSelfTestErrorUnseen,
    kCcmCompareError,
    kCcmNotLockstep,
    kVimParityUnseen,
    kVimParityError,
    kVimOneBitUnseen,
    kVimTwoBitsUnseen,
    kVimTwoBitsTakenForOne,
    kVimOneBitError,
    kVimTwoBitError,
    kVimCheckOff,
    kVimTableStuck,
    kVimFallbackLost,
    kVimEnableLost,
    kVimUnknownRequest,
    kDccEndless,
    kDccWrongClock,
    kDccClockDrifts,
    kDccTurnedOff,
    kRamOneBitUnseen,
    kRamOneBitWrong,
    kRamTwoBitsUnseen,
    kFlashOneBitUnseen,
    kFlashTwoBitsUnseen,
    kPllNeverLocks,
    kOscillatorFails,
    kClockWriteLost,
    kPllSlips,
    kMemoryInitEndless,
    kLbistCheckPasses,
    kLbistFails,
    kLbistTimesOut,
    kPbistCheckPasses,
    kPbistFails,
    kPbistEndless,
};

struct FaultName
{
    Fault fault;
    const char* name;
};

inline constexpr FaultName kFaultNames[] = {
    {Fault::kDcanBusyForEver, "dcan_busy_for_ever"},
    {Fault::kDcanInitStuck, "dcan_init_stuck"},
    {Fault::kDcanTimingLost, "dcan_timing_lost"},
    {Fault::kDcanObjectLost, "dcan_object_lost"},
    {Fault::kDcanLostMessage, "dcan_lost_message"},
    {Fault::kDcanParityError, "dcan_parity_error"},
    {Fault::kDcanWrongReadBack, "dcan_wrong_read_back"},
    {Fault::kDcanControlChanged, "dcan_control_changed"},
    {Fault::kDcanBusOff, "dcan_bus_off"},
    {Fault::kDcanTwoPending, "dcan_two_pending"},
    {Fault::kDcanForeignObject, "dcan_foreign_object"},
    {Fault::kCounterAStoppedAtStart, "counter_a_stopped_at_start"},
    {Fault::kCounterBStoppedAtStart, "counter_b_stopped_at_start"},
    {Fault::kCounterAStops, "counter_a_stops"},
    {Fault::kCounterBFast, "counter_b_fast"},
    {Fault::kCounterSetUpChanged, "counter_set_up_changed"},
    {Fault::kWatchdogNotEnabled, "watchdog_not_enabled"},
    {Fault::kWatchdogPeriodLost, "watchdog_period_lost"},
    {Fault::kWatchdogReactionLost, "watchdog_reaction_lost"},
    {Fault::kWatchdogWindowLost, "watchdog_window_lost"},
    {Fault::kWatchdogOff, "watchdog_off"},
    {Fault::kPinStuckHighAtStart, "pin_stuck_high_at_start"},
    {Fault::kPinStuckHigh, "pin_stuck_high"},
    {Fault::kPinStuckLow, "pin_stuck_low"},
    {Fault::kPinNotOutput, "pin_not_output"},
    {Fault::kPinStaysOutput, "pin_stays_output"},
    {Fault::kMpuWithoutRegions, "mpu_without_regions"},
    {Fault::kMpuRegionLost, "mpu_region_lost"},
    {Fault::kMpuTurnedOff, "mpu_turned_off"},
    {Fault::kEsmGroup2Before, "esm_group_2_before"},
    {Fault::kEsmGroup3Before, "esm_group_3_before"},
    {Fault::kEsmPinStuckHigh, "esm_pin_stuck_high"},
    {Fault::kEsmPinStuckLow, "esm_pin_stuck_low"},
    {Fault::kEsmWriteLost, "esm_write_lost"},
    {Fault::kEsmLowTimeLost, "esm_low_time_lost"},
    {Fault::kEsmReservedChannel, "esm_reserved_channel"},
    {Fault::kEsmUncorrectable, "esm_uncorrectable"},
    {Fault::kEsmCorrectedAgain, "esm_corrected_again"},
    {Fault::kCcmSelfTestFails, "ccm_self_test_fails"},
    {Fault::kCcmSelfTestEndless, "ccm_self_test_endless"},
    {Fault::kCcmForcedErrorUnseen, "ccm_forced_error_unseen"},
    {Fault::kCcmSelfTestErrorUnseen, "ccm_self_test_error_unseen"},
    {Fault::kCcmCompareError, "ccm_compare_error"},
    {Fault::kCcmNotLockstep, "ccm_not_lockstep"},
    {Fault::kVimParityUnseen, "vim_parity_unseen"},
    {Fault::kVimParityError, "vim_parity_error"},
    {Fault::kVimOneBitUnseen, "vim_one_bit_unseen"},
    {Fault::kVimTwoBitsUnseen, "vim_two_bits_unseen"},
    {Fault::kVimTwoBitsTakenForOne, "vim_two_bits_taken_for_one"},
    {Fault::kVimOneBitError, "vim_one_bit_error"},
    {Fault::kVimTwoBitError, "vim_two_bit_error"},
    {Fault::kVimCheckOff, "vim_check_off"},
    {Fault::kVimTableStuck, "vim_table_stuck"},
    {Fault::kVimFallbackLost, "vim_fallback_lost"},
    {Fault::kVimEnableLost, "vim_enable_lost"},
    {Fault::kVimUnknownRequest, "vim_unknown_request"},
    {Fault::kDccEndless, "dcc_endless"},
    {Fault::kDccWrongClock, "dcc_wrong_clock"},
    {Fault::kDccClockDrifts, "dcc_clock_drifts"},
    {Fault::kDccTurnedOff, "dcc_turned_off"},
    {Fault::kRamOneBitUnseen, "ram_one_bit_unseen"},
    {Fault::kRamOneBitWrong, "ram_one_bit_wrong"},
    {Fault::kRamTwoBitsUnseen, "ram_two_bits_unseen"},
    {Fault::kFlashOneBitUnseen, "flash_one_bit_unseen"},
    {Fault::kFlashTwoBitsUnseen, "flash_two_bits_unseen"},
    {Fault::kPllNeverLocks, "pll_never_locks"},
    {Fault::kOscillatorFails, "oscillator_fails"},
    {Fault::kClockWriteLost, "clock_write_lost"},
    {Fault::kPllSlips, "pll_slips"},
    {Fault::kMemoryInitEndless, "memory_init_endless"},
    {Fault::kLbistCheckPasses, "lbist_check_passes"},
    {Fault::kLbistFails, "lbist_fails"},
    {Fault::kLbistTimesOut, "lbist_times_out"},
    {Fault::kPbistCheckPasses, "pbist_check_passes"},
    {Fault::kPbistFails, "pbist_fails"},
    {Fault::kPbistEndless, "pbist_endless"},
};

/// The faults that are set at this moment.
class FaultSet
{
  public:
    void Set(const Fault fault)
    {
        faults_.insert(fault);
    }
    void Clear(const Fault fault)
    {
        faults_.erase(fault);
    }
    [[nodiscard]] bool Has(const Fault fault) const
    {
        return faults_.count(fault) != 0U;
    }

  private:
    std::set<Fault> faults_{};
};

} // namespace counterpoint::tms570::model

#endif
