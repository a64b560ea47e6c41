// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// 5500h of a BK51x0: from which file it comes, and that it is written once.
#include "canopen/cia302/network/concise_dcf.hpp"
#include "tests/canopen/network_plan/plan_rig.hpp"
#include "verification/trace/ids/start_up_profiles.hpp"

namespace counterpoint::network_plan
{
namespace
{
using test::Entry;
using test::Number;
using test::PlanTest;
using test::Record;
using Texts = std::vector<std::string>;

const std::string kCouplerHead = "[DeviceInfo]\nVendorName=test\n\n";
const std::string kCouplerFilter = Entry("2000", 5, "rw", "ParameterValue=7");

class CouplerTest : public PlanTest
{
  protected:
    [[nodiscard]] NetworkPlan Coupler(const std::string& dcf, const std::optional<std::uint32_t> pdos) const
    {
        NetworkPlan plan = PlanOf(kCouplerHead + dcf);
        plan.manager.profile = StartProfile::kEl6751;
        plan.slaves[0].el6751 = cia302::El6751Slave{};
        plan.slaves[0].el6751->kind = cia302::El6751Kind::kBusCoupler;
        plan.slaves[0].coupler_pdos = pdos;
        return plan;
    }
    /// Value of the row, and behind it "5500:00" for each further SDO.
    [[nodiscard]] static Texts WrittenTo(const NetworkPlan& plan)
    {
        const LoadedNetwork network(plan);
        const cia302::SlaveSetup& setup = network.Setup().slaves[5];
        Texts written{cia306::Hex(setup.el6751->coupler_pdos, 8)};
        cia302::ConciseReading entry = cia302::ReadConcise(setup.concise_dcf, {0U, 0U});
        for (; entry.state == cia302::ConciseState::kEntry; entry = cia302::ReadConcise(setup.concise_dcf, entry.next))
        {
            written.push_back(cia306::Hex(entry.object.index, 4).substr(2U) + ":" +
                              cia306::Hex(entry.object.sub, 2).substr(2U));
        }
        return written;
    }
};

// Given a value in the DCF, then no further SDO writes it over that of the network file.
TEST_F(CouplerTest, HasTheValueOfTheNetworkFile)
{
    Verifies(req::SRS_ELM_585);
    Verifies(req::SRS_ELM_212);
    const std::string dcf = Number("5500", "0x00000001") + kCouplerFilter;
    EXPECT_EQ(WrittenTo(Coupler(dcf, 0x03020100U)), (Texts{"0x03020100", "2000:00"}));
    EXPECT_EQ(WrittenTo(Coupler(dcf, 0U)), (Texts{"0x00000000", "2000:00"}));
}

TEST_F(CouplerTest, HasElseThatOfItsDcf)
{
    Verifies(req::SRS_ELM_585);
    EXPECT_EQ(WrittenTo(Coupler(Number("5500", "0x00000201") + kCouplerFilter, std::nullopt)),
              (Texts{"0x00000201", "2000:00"}));
    EXPECT_EQ(WrittenTo(Coupler(Entry("5500", 7, "rw", "DefaultValue=0x00000201") + kCouplerFilter, std::nullopt)),
              (Texts{"0x00000201", "2000:00"}));
    EXPECT_EQ(WrittenTo(Coupler(kCouplerFilter, std::nullopt)), (Texts{"0x00000000", "2000:00"}));
}

// A record there has nothing of the row but its sub-index 0.
TEST_F(CouplerTest, IsWrittenWhatNoRowWrites)
{
    Verifies(req::SRS_ELM_585);
    const std::string record = Record("5500", 2) + Number("5500sub0", "1") + Number("5500sub1", "0x00000201");
    EXPECT_EQ(WrittenTo(Coupler(record, 7U)), (Texts{"0x00000007", "5500:01"}));
}

// Of another device 5500h is an object as any other, whatever the options of a coupler say.
TEST_F(CouplerTest, IsNoOtherDevice)
{
    Verifies(req::SRS_ELM_585);
    NetworkPlan plan = Coupler(Number("5500", "0x00000201"), std::nullopt);
    plan.slaves[0].el6751->kind = cia302::El6751Kind::kGeneral;
    EXPECT_EQ(WrittenTo(plan), (Texts{"0x00000000", "5500:00"}));
    plan.slaves[0].coupler_pdos = 7U;
    EXPECT_EQ(WrittenTo(plan), (Texts{"0x00000007", "5500:00"}));
    const Texts told{"net.yaml:2:1: warning: node 5 is no bus coupler: coupler_pdos, coupler_inhibit and coupler_event "
                     "have no effect, expected kind: bk51x0, or none of them"};
    EXPECT_EQ(WarningsOf(plan), told);
    plan.slaves[0].el6751.reset();
    EXPECT_EQ(WarningsOf(plan), told);
}

TEST_F(CouplerTest, IsToldWithTwoValues)
{
    Verifies(req::SRS_ELM_586);
    const std::string dcf = Number("5500", "0x00000201");
    NetworkPlan plan = Coupler(dcf, 0x03020100U);
    EXPECT_EQ(WarningsOf(plan), Texts{"net.yaml:2:1: warning: 0x5500:00 of node 5 is 0x201 in its DCF: 0x3020100 of "
                                      "coupler_pdos is written, expected one of the two"});
    plan.manager.profile = StartProfile::kPlcDesigner;
    plan.manager.is_profile_chosen = true;
    EXPECT_EQ(WarningsOf(plan), Texts{});
    // One value, in one file or in both, or a default that nobody asks to be written
    EXPECT_EQ(WarningsOf(Coupler(dcf, 0x201U)), Texts{});
    EXPECT_EQ(WarningsOf(Coupler(dcf, std::nullopt)), Texts{});
    EXPECT_EQ(WarningsOf(Coupler(kCouplerFilter, 7U)), Texts{});
    EXPECT_EQ(WarningsOf(Coupler(Entry("5500", 7, "rw", "DefaultValue=3"), 7U)), Texts{});
}
} // namespace
} // namespace counterpoint::network_plan
