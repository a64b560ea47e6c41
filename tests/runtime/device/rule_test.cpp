// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// Pairs of one half, rules and their inputs.
#include "runtime/device/pair_logic.hpp"
#include "tests/canopen/cia306/device_text.hpp"
#include "verification/trace/ids/node.hpp"
#include "verification/trace/ids/simulator.hpp"
#include "verification/trace/verifies.hpp"

#include <gtest/gtest.h>

namespace counterpoint::runtime
{
namespace
{
/// The controller: consumer of 2200h:01 and 2200h:02, producer of 2000h:01 and 2000h:02, of 8 bits each.
class Controller : public ::testing::Test
{
  protected:
    [[nodiscard]] static LogicRule Rule(const ObjectAddress& target, const LogicOperation operation,
                                        const std::vector<ObjectAddress>& inputs)
    {
        LogicRule rule;
        rule.target = target;
        rule.operation = operation;
        rule.inputs = inputs;
        return rule;
    }
    /// A value is received by a pair of SRDO 1, whose output is open or not.
    void Receive(PairLogic& logic, const ObjectAddress& normal, const std::uint64_t value)
    {
        const PairValue& pair = *logic.Find(normal);
        WriteVariable(pair.normal_place, VariableValue{value});
        WriteVariable(pair.inverse_place, VariableValue{~value & pair.mask});
    }
    static void Nobody(const PairValue& pair)
    {
        static_cast<void>(pair);
    }

