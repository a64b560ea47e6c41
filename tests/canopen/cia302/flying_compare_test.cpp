// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Three masters of one network, alike but for one thing.
#include "canopen/cia302/el6751_setup.hpp"
#include "canopen/cia302/flying_master_compare.hpp"
#include "canopen/cia302/plc_setup.hpp"
#include "canopen/cia302/safety_check.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

namespace counterpoint::cia302
{
namespace
{

constexpr std::uint8_t kBytes[3] = {1U, 2U, 3U};
constexpr std::uint8_t kOtherBytes[3] = {1U, 2U, 4U};
constexpr ExpectedObject kObjects[2] = {{{0x1301U, 2U}, 25U, false}, {{0x13FFU, 1U}, 0x1234U, false}};
constexpr ExpectedObject kOtherObjects[2] = {{{0x1301U, 2U}, 25U, false}, {{0x13FFU, 1U}, 0x1235U, false}};
constexpr SafetyExpectation kSafety{kObjects, 2U};
constexpr SafetyExpectation kOtherSafety{kOtherObjects, 2U};
constexpr SafetyExpectation kShortSafety{kObjects, 1U};

/// Masters 2, 5 and 9 with slave 95; each has the others as slaves, too.
class FlyingCompare : public ::testing::Test, protected FlyingFindingListener
{
  protected:
    FlyingCompare()
    {
        const std::uint8_t nodes[3] = {2U, 5U, 9U};
        for (std::size_t i = 0U; i < 3U; ++i)
        {
            setups[i] = NetworkSetup{NodeId{nodes[i]}, 0x21U, 3000U, 10U, 0U, slaves[i].data()};
            times[i] = DefaultTimes(NodeId{nodes[i]});
            times[i].priority = static_cast<std::uint16_t>(i);
            views[i] = FlyingMasterView{&setups[i], &times[i]};
            SlaveSetup& slave = slaves[i][95];
            slave.assignment = kInNetwork | kBootSlave;
            slave.dcf = Bytes{kBytes, 3U};
            slave.concise_dcf = Bytes{kBytes, 3U};
            slave.software.program = Bytes{kBytes, 3U};
            slave.safety = &kSafety;
            for (const std::uint8_t node : nodes)
            {
                // What a master knows of itself does not count.
                slaves[i][node].assignment = (node == nodes[i]) ? 0U : kInNetwork;
            }
        }
    }

    void OnFinding(const FlyingFinding& finding) noexcept override
    {
        findings.push_back(finding);
    }
    /// The only finding after `change` of the third master.
    FlyingFinding After(const std::function<void(NetworkSetup&, SlaveSetup&, FlyingMasterTimes&)>& change)
    {
        const NetworkSetup setup = setups[2];
        const SlaveSetup slave = slaves[2][95];
        const FlyingMasterTimes of_third = times[2];
        change(setups[2], slaves[2][95], times[2]);
        findings.clear();
        EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 1U);
        setups[2] = setup;
        slaves[2][95] = slave;
        times[2] = of_third;
        return findings.empty() ? FlyingFinding{} : findings.front();
    }

    std::array<std::array<SlaveSetup, kNodeRoom>, 3> slaves{};
    std::array<NetworkSetup, 3> setups{};
    std::array<FlyingMasterTimes, 3> times{};
    std::array<FlyingMasterView, 3> views{};
    std::vector<FlyingFinding> findings{};
};

TEST_F(FlyingCompare, AlikeButForPriorityAndDetectionCycle)
{
    Verifies(req::SRS_FLY_022);
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 0U);
    EXPECT_EQ(CompareFlyingMasters(views.data(), 0U, *this), 0U);
    EXPECT_EQ(CompareFlyingMasters(nullptr, 3U, *this), 0U);
}

