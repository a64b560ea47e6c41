// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
//
// Three masters of one network, alike but for one thing.
#include "canopen/cia302/flying_master/compare.hpp"
#include "canopen/cia302/safety_gate/safety_check.hpp"
#include "canopen/start_up/el6751/setup.hpp"
#include "canopen/start_up/plc_designer/setup.hpp"
#include "verification/trace/ids/flying_master.hpp"
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
        EXPECT_EQ(finding.first, 0U);
        EXPECT_EQ(finding.second, 2U);
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
    EXPECT_EQ(finding.kind, FlyingFindingKind::kOnlyFirst);
    EXPECT_EQ(finding.index, 0x13FFU);
    EXPECT_EQ(finding.first_value, 0x1234U);
    finding = After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&)
                    { slave.heartbeat.arming = Arming::kImmediately; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kArming);
    EXPECT_EQ(finding.second_value, 3U);
}

TEST_F(FlyingCompare, EachObjectOfASafetyExpectation)
{
    Verifies(req::SRS_FLY_022);
    const ExpectedObject fixed[2] = {{{0x1301U, 2U}, 25U, true}, kObjects[1]};
    const SafetyExpectation is_fixed{fixed, 2U};
    EXPECT_EQ(After([&](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.safety = &is_fixed; }).kind,
              FlyingFindingKind::kSafety);
    // Given another object in the place of the first one, and a further one
    const ExpectedObject others[3] = {{{0x1302U, 2U}, 26U, false}, kObjects[1], {{0x13FFU, 2U}, 7U, false}};
    const SafetyExpectation other{others, 3U};
    slaves[2][95].safety = &other;
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 3U);
    EXPECT_EQ(findings[0].kind, FlyingFindingKind::kOnlyFirst);
    EXPECT_EQ(findings[0].index, 0x1301U);
    EXPECT_EQ(findings[0].first_value, 25U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kOnlySecond);
    EXPECT_EQ(findings[1].index, 0x1302U);
    EXPECT_EQ(findings[1].second_value, 26U);
    EXPECT_EQ(findings[2].sub, 2U);
    EXPECT_EQ(findings[2].second_value, 7U);
    // Given none
    slaves[2][95].safety = nullptr;
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 2U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kOnlyFirst);
}