    DeviceModel model_{cia306::test::SourceFolder() + "/examples/emergency_stop/controller.dcf", std::nullopt};
};

TEST_F(Controller, FollowsRules)
{
    Verifies(req::SRS_SIM_006);
    struct Row
    {
        LogicOperation operation;
        std::vector<ObjectAddress> inputs;
        std::uint64_t normal;
        std::uint64_t inverse;
    };
    // Given 5Ah and 33h received
    const ObjectAddress one{0x2200U, 1U};
    const ObjectAddress two{0x2200U, 2U};
    for (const Row& row :
         {Row{LogicOperation::kCopy, {one}, 0x5AU, 0xA5U}, Row{LogicOperation::kNot, {one}, 0xA5U, 0x5AU},
          Row{LogicOperation::kAnd, {one, two}, 0x12U, 0xEDU}, Row{LogicOperation::kOr, {one, two}, 0x7BU, 0x84U}})
    {
        PairLogic logic(model_, Half::kBoth);
        ASSERT_EQ(logic.AddRule(Rule({0x2000U, 1U}, row.operation, row.inputs)), RuleFinding::kNone);
        Receive(logic, one, 0x5AU);
        Receive(logic, two, 0x33U);
        EXPECT_FALSE(logic.TakeChange());
        int told = 0;
        logic.Take(1U, [&told](const PairValue&) { ++told; });
        EXPECT_EQ(told, 2);
        EXPECT_EQ(logic.Find({0x2000U, 1U})->normal, row.normal);
        EXPECT_EQ(logic.Find({0x2000U, 1U})->inverse, row.inverse);
        EXPECT_TRUE(logic.TakeChange());
        // The same again is no change, and nobody is told
        logic.Take(1U, [&told](const PairValue&) { ++told; });
        EXPECT_EQ(told, 2);
        EXPECT_FALSE(logic.TakeChange());
    }
}

TEST_F(Controller, FollowsEachOfSeveralRules)
{
    Verifies(req::SRS_SIM_006);
    PairLogic logic(model_, Half::kBoth);
    ASSERT_EQ(logic.Pairs().size(), 4U);
    ASSERT_EQ(logic.AddRule(Rule({0x2000U, 1U}, LogicOperation::kCopy, {{0x2200U, 1U}})), RuleFinding::kNone);
    ASSERT_EQ(logic.AddRule(Rule({0x2000U, 2U}, LogicOperation::kCopy, {{0x2200U, 1U}})), RuleFinding::kNone);
    Receive(logic, {0x2200U, 1U}, 0x5AU);
    logic.Take(1U, Nobody);
    EXPECT_EQ(logic.Find({0x2000U, 1U})->normal, 0x5AU);
    EXPECT_EQ(logic.Find({0x2000U, 2U})->normal, 0x5AU);
    EXPECT_TRUE(logic.TakeChange());
}

TEST_F(Controller, RefusesRulesThatItCannotFollow)
{
    Verifies(req::SRS_NODE_160);
    PairLogic logic(model_, Half::kBoth);
    const ObjectAddress target{0x2000U, 1U};
    const ObjectAddress input{0x2200U, 1U};
    const ObjectAddress none{0x2999U, 1U};
    EXPECT_EQ(logic.AddRule(Rule(none, LogicOperation::kCopy, {input})), RuleFinding::kNoPair);
    EXPECT_EQ(logic.AddRule(Rule(input, LogicOperation::kCopy, {input})), RuleFinding::kNoPair);
    EXPECT_EQ(logic.AddRule(Rule(target, LogicOperation::kCopy, {none})), RuleFinding::kNoPair);
    // What it sends itself is no input
    EXPECT_EQ(logic.AddRule(Rule(target, LogicOperation::kCopy, {{0x2000U, 2U}})), RuleFinding::kNoPair);
    EXPECT_EQ(logic.AddRule(Rule(target, LogicOperation::kOr, {input, {0x2000U, 2U}})), RuleFinding::kNoPair);
    EXPECT_FALSE(logic.IsComputed(target));
    EXPECT_EQ(logic.AddRule(Rule(target, LogicOperation::kCopy, {input})), RuleFinding::kNone);
    EXPECT_TRUE(logic.IsComputed(target));
    EXPECT_FALSE(logic.IsComputed({0x2000U, 2U}));
    EXPECT_FALSE(logic.IsComputed(none));
    EXPECT_EQ(logic.Find(none), nullptr);
    // An input of 32 bits for a target of 64
    const DeviceModel digest(cia306::test::SourceFolder() + "/tests/canopen/cia306/data/digest.dcf", std::nullopt);
    PairLogic other(digest, Half::kBoth);
    EXPECT_EQ(other.AddRule(Rule({0x2400U, 1U}, LogicOperation::kCopy, {{0x2200U, 1U}})), RuleFinding::kOtherLength);
    EXPECT_EQ(other.AddRule(Rule({0x2400U, 1U}, LogicOperation::kCopy, {none, {0x2200U, 1U}})), RuleFinding::kNoPair);
}

TEST_F(Controller, TakesAnInputOfAProducerOnce)
{
    Verifies(req::SRS_SIM_006);
    PairLogic logic(model_, Half::kBoth);
    logic.SetInput({0x2000U, 1U}, 0x5AU);
    EXPECT_TRUE(logic.TakeChange());
    EXPECT_FALSE(logic.TakeChange());
    logic.SetInput({0x2000U, 1U}, 0x5AU);
    EXPECT_FALSE(logic.TakeChange());
    logic.SetInput({0x2000U, 1U}, 0x5BU);
    logic.SetInput({0x2000U, 1U}, 0x5BU);
    EXPECT_TRUE(logic.TakeChange());
}

TEST_F(Controller, OfTwoCpusHasItsHalfAlone)
{
    Verifies(req::SRS_SIM_006);
    // Given halves, each with its object as it was received, and another one that it has not
    PairLogic normal(model_, Half::kNormal);
    PairLogic inverse(model_, Half::kInverse);
    const PairValue& pair = *normal.Find({0x2200U, 1U});
    WriteVariable(pair.normal_place, VariableValue{0x5AU});
    WriteVariable(pair.inverse_place, VariableValue{0x0FU});
    normal.Take(1U, Nobody);
    inverse.Take(1U, Nobody);
    EXPECT_EQ(normal.Find({0x2200U, 1U})->normal, 0x5AU);
    EXPECT_EQ(inverse.Find({0x2200U, 1U})->normal, 0xF0U);
    // When each writes a producer, then its object alone
    const PairValue& sent = *normal.Find({0x2000U, 1U});
    WriteVariable(sent.normal_place, VariableValue{0U});
    WriteVariable(sent.inverse_place, VariableValue{0U});
    normal.SetInput({0x2000U, 1U}, 0x5AU);
    normal.Write(sent);
    EXPECT_EQ(ReadVariable(sent.normal_place).bits, 0x5AU);
    EXPECT_EQ(ReadVariable(sent.inverse_place).bits, 0U);
    inverse.SetInput({0x2000U, 1U}, 0x33U);
    inverse.Write(*inverse.Find({0x2000U, 1U}));
    EXPECT_EQ(ReadVariable(sent.normal_place).bits, 0x5AU);
    EXPECT_EQ(ReadVariable(sent.inverse_place).bits, 0xCCU);
}
} // namespace
} // namespace counterpoint::runtime