TEST_F(FlyingCompare, EachValueOfMasterAndSlave)
{
    Verifies(req::SRS_FLY_022);
    struct Case
    {
        std::uint16_t index;
        std::uint8_t sub;
        std::uint32_t first;
        std::uint32_t second;
        std::function<void(NetworkSetup&, SlaveSetup&, FlyingMasterTimes&)> change;
    };
    using N = NetworkSetup;
    using S = SlaveSetup;
    using T = FlyingMasterTimes;
    const std::vector<Case> cases{
        {0x1F90U, 1U, 100U, 101U, [](N&, S&, T& t) { t.timeout = 101U; }},
        {0x1F90U, 2U, 500U, 501U, [](N&, S&, T& t) { t.delay = 501U; }},
        {0x1F90U, 4U, 1500U, 1501U, [](N&, S&, T& t) { t.priority_slot = 1501U; }},
        {0x1F90U, 5U, 10U, 11U, [](N&, S&, T& t) { t.device_slot = 11U; }},
        {0x1F80U, 0U, 0x21U, 0x31U, [](N& n, S&, T&) { n.start_up = 0x31U; }},
        {0x1F89U, 0U, 3000U, 0U, [](N& n, S&, T&) { n.boot_time_ms = 0U; }},
        {0x102AU, 0U, 10U, 11U, [](N& n, S&, T&) { n.inhibit_100us = 11U; }},
        {0x1006U, 0U, 0U, 1000U, [](N& n, S&, T&) { n.sync_period_us = 1000U; }},
        {0x1F81U, 95U, 5U, 13U, [](N&, S& s, T&) { s.assignment = 13U; }},
        {0x1F84U, 95U, 0U, 1U, [](N&, S& s, T&) { s.device_type = 1U; }},
        {0x1F85U, 95U, 0U, 1U, [](N&, S& s, T&) { s.vendor_id = 1U; }},
        {0x1F86U, 95U, 0U, 1U, [](N&, S& s, T&) { s.product_code = 1U; }},
        {0x1F87U, 95U, 0U, 1U, [](N&, S& s, T&) { s.revision_number = 1U; }},
        {0x1F88U, 95U, 0U, 1U, [](N&, S& s, T&) { s.serial_number = 1U; }},
        {0x1F8AU, 95U, 0U, 1U, [](N&, S& s, T&) { s.restore_sub = 1U; }},
        {0x1F26U, 95U, 0U, 1U, [](N&, S& s, T&) { s.configuration_date = 1U; }},
        {0x1F27U, 95U, 0U, 1U, [](N&, S& s, T&) { s.configuration_time = 1U; }},
        {0x1F55U, 95U, 0U, 1U, [](N&, S& s, T&) { s.software.identification = 1U; }},
        {0x1F53U, 95U, 0U, 1U, [](N&, S& s, T&) { s.software.date = 1U; }},
        {0x1F54U, 95U, 0U, 1U, [](N&, S& s, T&) { s.software.time = 1U; }},
        {0x1016U, 95U, 0U, 300U, [](N&, S& s, T&) { s.heartbeat.consumer_ms = 300U; }},
        {0x1016U, 95U, 0U, 0x0300'0000U, [](N&, S& s, T&) { s.heartbeat.arming = Arming::kImmediately; }},
        {0x1017U, 95U, 0U, 100U, [](N&, S& s, T&) { s.heartbeat.producer_ms = 100U; }},
    };
    for (const Case& one : cases)
    {
        const FlyingFinding finding = After(one.change);
        EXPECT_EQ(finding.kind, FlyingFindingKind::kValue);
        EXPECT_EQ(finding.index, one.index);
        EXPECT_EQ(finding.sub, one.sub) << std::hex << one.index;
        EXPECT_EQ(finding.first_value, one.first) << std::hex << one.index;
        EXPECT_EQ(finding.second_value, one.second) << std::hex << one.index;
        EXPECT_EQ(finding.first.value, 2U);
        EXPECT_EQ(finding.second.value, 9U);
        EXPECT_EQ(finding.slave.value, (one.sub == 95U) ? 95U : 0U);
    }
}

TEST_F(FlyingCompare, ContentsAndSafetyExpectation)
{
    Verifies(req::SRS_FLY_022);
    FlyingFinding finding =
        After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.concise_dcf = Bytes{kOtherBytes, 3U}; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kContent);
    EXPECT_EQ(finding.index, 0x1F22U);
    EXPECT_EQ(finding.first_value, 2U); // The third byte.
    finding = After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.dcf = Bytes{nullptr, 0U}; });
    EXPECT_EQ(finding.index, 0x1F20U);
    EXPECT_EQ(finding.first_value, 3U);
    EXPECT_EQ(finding.second_value, 0U);
    finding =
        After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.software.program = Bytes{kBytes, 2U}; });
    EXPECT_EQ(finding.index, 0x1F58U);
    finding = After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.safety = &kOtherSafety; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kSafety);
    EXPECT_EQ(finding.index, 0x13FFU);
    EXPECT_EQ(finding.sub, 1U);
    EXPECT_EQ(finding.second_value, 0x1235U);
    finding = After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.safety = &kShortSafety; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kSafety);
    EXPECT_EQ(finding.second_value, 1U);
    finding = After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.safety = nullptr; });
    EXPECT_EQ(finding.second_value, 0U);
}

