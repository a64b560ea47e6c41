// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// What the faults of devices, managers and configurations do in a network, step by step.
#include "verification/campaign/judged_network.hpp"

#include "verification/campaign/managed/space.hpp"

#include <string>
#include <vector>

namespace counterpoint::campaign::test
{
namespace
{
class NetworkFaultsTest : public JudgedNetworkTest
{
  protected:
    /// The time line of a fault of this kind at 283.650 ms, when nobody sends: of node 2, of manager 127, of 1301h:05
    /// of node 33.
    [[nodiscard]] std::string ToldOf(const std::string& part, const std::string& kind) const
    {
        const tools::test::Answer answer =
            Campaign({NetworkPlan("plan.yaml", "from: 283500 us\nuntil: 283700 us\nsample: 2\nparts: [" + part +
                                                   "]\nkinds: [" + kind + "]\n"),
                      "--replay", "1"});
        EXPECT_EQ(answer.status, 0) << answer.err;
        return answer.out;
    }
    static void ExpectLines(const std::string& told, const std::vector<std::string>& lines)
    {
        for (const std::string& line : lines)
        {
            EXPECT_NE(told.find(line), std::string::npos) << line << "\n" << told;
        }
    }
};

TEST_F(NetworkFaultsTest, DeviceIsSilentForGoodOrAnotherOneWithItsNodeId)
{
    Verifies(req::SRS_CMG_157);
    const std::string pulled = ToldOf("slaves", "pulled");
    ExpectLines(pulled, {"    283.650 ms  FAULT: slaves pulled node 2 at 283.650 ms\n",
                         "told by error_control: manager 127: heartbeat lost\n"});
    EXPECT_EQ(pulled.find("node 2 sends"), std::string::npos) << pulled;
    // Another serial number than 2, which the manager reads behind the boot-up message
    ExpectLines(ToldOf("slaves", "exchanged"), {"    283.650 ms  FAULT: slaves exchanged node 2 at 283.650 ms\n",
                                                "  node 2 sends 702#00  ", "  node 2 sends 582#4318100402005A5A  ",
                                                "serial number differs (0x1018:04 is 0x5A5A0002, expected 0x2)\n"});
}

TEST_F(NetworkFaultsTest, ManagerEndsOrReturnsOrHasNoController)
{
    Verifies(req::SRS_CMG_158);
    const std::string killed = ToldOf("managers", "killed");
    ExpectLines(killed, {"    283.650 ms  FAULT: managers killed manager 127 at 283.650 ms\n",
                         "\noutcome: safe_other, less runs than without the fault, and nobody tells it\n"});
    EXPECT_EQ(killed.find("manager 127 sends"), std::string::npos) << killed;
    ExpectLines(ToldOf("managers", "back"),
                {"    283.650 ms  FAULT: managers back manager 127 at 283.650 ms, for 128.000 ms\n",
                 "    411.650 ms  told by command: manager 127: NMT reset-comm all\n",
                 "  manager 127 sends 000#8200  "});
    ExpectLines(ToldOf("managers", "off_bus"),
                {"    283.650 ms  FAULT: managers off_bus manager 127 at 283.650 ms, for 128.000 ms\n",
                 "    283.650 ms  told by controller: manager 127: bus down\n",
                 "    411.650 ms  told by controller: manager 127: bus active\n"});
    // For 1, 2, 4 and so on to 2048 ms
    managed::Trial trial{};
    EXPECT_EQ(managed::Space::AwayOf(trial), 1'000'000);
    trial.variant = 7U;
    EXPECT_EQ(managed::Space::AwayOf(trial), 128'000'000);
    trial.variant = 11U;
    EXPECT_EQ(managed::Space::AwayOf(trial), 2'048'000'000);
}

TEST_F(NetworkFaultsTest, ConfigurationIsWrittenBySomebodyElse)
{
    Verifies(req::SRS_CMG_156);
    // Given bit 17 of COB-ID 1, 103h, of the relay, which is OPERATIONAL: it answers with an abort, not in this state
    ExpectLines(ToldOf("writes", "foreign"),
                {"    283.650 ms  FAULT: writes foreign node 33 0x1301:05 at 283.650 ms, bit 17\n",
                 "  node 33 sends 5A1#8001130522000008  (not then without the fault)\n"});
}

TEST_F(NetworkFaultsTest, WhoTellsOfAFaultIsNamedAndWhoDidSoFirst)
{
    Verifies(req::SRS_CMG_074);
    // Given a device without supply: its consumers, the manager's error control and its start-up tell
    ExpectLines(ToldOf("slaves", "pulled"),
                {"  told by device: device 2: SRDO 1: sct\n", "  told by emergency: manager 127: emergency 0x8250, ",
                 "  told by error_control: manager 127: heartbeat lost\n",
                 "  told by command: manager 127: NMT reset\n",
                 "  told by status: manager 127: asked again each second (0x1000:00: 0x05040000 (no answer))\n",
                 "\noutcome: detected, told by device, after 48.160 ms\n"});
    ExpectLines(ToldOf("slaves", "exchanged"), {"\noutcome: detected, told by boot_up, after 0.118 ms\n"});
    ExpectLines(ToldOf("managers", "off_bus"), {"\noutcome: detected, told by controller, after 0.000 ms\n"});
    // Bit 7 of a signature at 21.800 ms, before the manager verifies it
    const tools::test::Answer gate =
        Campaign({NetworkPlan("gate.yaml", "from: 20 ms\nuntil: 25 ms\nsample: 20\nparts: [writes]\nkinds: [stored]\n"),
                  "--replay", "14"});
    ExpectLines(gate.out, {"FAULT: writes stored node 2 0x13FF:02 at 21.800 ms, bit 7\n",
                           "\noutcome: detected, told by safety_gate, after 30.200 ms\n"});
    // A manager that ends, whose place another one takes
    const tools::test::Answer election =
        Campaign({NetworkPlan("election.yaml",
                              "from: 2500 ms\nuntil: 2500100 us\nsample: 4\nparts: [managers]\nkinds: [killed]\n",
                              "flying.yaml"),
                  "--replay", "0"});
    ExpectLines(election.out, {"  told by error_control: manager 121: heartbeat lost\n",
                               "  told by election: manager 121: flying master: master mode (priority 1, node 121)\n",
                               "\noutcome: detected, told by error_control, after 214.000 ms\n"});
}
} // namespace
} // namespace counterpoint::campaign::test
