// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_SELF_TEST_HPP
#define RUNTIME_NODE_SELF_TEST_HPP

#include "hal/host/interrupt_lock.hpp"
#include "hal/host/memory.hpp"
#include "runtime/device/model.hpp"
#include "runtime/device/owned_channel.hpp"
#include "safety_core/kernel/kernel.hpp"
#include "safety_core/selftest/self_test.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// The shipped self tests, over the memory of this process: program and tables, channels and kernel, the stack below
/// the loop, the parts that the kernel calls. [SRS_NODE_013]
class NodeSelfTest
{
  public:
    /// @brief Nothing is tested yet; `output` outlives it.
    explicit NodeSelfTest(const hal::SafetyOutput& output) noexcept;
    NodeSelfTest(const NodeSelfTest&) = delete;
    NodeSelfTest& operator=(const NodeSelfTest&) = delete;

    /// @brief The part that the kernel is given.
    [[nodiscard]] SelfTestPart& Part() noexcept
    {
        return self_test_;
    }
    /// @brief Adds the storage of a channel to the RAM test.
    void AddChannel(runtime::OwnedChannel& channel);
    /// @brief Adds the kernel to the RAM test.
    void AddKernel(Kernel& kernel);
    /// @brief Adds what does not change after the construction of a device.
    void AddConstants(const DeviceConfig& config, const runtime::DeviceModel& model);
    /// @brief Adds an object that begins with the pointer to its virtual table.
    void AddPart(const void* part);
    /// @brief Call it after everything was added. Makes the slices as small as a round within so many cycles allows.
    /// False: there is no such slicing.
    [[nodiscard]] bool Settle(std::uint32_t interval_cycles);
    /// @brief Runs the start-up test. After a failure the self test goes on failing, and so the kernel learns of it.
    void Start();
    /// @brief What failed first, such as "program"; empty: nothing did.
    [[nodiscard]] std::string Failure() const;
    /// @brief How much is tested: words of program and tables, of RAM, and slices of a round.
    [[nodiscard]] std::string Text() const;

  private:
    [[nodiscard]] bool Fits(std::uint8_t ram_words, std::uint16_t signature_words, std::uint32_t interval_cycles);
    [[nodiscard]] std::uint32_t RoundSlices();

    host::HostMemory memory_{};
    host::HostInterruptLock lock_{};
    selftest::RamWorkspace workspace_{};
    std::vector<hal::MemorySpan> program_;
    std::vector<hal::MemorySpan> constants_;
    std::vector<hal::MemorySpan> live_;
    std::vector<hal::Address> parts_;
    selftest::SelfTestSetup setup_{};
    selftest::SelfTest self_test_;
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_SELF_TEST_HPP
