// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_JUDGED_NETWORK_HPP
#define VERIFICATION_CAMPAIGN_JUDGED_NETWORK_HPP

#include "verification/campaign/campaign_rig.hpp"

#include "verification/campaign/managed/stage.hpp"
#include "verification/campaign/managed/watch.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

namespace counterpoint::campaign::test
{
class JudgedNetworkTest : public CampaignTest
{
  protected:
    /// A plan for a network of the examples, with more lines.
    [[nodiscard]] std::string NetworkPlan(const std::string& name, const std::string& more,
                                          const std::string& network = "managed.yaml") const
    {
        return File(name, "title: A test\nnetwork: " COUNTERPOINT_SOURCE_FOLDER "/examples/campaigns/" + network +
                              "\n" + more);
    }
};

/// The network of the examples with its judge, and frames of its manager that nobody sent.
class JudgedNetwork
{
  public:
    explicit JudgedNetwork(const managed::Plan& plan) : stage(plan), watch(stage, plan)
    {
    }
    void RunTo(const std::int64_t ms)
    {
        for (; now_ms < ms; ++now_ms)
        {
            stage.World().RunUntil((now_ms + 1) * 1'000'000);
            watch.Look((now_ms + 1) * 1'000'000);
        }
    }
    void Commands(const std::uint8_t command, const std::uint8_t node)
    {
        const CanFrame frame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {command, node}};
        Sends(frame, stage.Managers().front()->BusNode());
    }
    void Sends(const CanFrame& frame, const host::NodeIndex sender)
    {
        host::ReceptionList nobody;
        watch.OnConfirmation({frame, sender, stage.World().Now(), 1U}, nobody);
    }
    /// Somebody else makes the relay PRE-OPERATIONAL, and changes its safeguard cycle time.
    void Change()
    {
        stage.Somebody().Send(CanFrame{0U, FrameKind::kData, CanPortId::kFirst, 2U, {0x80U, 33U}});
        RunTo(now_ms + 3);
        stage.World().At(Relay().index).Firmware().Store({0x1301U, 2U}, 77U);
    }
    [[nodiscard]] const managed::Slave& Relay() const
    {
        return *std::find_if(stage.Slaves().begin(), stage.Slaves().end(),
                             [](const managed::Slave& slave) { return slave.node_id == 33U; });
    }

    managed::Stage stage;
    managed::Watch watch;
    std::int64_t now_ms{0};
};

/// A manager that hears nothing from some instant on.
class Deaf final : public host::BusFault
{
  public:
    explicit Deaf(const host::NodeIndex who) : who_(who)
    {
    }
    void OnReception(const host::FrameOnBus& /*sent*/, const host::NodeIndex receiver,
                     host::ReceptionList& receptions) override
    {
        if (receiver == who_)
        {
            receptions.Clear();
        }
    }

  private:
    host::NodeIndex who_;
};
} // namespace counterpoint::campaign::test

#endif // VERIFICATION_CAMPAIGN_JUDGED_NETWORK_HPP
