// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_RECORDING_HPP
#define VERIFICATION_CAMPAIGN_RECORDING_HPP

#include "hal/host/clocks.hpp"
#include "runtime/yaml/value.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "simulator/judge/run.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
using runtime::Nanoseconds;

/// The counters of a node at any time of the bus.
class Counters
{
  public:
    explicit Counters(const simulator::NodeSetup& setup);

    /// @brief From `at` on counter A (0), B (1) or both (2) run by so much faster than they do, and jump. [SRS_CMG_023]
    void Disturb(std::size_t which, Nanoseconds at, std::int64_t rate_ppm, std::int32_t jump_us);
    [[nodiscard]] InstantPair At(const Nanoseconds at) const
    {
        return {a_.At(at), b_.At(at)};
    }

  private:
    host::HostClock a_;
    host::HostClock b_;
    std::int64_t rate_a_;
    std::int64_t rate_b_;
};

/// A frame of another device as the device under test gets it.
struct RecordedFrame
{
    Nanoseconds at{0};
    StampedFrame stamped{};
};

/// A complete pair of an SRDO that the device consumes: indices of frames.
struct RecordedPair
{
    std::size_t normal{0U};
    std::size_t inverse{0U};
};

/// What happens to the device from one cycle to the next.
struct RecordedCycle
{
    Nanoseconds at{0};
    CycleCall call{};
    std::size_t frames_end{0U}; ///< Frames of the recording before this one have come.
    NmtState nmt{NmtState::kInvalid};
};

/// What the application hands to the kernel: an NMT state, or the wish to send the GFC.
struct Command
{
    bool is_gfc{false};
    NmtState nmt{NmtState::kInvalid};
};

/// A command, and the first cycle behind it. [SRS_CMG_029]
struct RecordedCommand
{
    std::size_t cycle{0U};
    Command what{};
};

/// An input of the application that changes.
struct RecordedInput
{
    std::size_t cycle{0U}; ///< The first one that sees it.
    ObjectAddress object{0U, 0U};
    std::uint64_t value{0U};
};

/// Everything that one device of a scenario without faults receives, written down once. [SRS_CMG_002]
struct Recording
{
    std::vector<RecordedCycle> cycles;
    std::vector<RecordedFrame> frames;
    std::vector<RecordedPair> pairs;
    std::vector<std::uint32_t> identifiers; ///< Of the frames, each once.
    std::vector<RecordedInput> inputs;
    std::vector<RecordedCommand> commands;
    Nanoseconds frame_ns{0}; ///< Time that a frame of the device takes on the bus.
    Nanoseconds power_on{0};
    Counters counters{simulator::NodeSetup{}};
    std::vector<std::uint32_t> peer_scts; ///< Of each SRDO of the device, in us: the shortest SCT of who consumes it.
};

/// A scenario as it ran in the simulator, and the device of it that is hit.
class RecordedScenario
{
  public:
    /// @brief Runs the scenario. `device` is where its name stands. Throws YamlError, also for a device or scenario
    /// that cannot be recorded, and cia306::InputError.
    RecordedScenario(const std::string& file, const runtime::YamlValue& device);

    [[nodiscard]] const Recording& Record() const noexcept
    {
        return recording_;
    }
    /// @brief Of CPU B; for a device with two CPUs alone.
    [[nodiscard]] const Recording& SecondRecord() const noexcept
    {
        return second_;
    }
    [[nodiscard]] const runtime::DeviceModel& SecondModel() const
    {
        return run_.ModelOf(node_ + 1U);
    }
    [[nodiscard]] bool HasTwoCpus() const
    {
        return run_.Setting().nodes[node_].role != runtime::CpuRole::kWhole;
    }
    [[nodiscard]] const simulator::LinkSetup& Link() const
    {
        return run_.Setting().nodes[node_].link;
    }
    [[nodiscard]] const runtime::DeviceModel& Model() const
    {
        return run_.ModelOf(node_);
    }
    /// @brief What the simulator noted of the same run.
    [[nodiscard]] const simulator::Run& Simulated() const noexcept
    {
        return run_;
    }
    /// @brief Its index in the scenario.
    [[nodiscard]] simulator::NodeIndex Node() const noexcept
    {
        return node_;
    }

  private:
    [[nodiscard]] simulator::NodeIndex Find(const runtime::YamlValue& device) const;
    void RequireThatItCanBeRecorded(const runtime::YamlValue& device) const;
    void CountByFirst();
    [[nodiscard]] Recording RecordOf(simulator::NodeIndex node);
    [[nodiscard]] bool IsOwn(simulator::NodeIndex node) const;
    void RecordCycles();
    void RecordFrames();
    void RecordPairs();
    void RecordInputs();
    void RecordCommands();
    void RecordPeers();

    simulator::Run run_;
    simulator::NodeIndex node_;
    Recording recording_{};
    Recording second_{};
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_RECORDING_HPP
