// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "verification/injection/script.hpp"

namespace counterpoint::injection
{
namespace
{

constexpr std::uint32_t kFirstUs = 1000000U;
constexpr std::uint32_t kCycleUs = 1000U;
constexpr std::uint32_t kPreOperational = 0x22U;
constexpr std::uint32_t kOperational = 0xD8U;
constexpr std::uint32_t kProducer = 0x1303U;
constexpr std::uint32_t kSrvtSteps = 3U;
// Pins.
constexpr std::uint32_t kSecond = 2U; // Without the interlock.
constexpr std::uint32_t kBoth = 3U;
// As the image tells them.
constexpr std::uint32_t kSrdoEvent = 0x10000U;
constexpr std::uint32_t kSrvtEvent = 0x1051301U;
constexpr std::uint32_t kSctEvent = 0x1061301U;
constexpr std::uint32_t kNmtEvent = 0x10A1301U;
constexpr std::uint32_t kGfcEvent = 0x30000U;
constexpr std::uint32_t kDemanded = 0x0AU;

void AddFrame(Mailbox& mail, const std::uint32_t identifier, const std::uint32_t length, const std::uint32_t first)
{
    const std::uint32_t stamp = mail.now_us - 600U + (20U * mail.frame_count);
    mail.frames[mail.frame_count] = MailFrame{0U, identifier, length, first, 0U, stamp};
    ++mail.frame_count;
}

void AddWrite(Mailbox& mail, const MailWrite& write)
{
    mail.writes[mail.write_count] = write;
    ++mail.write_count;
}

/// Writes down the steps one after the other.
class Writer
{
  public:
    Mailbox& Next(const std::string& scene)
    {
        Mailbox mail{};
        const auto number = static_cast<std::uint32_t>(steps_.size());
        mail.now_us = kFirstUs + (kCycleUs * number);
        mail.question = 0x1000U + (0x31U * number);
        steps_.push_back(ScriptStep{scene, mail, {}, false});
        return steps_.back().mail;
    }
    void Idle(const std::string& scene, const std::uint32_t count)
    {
        for (std::uint32_t i = 0U; i < count; ++i)
        {
            (void)Next(scene);
        }
    }
    // Each pair has a value of its own.
    void Pairs(Mailbox& mail)
    {
        ++value_;
        AddPair(mail, 0U, 0x11000000U + (0x00010203U * value_));
        AddPair(mail, 1U, 0x22000000U + (0x00030201U * value_));
    }
    // An acknowledge is held for three cycles, and the pairs come behind its edge.
    void Acknowledge(const std::string& scene)
    {
        for (std::uint32_t i = 0U; i < 3U; ++i)
        {
            Mailbox& mail = Next(scene);
            mail.acknowledge_a = 1U;
            mail.acknowledge_b = 1U;
            if (i == 1U)
            {
                Pairs(mail);
            }
        }
    }
    void Traffic(const std::string& scene)
    {
        Pairs(Next(scene));
        (void)Next(scene);
    }
    // Of the step that was written last.
    void Shows(const Shown& shown)
    {
        steps_.back().shown = shown;
    }
    [[nodiscard]] std::vector<ScriptStep> Steps()
    {
        bool is_operational = false;
        for (ScriptStep& step : steps_)
        {
            is_operational = (step.mail.nmt == 0U) ? is_operational : (step.mail.nmt == kOperational);
            step.is_operational = is_operational;
        }
        return steps_;
    }