TEST_F(FlyingCompare, DataOfAProfileOnOneSideOnly)
{
    Verifies(req::SRS_FLY_022);
    const El6751Slave el6751{};
    FlyingFinding finding =
        After([&el6751](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.el6751 = &el6751; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kProfile);
    EXPECT_EQ(finding.sub, 0U);
    EXPECT_EQ(finding.slave.value, 95U);
    EXPECT_EQ(finding.second_value, 1U);
    const PlcSlave plc{};
    finding = After([&plc](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.plc = &plc; });
    EXPECT_EQ(finding.second_value, 2U);
}

TEST_F(FlyingCompare, EachPartOfTheEl6751Data)
{
    Verifies(req::SRS_FLY_022);
    using Slave = El6751Slave;
    const std::vector<std::function<void(Slave&)>> changes{
        [](Slave& s) { s.kind = El6751Kind::kBusCoupler; },
        [](Slave& s) { s.is_device_type_checked = false; },
        [](Slave& s) { s.is_sync_period_written = false; },
        [](Slave& s) { s.is_cob_id_written = false; },
        [](Slave& s) { s.is_type_written = false; },
        [](Slave& s) { s.is_started = false; },
        [](Slave& s) { s.is_restarted_without_pdos = true; },
        [](Slave& s) { s.is_consumer_literal = true; },
        [](Slave& s) { s.node_reaction = El6751NodeReaction::kNone; },
        [](Slave& s) { s.restart = El6751Restart::kByHand; },
        [](Slave& s) { s.network_reaction = El6751NetworkReaction::kStopAll; },
        [](Slave& s) { s.life_time_factor = 3U; },
        [](Slave& s) { s.guard_time_ms = 100U; },
        [](Slave& s) { s.coupler_pdos = 7U; },
        [](Slave& s) { s.coupler_inhibit_100us = 8U; },
        [](Slave& s) { s.coupler_event_ms = 9U; },
        [](Slave& s) { s.rx_count = 1U; },
        [](Slave& s) { s.tx_count = 1U; },
    };
    ASSERT_EQ(changes.size() + 1U, kEl6751Parts);
    const Slave usual{};
    for (std::size_t i = 0U; i < 3U; ++i)
    {
        slaves[i][95].el6751 = &usual;
    }
    for (std::size_t part = 0U; part < changes.size(); ++part)
    {
        Slave other{};
        changes[part](other);
        const FlyingFinding finding =
            After([&other](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.el6751 = &other; });
        EXPECT_EQ(finding.kind, FlyingFindingKind::kProfile) << part;
        EXPECT_EQ(finding.sub, part + 1U);
    }
}

TEST_F(FlyingCompare, EachPartOfAPdoAndOfThePlcData)
{
    Verifies(req::SRS_FLY_022);
    const El6751Pdo pdo{3U, 0x203U, 255U, 8U, 10U, 100U, nullptr};
    const El6751Pdo others[6] = {
        {4U, 0x203U, 255U, 8U, 10U, 100U, nullptr}, {3U, 0x204U, 255U, 8U, 10U, 100U, nullptr},
        {3U, 0x203U, 1U, 8U, 10U, 100U, nullptr},   {3U, 0x203U, 255U, 8U, 11U, 100U, nullptr},
        {3U, 0x203U, 255U, 8U, 10U, 101U, nullptr}, {3U, 0x203U, 255U, 7U, 10U, 100U, nullptr}};
    const std::uint8_t subs[6] = {0U, 1U, 2U, 3U, 5U, 0U};
    El6751Slave usual{};
    usual.rx_pdos = &pdo;
    usual.rx_count = 1U;
    usual.tx_pdos = &pdo;
    usual.tx_count = 1U;
    PlcSlave plc{};
    for (std::size_t i = 0U; i < 3U; ++i)
    {
        slaves[i][95].el6751 = &usual;
        slaves[i][95].plc = &plc;
    }
    for (std::size_t part = 0U; part < 6U; ++part)
    {
        El6751Slave other = usual;
        other.rx_pdos = &others[part];
        const auto change = [&other](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.el6751 = &other; };
        const FlyingFinding rx = After(change);
        EXPECT_EQ(rx.kind, FlyingFindingKind::kPdo);
        EXPECT_EQ(rx.index, (part == 5U) ? 0x1602U : 0x1402U);
        EXPECT_EQ(rx.sub, subs[part]);
        other.rx_pdos = &pdo;
        other.tx_pdos = &others[part];
        EXPECT_EQ(After(change).index, (part == 5U) ? 0x1A02U : 0x1802U);
    }
    PlcSlave optional{};
    optional.is_optional = true;
    EXPECT_EQ(After([&](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.plc = &optional; }).kind,
              FlyingFindingKind::kPlcOptional);
    PlcSlave reset{};
    reset.is_reset = true;
    EXPECT_EQ(After([&](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.plc = &reset; }).kind,
              FlyingFindingKind::kPlcReset);
}

TEST_F(FlyingCompare, SlavesAndMastersThatOneOfThemDoesNotKnow)
{
    Verifies(req::SRS_FLY_022);
    FlyingFinding finding =
        After([](NetworkSetup&, SlaveSetup& slave, FlyingMasterTimes&) { slave.assignment = kBootSlave; });
    EXPECT_EQ(finding.kind, FlyingFindingKind::kMissing);
    EXPECT_EQ(finding.slave.value, 95U);
    EXPECT_EQ(finding.first_value, 1U);
    EXPECT_EQ(finding.second_value, 0U);
    // Given a second master that does not list the third one
    slaves[1][9].assignment = 0U;
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 1U);
    EXPECT_EQ(findings[0].kind, FlyingFindingKind::kUnknown);
    EXPECT_EQ(findings[0].first, 1U);
    EXPECT_EQ(findings[0].second, 2U);
    EXPECT_EQ(findings[0].slave.value, 9U);
}

