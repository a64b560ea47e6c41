// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_DEVICE_HPP
#define VERIFICATION_CAMPAIGN_DEVICE_HPP

#include "runtime/device/model.hpp"
#include "safety_core/crosslink/peer.hpp"
#include "verification/campaign/feed.hpp"
#include "verification/campaign/flat_self_test.hpp"
#include "verification/campaign/recording.hpp"
#include "verification/campaign/region.hpp"
#include "verification/campaign/surroundings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace counterpoint::campaign
{
/// What the device drives.
enum class OutputKind : std::uint8_t
{
    kGate = 0U, ///< The output gate alone, which is not hit.
    kPins = 1U, ///< The safety pins of the port to the TMS570, which are.
};

/// Parts of the device whose memory is hit. Those that a person would name.
enum class Part : std::uint8_t
{
    kChannelA = 0U,
    kChannelB = 1U,
    kComparator = 2U,
    kFlowMonitor = 3U,
    kGuard = 4U,
    kLatch = 5U,
    kClocks = 6U,
    kKernel = 7U, ///< The rest of it.
    kTables = 8U,
    kVariables = 9U,
    kPins = 10U,      ///< Of the port.
    kCrossLink = 11U, ///< Of a CPU of two: what it keeps of the other one. [SRS_CMG_061]
    // From here on no memory, but kBothChannels.
    kBus = 12U,         ///< Frames that the device receives. [SRS_CMG_020]
    kKernelCalls = 13U, ///< What is called of the kernel. [SRS_CMG_022]
    kCallsOfA = 14U,    ///< What the kernel calls of channel A.
    kCallsOfB = 15U,
    kSteps = 16U,        ///< Of the flow.
    kCounters = 17U,     ///< [SRS_CMG_023]
    kCycle = 18U,        ///< When it is called. [SRS_CMG_561]
    kBothChannels = 19U, ///< A bit in each. [SRS_CMG_024]
    kInputs = 20U,       ///< What the application senses with two paths. [SRS_CMG_025]
    kCommands = 21U,     ///< What the application tells the kernel: NMT states, GFC. [SRS_CMG_029]
    kLink = 22U,         ///< Messages between two CPUs. [SRS_CMG_062]
    kCpu = 23U,          ///< One of two CPUs as a whole. [SRS_CMG_063]
};
constexpr std::size_t kPartCount = 24U;
/// The first so many are memory.
constexpr std::size_t kMemoryPartCount = 12U;

/// A member of the device under test, and where it lies in the region.
struct Place
{
    Part part{Part::kKernel};
    std::string name;
    std::size_t offset{0U};
    std::size_t size{0U};
};

class DisturbedChannel;
class TwoCpus;

/// What a CPU of two needs to know. What it shares with the other one is null for the first of them.
struct CpuOfTwo
{
    LinkConfig link{};
    std::string prefix{}; ///< Of the names of its members.
    FlatApplication* application{nullptr};
    FlatPorts* ports{nullptr};
};

/// What a plan wants of the device.
struct DeviceSetup
{
    std::optional<CpuOfTwo> cpu{}; ///< None: the device has one CPU.
    bool has_call_faults{false};   ///< Something stands in front of the channels.
    bool has_self_test{false};
};

/// Kernel, both channels and all that they work on, in one piece of memory. [SRS_CMG_001]
class Device : private Provider
{
  public:
    /// @brief Builds the device of the model in the region, starts and configures it at power-on of the recording.
    /// Throws std::runtime_error for a device that the kernel refuses.
    Device(Region& region, const runtime::DeviceModel& model, const Recording& recording, OutputKind output,
           const DeviceSetup& setup = {});
    virtual ~Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    /// @brief One cycle of the recording with all that comes before it.
    virtual void Cycle(std::size_t cycle);
    /// @brief What it receives, and the fault of that. To be rewound when its memory is brought back.
    [[nodiscard]] Feed& Receives() noexcept
    {
        return feed_;
    }
    /// @brief What it receives is as before this cycle, and from there on has this fault. To be called when its memory
    /// is brought back; as Feed::Rewind.
    virtual void Rewind(std::size_t cycle, const Experiment* fault, std::size_t end, std::uint64_t seed);
    /// @brief Whether behind this cycle all comes as recorded.
    [[nodiscard]] virtual bool IsUndisturbed(std::size_t cycle) const;
    /// @brief Who is told the phases of each cycle; null: nobody.
    virtual void Follow(PhaseHook* hook) noexcept;
    /// @brief Slots whose outputs are open now.
    [[nodiscard]] virtual SrdoMask Open() noexcept;
    /// @brief Why the device, or one of its CPUs, is safe; kNone: it is not.
    [[nodiscard]] virtual DeviceFault Fault() const noexcept;
    /// @brief Null: it has one CPU. Of two each has an object of each pair, and nobody both.
    [[nodiscard]] virtual const TwoCpus* AsTwoCpus() const noexcept
    {
        return nullptr;
    }

    /// @brief Its memory, member by member.
    [[nodiscard]] const std::vector<Place>& Places() const noexcept
    {
        return places_;
    }
    /// @brief Null: it has none.
    [[nodiscard]] FlatSelfTest* SelfTest() noexcept
    {
        return self_test_.get();
    }
    [[nodiscard]] const std::vector<FlatPair>& Pairs() const noexcept
    {
        return pairs_;
    }
    [[nodiscard]] const DeviceConfig& Config() const noexcept
    {
        return reference_;
    }
    [[nodiscard]] Region& Memory() noexcept
    {
        return region_;
    }
    [[nodiscard]] const FlatApplication& Application() const noexcept
    {
        return *application_;
    }
    [[nodiscard]] const FlatPorts& Ports() const noexcept
    {
        return *ports_;
    }
    /// @brief Channel A (0) or B.
    [[nodiscard]] const Channel& Voice(const std::size_t channel) const noexcept
    {
        return (channel == 0U) ? *a_ : *b_;
    }
    /// @brief Whether the output has not cut itself off.
    [[nodiscard]] bool IsOutputLive() const noexcept
    {
        return output_->is_live;
    }
    [[nodiscard]] virtual bool IsWatchdogAlive() const noexcept
    {
        return watchdog_->timer.IsAlive();
    }

  private:
    friend class TwoCpus; ///< Two of these, each with a channel.

    [[nodiscard]] RefreshAnswer Provide(CommunicationIndex index) noexcept override;
    void CopyTables(const runtime::DeviceModel& model);
    void MakeSurroundings(const Recording& recording, OutputKind output, const DeviceSetup& setup);
    void MakeVoices(const DeviceSetup& setup);
    void MakeChannels(const DeviceSetup& setup);
    void AddToSelfTest();
    void Start(const runtime::DeviceModel& model);
    void Call(std::size_t cycle, Nanoseconds at);
    void Deliver(Nanoseconds at);
    void Add(Part part, const std::string& name, const void* object, std::size_t size);
    void SetTime(Nanoseconds at) noexcept;

    Region& region_;
    const Recording& recording_;
    DeviceConfig reference_; ///< As it was before any fault.
    std::string prefix_;     ///< Of the names of members.
    std::vector<Place> places_{};
    std::vector<FlatPair> pairs_{};
    // In the region.
    DeviceConfig* config_{nullptr};
    FlatApplication* application_{nullptr};
    FlatPorts* ports_{nullptr};
    FlatOutput* output_{nullptr};
    FlatWatchdog* watchdog_{nullptr};
    TappedFlow* flow_{nullptr};
    Channel* a_{nullptr};
    Channel* b_{nullptr};
    std::array<Channel*, 2U> shipped_{};     ///< Both, behind whatever stands in front.
    DisturbedChannel* disturbed_a_{nullptr}; ///< Null: no plan for calls.
    DisturbedChannel* disturbed_b_{nullptr};
    CauseWindows* windows_{nullptr};
    Peer* peer_{nullptr}; ///< Null: the device has one CPU.
    Kernel* kernel_{nullptr};
    PhaseHook* hook_{nullptr};
    std::unique_ptr<FlatSelfTest> self_test_{};
    Feed feed_; ///< Outside of it.
    InputTarget target_{};
};

/// @brief An application does not keep what it was told before somebody acknowledged, or while the device is not
/// OPERATIONAL.
void ForgetErrors(const Recording& recording, std::size_t cycle, FlatApplication& application) noexcept;

/// @brief Which channels report this cause in the last cycle, as marks of an outcome.
[[nodiscard]] std::uint8_t WhoSaid(const Device& device, SrdoCause cause) noexcept;

/// @brief The cause that the application was told first; of those of one cycle, which it is told in the order of their
/// numbers, the one that came first.
[[nodiscard]] SrdoCause FirstCauseOf(const Device& device) noexcept;
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_DEVICE_HPP
