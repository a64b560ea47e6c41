// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_SAFETY_CORE_SELFTEST_DEVICE_HPP
#define TESTS_SAFETY_CORE_SELFTEST_DEVICE_HPP

#include "hal/api/output_gate.hpp"
#include "hal/host/defective_memory.hpp"
#include "hal/host/memory.hpp"
#include "safety_core/selftest/self_test.hpp"
#include "tests/safety_core/selftest/support.hpp"

#include <array>
#include <cstdint>
#include <memory>

namespace counterpoint::selftest
{

/// A real gate that a self test may probe; `defective`: one that accepts everything.
class ProbedOutput final : public hal::SafetyOutput
{
  public:
    std::uint32_t Challenge() noexcept override
    {
        return 1U;
    }
    void Drive(const hal::PermitSet& /*permits*/) noexcept override
    {
    }
    [[nodiscard]] hal::ProbeAnswer Probe(const hal::PermitSet& permits,
                                         const std::uint32_t challenge) const noexcept override
    {
        return defective ? hal::ProbeAnswer::kAccepted : hal::OutputGate::Probe(permits, challenge);
    }

    bool defective{false};
};

/// A small device: 40 words of program in slices of 16 (3), 8 of constants (1), 64 of RAM in slices of 5 (16 + 6), ten
/// permit sets: a round of 36 cycles, and 3 more for a change behind the position of the signature. The cells may be
/// defective.
struct Device
{
    Device()
    {
        setup.parts = PartsSetup{parts.data(), static_cast<std::uint8_t>(parts.size())};
        setup.stack = StackSetup{{Place(stack.data()), 16U}, 4U};
        setup.program = SignatureSetup{{&program_span, 1U}, 16U, SignatureSource::kTaken, 0U};
        setup.constants = SignatureSetup{{&constants_span, 1U}, 16U, SignatureSource::kTaken, 0U};
        setup.ram = RamSetup{{&ram_span, 1U}, &workspace, 5U};
        setup.interval_cycles = 39U;
    }
    [[nodiscard]] hal::Address Place(const void* const object) const
    {
        return cells.PlaceOf(object);
    }
    StartReport Start()
    {
        return self_test.Start(setup);
    }

    host::HostMemory cells{};
    host::DefectiveMemory memory{cells};
    WatchedLock lock{};
    ProbedOutput output{};
    // Begins at a multiple of 256, so that the lines are the same wherever it stands.
    alignas(256) std::array<std::uint32_t, 64> ram{};
    std::array<std::uint32_t, 40> program{};
    std::array<std::uint32_t, 8> constants{};
    std::array<std::uint32_t, 16> stack{};
    RamWorkspace workspace{};
    std::array<hal::Address, 2> parts{Place(&lock), Place(&output)};
    hal::MemorySpan program_span{Place(program.data()), 40U};
    hal::MemorySpan constants_span{Place(constants.data()), 8U};
    hal::MemorySpan ram_span{Place(ram.data()), 64U};
    SelfTestSetup setup{};
    SelfTest self_test{SelfTestPorts{memory, lock, output}};
};

/// On the heap: a device on the running stack would be too near to it to be tested.
inline std::unique_ptr<Device> NewDevice()
{
    return std::make_unique<Device>();
}

} // namespace counterpoint::selftest

#endif