  private:
    std::vector<ScriptStep> steps_{};
    std::uint32_t value_{0U};
};

void Start(Writer& writer)
{
    // The first one: Start, and the configuration up to its signature.
    writer.Idle("set up", 1U);
    writer.Idle("start", 2U);
    writer.Next("start").nmt = kOperational;
    writer.Shows({0U});
    writer.Idle("start", 1U);
    // What may not be open stays so for longer than the judge gives an output to close.
    writer.Traffic("pair without acknowledge");
    writer.Traffic("pair without acknowledge");
    writer.Shows({kSecond});
    writer.Acknowledge("acknowledge");
    writer.Shows({kBoth});
}

void Exchange(Writer& writer)
{
    writer.Traffic("pair");
    writer.Shows({kBoth});
    Mailbox& send = writer.Next("send");
    send.send_index = kProducer;
    send.sent_value = 0xCAFE0123U;
    writer.Shows({kBoth, 0U, 1U});
    writer.Pairs(writer.Next("confirm"));
    writer.Shows({kBoth, 0U, 1U});
    (void)writer.Next("confirm");
    writer.Shows({kBoth, kSrdoEvent + kProducer});
    writer.Traffic("pair");
    writer.Traffic("diagnosis");
    writer.Shows({kBoth});
}

void StopByGfc(Writer& writer)
{
    AddFrame(writer.Next("GFC"), 0x001U, 0U, 0U);
    writer.Shows({0U, kGfcEvent});
    writer.Traffic("GFC");
    writer.Traffic("GFC");
    writer.Shows({kSecond});
    writer.Acknowledge("GFC, acknowledge");
    writer.Shows({kBoth});
}

// Both times end; then one frame of a pair alone.
void Expire(Writer& writer)
{
    writer.Idle("SCT expiry", kSctSteps - 1U);
    writer.Shows({0U, kSctEvent});
    writer.Idle("SCT expiry", 2U);
    writer.Traffic("SCT expiry, pair without acknowledge");
    writer.Shows({kSecond});
    writer.Acknowledge("SCT expiry, acknowledge");
    writer.Shows({kBoth});
    Mailbox& alone = writer.Next("SRVT expiry");
    AddFrame(alone, 0x101U, 4U, 0x11AA55AAU);
    AddPair(alone, 1U, 0x22AA55AAU);
    writer.Idle("SRVT expiry", kSrvtSteps);
    writer.Shows({kSecond, kSrvtEvent});
    (void)writer.Next("SRVT expiry");
    writer.Traffic("SRVT expiry, pair without acknowledge");
    writer.Shows({kSecond});
    writer.Acknowledge("SRVT expiry, acknowledge");
    writer.Shows({kBoth});
}

void Leave(Writer& writer)
{
    writer.Next("GFC sent").is_gfc_sent = 1U;
    writer.Shows({kBoth, 0U, 1U});
    writer.Traffic("GFC sent");
    writer.Next("NMT leave").nmt = kPreOperational;
    writer.Shows({0U, kNmtEvent});
    // Longer than the judge gives an output to close.
    writer.Traffic("NMT leave");
    writer.Traffic("NMT leave");
    writer.Traffic("NMT leave");
    writer.Shows({0U});
}

void Reconfigure(Writer& writer)
{
    Mailbox& off = writer.Next("reconfiguration");
    AddWrite(off, {0x1302U, 1U, 0U, 1U});
    AddWrite(off, {0x1302U, 2U, kSctSteps + 1U, 2U});
    AddWrite(off, {0x1302U, 1U, 2U, 1U});
    off.is_signed = 1U;
    writer.Next("reconfiguration").is_checked = 1U;
    writer.Next("reconfiguration").nmt = kOperational;
    writer.Acknowledge("reconfiguration");
    writer.Shows({kBoth});
}

} // namespace

void AddPair(Mailbox& mail, const std::uint32_t slot, const std::uint32_t value)
{
    AddFrame(mail, 0x101U + (2U * slot), 4U, value);
    AddFrame(mail, 0x102U + (2U * slot), 4U, ~value);
}

std::vector<ScriptStep> MakeScript()
{
    Writer writer{};
    Start(writer);
    Exchange(writer);
    StopByGfc(writer);
    Expire(writer);
    Leave(writer);
    Reconfigure(writer);
    writer.Traffic("after reconfiguration");
    writer.Shows({kBoth});
    writer.Next("level 2").is_demanded = 1U;
    writer.Shows({0U, 0U, 0U, kDemanded});
    writer.Traffic("level 2");
    writer.Acknowledge("level 2");
    writer.Idle("level 2", 2U);
    writer.Idle("end", kTailSteps);
    writer.Shows({0U});
    return writer.Steps();
}

} // namespace counterpoint::injection
