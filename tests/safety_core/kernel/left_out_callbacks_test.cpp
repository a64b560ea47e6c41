// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// An application that implements nothing but what it has to.
#include "tests/safety_core/kernel/rig.hpp"
#include "verification/trace/ids/kernel.hpp"

#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace counterpoint
{
namespace
{

class LeastApplication final : public Application
{
  public:
    void OnSrdoEvent(CommunicationIndex index) noexcept override
    {
        events.push_back(index.value);
    }
    void OnSrdoError(CommunicationIndex index, SrdoCause cause) noexcept override
    {
        errors.emplace_back(index.value, cause);
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
        ++invalid;
    }
    void OnDeviceFault(const DeviceFaultReport& report) noexcept override
    {
        faults.push_back(report.fault);
    }

    std::vector<std::uint16_t> events{};
    std::vector<std::pair<std::uint16_t, SrdoCause>> errors{};
    std::vector<DeviceFault> faults{};
    int invalid{0};
};

class LeftOutCallbacks : public Rig
{
  public:
    LeftOutCallbacks() : Rig{nullptr, nullptr, &least}
    {
        least.errors.clear();
        least.faults.clear();
    }

    inline static LeastApplication least{}; // Before the kernel, which is made in the base.
};

/// Each leaves out one callback that tells of an event, an error, an invalid configuration or the safe state.
class WithoutEvent : public Application
{
  protected:
    ~WithoutEvent() = default;

  private:
    void OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept override
    {
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept override
    {
    }
};
class WithoutError : public Application
{
  protected:
    ~WithoutError() = default;

  private:
    void OnSrdoEvent(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept override
    {
    }
};
class WithoutInvalid : public Application
{
  protected:
    ~WithoutInvalid() = default;

  private:
    void OnSrdoEvent(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept override
    {
    }
    void OnDeviceFault(const DeviceFaultReport& /*report*/) noexcept override
    {
    }
};
class WithoutFault : public Application
{
  protected:
    ~WithoutFault() = default;

  private:
    void OnSrdoEvent(CommunicationIndex /*index*/) noexcept override
    {
    }
    void OnSrdoError(CommunicationIndex /*index*/, SrdoCause /*cause*/) noexcept override
    {
    }
    void OnConfigurationInvalid(CommunicationIndex /*index*/) noexcept override
    {
    }
};

TEST(MandatoryCallbacks, NoneOfThemMayBeLeftOut)
{
    Verifies(req::SRS_KRN_040);
    // Given an application that has them and no other, then there is one; without any one of them there is none
    EXPECT_FALSE(std::is_abstract_v<LeastApplication>);
    EXPECT_TRUE(std::is_abstract_v<WithoutEvent>);
    EXPECT_TRUE(std::is_abstract_v<WithoutError>);
    EXPECT_TRUE(std::is_abstract_v<WithoutInvalid>);
    EXPECT_TRUE(std::is_abstract_v<WithoutFault>);
}

// Node-ID 2: the producer of form kProviderCalled is due 1 ms after OPERATIONAL was entered, and asked in each cycle.
TEST_F(LeftOutCallbacks, ProducerThatIsAskedSendsNothing)
{
    Verifies(req::SRS_KRN_040);
    Operate();
    Cycles(49U);
    EXPECT_TRUE(ports.sent.empty());
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    ASSERT_FALSE(least.errors.empty());
    EXPECT_EQ(least.errors.front(), (std::pair<std::uint16_t, SrdoCause>{0x1303U, SrdoCause::kRefreshMissed}));
    Application* volatile const asked = &least; // As the kernel calls it: not known at compile time.
    EXPECT_EQ(asked->OnRefresh(CommunicationIndex{0x1303U}), RefreshAnswer::kSkip);
}

TEST_F(LeftOutCallbacks, GfcAndFlowEventsAreForNobody)
{
    Verifies(req::SRS_KRN_040);
    Operate();
    ReceivePair();
    Cycle();
    ASSERT_EQ(Open(), 1U);
    // Given a GFC, when the cycle comes, then the consumer is safe as ever
    Receive(0x001U, {});
    Cycle();
    EXPECT_EQ(Open(), 0U);
    EXPECT_EQ(NormalOut(), 0x7F01U);
    // and one of its own that nothing follows within the refresh time of 25 ms disturbs nothing.
    ASSERT_EQ(kernel.SendGfc(), Result::kSuccessful);
    Cycles(30U);
    EXPECT_EQ(kernel.DeviceState().fault, DeviceFault::kNone);
    EXPECT_TRUE(WatchdogAlive());
}

} // namespace
} // namespace counterpoint