TEST_F(FlyingCompare, AMasterThatIsNoFlyingMaster)
{
    Verifies(req::SRS_FLY_022);
    for (NetworkSetup& setup : setups)
    {
        setup.start_up = 1U;
    }
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 3U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kNotFlying);
    EXPECT_EQ(findings[1].first, 1U);
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
    EXPECT_EQ(finding.first, 2U);
    // A slot relation that holds for none: one finding a master
    for (FlyingMasterTimes& one : times)
    {
        one.priority_slot = 1270U;
    }
    findings.clear();
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 3U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kSlots);
    EXPECT_EQ(findings[1].first, 1U);
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

TEST_F(FlyingCompare, OneNodeIdTwiceIsToldOfThatNodeOnceAndNothingElse)
{
    Verifies(req::SRS_FLY_022);
    // Given a second master with the node-ID of the first one, and a third one that lists neither
    setups[1].own = NodeId{2U};
    slaves[1][5].assignment = kInNetwork;
    slaves[2][2].assignment = 0U;
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 2U);
    ASSERT_EQ(findings.size(), 2U);
    EXPECT_EQ(findings[0].kind, FlyingFindingKind::kUnknown);
    EXPECT_EQ(findings[0].first, 2U);
    EXPECT_EQ(findings[0].second, 0U);
    EXPECT_EQ(findings[1].kind, FlyingFindingKind::kSameNode);
    EXPECT_EQ(findings[1].first, 1U);
    EXPECT_EQ(findings[1].first_value, 2U);
}

TEST_F(FlyingCompare, ASlaveThatOnlyOneHas)
{
    Verifies(req::SRS_FLY_022);
    for (const std::size_t with : {0U, 2U})
    {
        slaves[0][96].assignment = (with == 0U) ? kInNetwork : 0U;
        slaves[1][96].assignment = slaves[0][96].assignment;
        slaves[2][96].assignment = (with == 0U) ? 0U : kInNetwork;
        findings.clear();
        EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 1U);
        ASSERT_EQ(findings.size(), 1U);
        EXPECT_EQ(findings[0].kind, FlyingFindingKind::kMissing);
        EXPECT_EQ(findings[0].slave.value, 96U);
        EXPECT_EQ(findings[0].first_value, (with == 0U) ? 1U : 0U);
        EXPECT_EQ(findings[0].second_value, (with == 0U) ? 0U : 1U);
    }
}

TEST_F(FlyingCompare, DataOfAProfileThatTheFirstAloneHas)
{
    Verifies(req::SRS_FLY_022);
    const El6751Slave box{};
    const PlcSlave plc{};
    slaves[0][95].el6751 = &box;
    slaves[1][95].el6751 = &box;
    slaves[0][95].plc = &plc;
    slaves[1][95].plc = &plc;
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 1U);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].kind, FlyingFindingKind::kProfile);
    EXPECT_EQ(findings[0].sub, 0U);
    EXPECT_EQ(findings[0].first_value, 3U);
    EXPECT_EQ(findings[0].second_value, 0U);
}

TEST_F(FlyingCompare, FewerPdosAreOneFindingEach)
{
    Verifies(req::SRS_FLY_022);
    const std::array<El6751Pdo, 2> pdos{};
    El6751Slave two{};
    two.rx_pdos = pdos.data();
    two.tx_pdos = pdos.data();
    two.rx_count = 2U;
    two.tx_count = 2U;
    El6751Slave one = two;
    one.rx_count = 1U;
    one.tx_count = 1U;
    slaves[0][95].el6751 = &two;
    slaves[1][95].el6751 = &two;
    slaves[2][95].el6751 = &one;
    EXPECT_EQ(CompareFlyingMasters(views.data(), 3U, *this), 2U);
    ASSERT_EQ(findings.size(), 2U);
    for (const FlyingFinding& finding : findings)
    {
        EXPECT_EQ(finding.kind, FlyingFindingKind::kProfile);
        EXPECT_EQ(finding.first_value, 2U);
        EXPECT_EQ(finding.second_value, 1U);
    }
    EXPECT_EQ(findings[0].sub, 17U); // El6751Part::kRxCount
    EXPECT_EQ(findings[1].sub, 18U);
}

} // namespace
} // namespace counterpoint::cia302