TEST_F(FlyingCompare, OtherObjectsOfASafetyExpectationAndProfiles)
{
    Verifies(req::SRS_FLY_022);
    const ExpectedObject other_index[2] = {{{0x1302U, 2U}, 25U, false}, kObjects[1]};
    const ExpectedObject other_sub[2] = {{{0x1301U, 3U}, 25U, false}, kObjects[1]};
    const ExpectedObject fixed[2] = {{{0x1301U, 2U}, 25U, true}, kObjects[1]};
    for (const ExpectedObject* const objects : {other_index, other_sub, fixed})
    {
        const SafetyExpectation safety{objects, 2U};
        const FlyingFinding finding =
            After([&safety](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.safety = &safety; });
        EXPECT_EQ(finding.kind, FlyingFindingKind::kSafety);
        EXPECT_EQ(finding.index, 0x1301U);
        EXPECT_EQ(finding.sub, 2U);
    }
    const El6751Slave el6751{};
    FlyingFinding finding =
        After([&el6751](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.el6751 = &el6751; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kProfile);
    EXPECT_EQ(finding.slave.value, 95U);
    EXPECT_EQ(finding.second_value, 1U);
    const PlcSlave plc{};
    finding = After([&plc](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.plc = &plc; });
    EXPECT_EQ(finding.second_value, 2U);
}

TEST_F(FlyingCompare, NodeIdsThatAreNone)
{
    Verifies(req::SRS_FLY_022);
    for (const std::uint8_t node : {std::uint8_t{0U}, std::uint8_t{128U}})
    {
        const FlyingMasterView alone{&setups[0], &times[0]};
        setups[0].own = NodeId{node};
        findings.clear();
        EXPECT_EQ(CompareFlyingMasters(&alone, 1U, *this), 1U);
        EXPECT_EQ(findings[0].kind, FlyingFindingKind::kSameNode);
    }
}

TEST_F(FlyingCompare, EachMasterByItself)
{
    Verifies(req::SRS_FLY_022);
    FlyingFinding finding = After([](NetworkSetup&, SlaveSetup&, FlyingMasterTimes& third) { third.priority = 3U; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kPriority);
    EXPECT_EQ(finding.first.value, 9U);
    // A slot relation that holds for none: one finding a master
    for (FlyingMasterTimes& one : times)
    {
        one.priority_slot = 1270U;
    }
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 3U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kSlots);
    EXPECT_EQ(findings[1].first.value, 5U);
    EXPECT_EQ(findings[1].first_value, 1270U);
    EXPECT_EQ(findings[1].second_value, 10U);
}

TEST_F(FlyingCompare, OneNodeIdTwice)
{
    Verifies(req::SRS_FLY_022);
    // Given a third master with the node-ID of the second one, to whom nodes 2 and 5 are masters; 9 is a slave of all
    setups[2].own = NodeId{5U};
    slaves[2][9].assignment = kInNetwork;
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 1U);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].kind, FlyingFindingKind::kSameNode);
    EXPECT_EQ(findings[0].first_value, 5U);
}

} // namespace
} // namespace counterpoint::cia302
