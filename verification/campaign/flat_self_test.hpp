// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_FLAT_SELF_TEST_HPP
#define VERIFICATION_CAMPAIGN_FLAT_SELF_TEST_HPP

#include "simulator/world/node/self_test.hpp"
#include "verification/campaign/region.hpp"

#include <cstddef>
#include <cstdint>

namespace counterpoint::campaign
{
/// The shipped self tests of the device under test, over its live memory as it lies in the region: a march that runs
/// over a cell which is stuck reads what that cell can hold. What changes while they run lies in the region.
/// [SRS_CMG_027]
class FlatSelfTest
{
  public:
    /// @brief Both outlive it.
    FlatSelfTest(Region& region, const hal::SafetyOutput& output);

    [[nodiscard]] SelfTestPart& Part() noexcept
    {
        return test_;
    }
    /// @brief An object that begins with the pointer to its virtual table.
    void AddPart(void* const part)
    {
        image_.AddPart(part);
    }
    void AddLive(void* const bytes, const std::size_t size)
    {
        test_.AddLive(bytes, size);
    }
    void AddConstant(const void* const bytes, const std::size_t size)
    {
        test_.AddConstant(bytes, size);
    }
    /// @brief The start-up test. Throws std::runtime_error where a round does not fit into so many cycles.
    void Start(const Channel& channel_a, const Channel& channel_b, std::uint32_t cycles);
    /// @brief From now on this cell holds one level alone.
    void Stick(std::uint8_t* byte, std::uint8_t bit, bool level);
    /// @brief No cell does.
    void Release() noexcept
    {
        memory_.Release();
    }

  private:
    simulator::NodeMemory memory_{};
    simulator::NodeImage image_{};
    simulator::PartFaults faults_{};
    simulator::NodeSelfTest& test_; ///< In the region.
};
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_FLAT_SELF_TEST_HPP
