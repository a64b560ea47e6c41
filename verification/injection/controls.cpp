// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/controls.hpp"

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kForged = 0x0BADF00DU;

std::uint32_t StepOf(const std::vector<ScriptStep>& script, const std::string& scene)
{
    std::uint32_t step = 0U;
    while ((step < script.size()) && (script[step].scene != scene))
    {
        ++step;
    }
    return step;
}

Planted ByMail(const std::function<void(Mailbox&, std::uint32_t)>& mail)
{
    Planted planted{};
    planted.mail = mail;
    return planted;
}

Planted BySight(const std::function<void(Seen&, std::uint32_t)>& seen)
{
    Planted planted{};
    planted.seen = seen;
    return planted;
}

// Values of consumer 1, again and again.
Planted ByObjects(const ObjectPair& values)
{
    Planted planted{};
    planted.memory = [values](Machine& machine, std::uint32_t) { machine.Memory().WriteObjects(0U, values); };
    return planted;
}

void Forge(Mailbox& mail, const std::uint32_t step)
{
    if (step == 0U)
    {
        mail.frame_count = 0U;
        AddPair(mail, 0U, kForged);
    }
}

void Acknowledge(Mailbox& mail, const std::uint32_t step)
{
    mail.acknowledge_a |= (step < 3U) ? 1U : 0U;
    mail.acknowledge_b |= (step < 3U) ? 1U : 0U;
}

} // namespace

std::vector<Control> RunControls(Campaign& campaign, const Space& space, const std::vector<ScriptStep>& script)
{
    const std::uint32_t pair = StepOf(script, "pair");
    const std::uint32_t gfc = StepOf(script, "GFC");
    const std::uint32_t expiry = StepOf(script, "SCT expiry");
    const std::uint32_t expired = StepOf(script, "SCT expiry, pair without acknowledge") - 1U;
    const std::uint32_t leave = StepOf(script, "NMT leave");
    const std::uint32_t send = StepOf(script, "send");
    std::vector<Control> all;
    const auto add = [&](const std::string& name, const std::uint32_t step, const Planted& planted,
                         const Class expected, const std::string& what)
    { all.push_back({name, expected, what, campaign.RunControl(step, planted)}); };

    add("forged pair", pair, ByMail(&Forge), Class::kSilent, "wrong data released");
    add("both variables changed", pair, ByObjects({kForged, ~kForged}), Class::kSilent, "wrong data released");
    add("pairs that nobody sent keep an output open", expiry + 2U,
        ByMail(
            [&script, pair](Mailbox& mail, std::uint32_t)
            {
                mail.frame_count = 0U;
                const MailFrame& normal = script[pair].mail.frames[0];
                AddPair(mail, 0U, normal.first);
            }),
        Class::kSilent, "output open without leave");
    add("foreign acknowledge", expired, ByMail(&Acknowledge), Class::kSilent, "restart without acknowledge");
    add("NMT command that is not handed over", leave, ByMail([](Mailbox& mail, std::uint32_t) { mail.nmt = 0U; }),
        Class::kSilent, "NMT command missed");
    add("frame under a foreign identifier", pair,
        BySight([](Seen& seen, std::uint32_t) { seen.sent.push_back({0x107U, 4U, 0U, 0U}); }), Class::kSilent,
        "frame under a foreign identifier");
    add("another value is sent", send,
        ByMail([](Mailbox& mail, const std::uint32_t step) { mail.sent_value = (step == 0U) ? kForged : 0U; }),
        Class::kSilent, "wrong pair sent");
    add("one variable changed", pair,
        BySight([](Seen& seen, const std::uint32_t step) { seen.objects[0].normal ^= (step == 0U) ? 1U : 0U; }),
        Class::kPairCheck, "");
    all.push_back({"GFC that is not handed over", Class::kLostFrame, "GFC",
                   campaign.Run(space.SkippedCall(gfc, "_ZN12counterpoint6Kernel7OnFrameERKNS_12StampedFrameE"))});
    add("watchdog not answered", pair, BySight([](Seen& seen, std::uint32_t) { seen.is_answered = false; }),
        Class::kDetected, "watchdog");
    add("exception", pair, BySight([](Seen& seen, std::uint32_t) { seen.end = StepEnd::kException; }), Class::kCrash,
        "exception");
    add("nothing", pair, Planted{}, Class::kLatent, "");
    return all;
}

} // namespace counterpoint::injection
