// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// When each device of a scenario has a supply, by what the scenario does to it. [SRS_SIM_065, SRS_SIM_066, SRS_MGR_157]
#include "simulator/scenario/checks.hpp"
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"

#include "runtime/device/time_text.hpp"

#include <algorithm>

namespace counterpoint::simulator
{
namespace
{
enum class StepKind : std::uint8_t
{
    kUse = 1U, ///< Somebody uses the device.
    kOff = 2U, ///< A power cycle.
    kOn = 3U,
    kAction = 4U,
};

/// Something that happens to one device.
struct Step
{
    Nanoseconds at{0};
    Nanoseconds until{0}; ///< Of a use that lasts, and of a power cycle.
    StepKind kind{StepKind::kUse};
    Source source;
    std::string what;
    ActionKind action{ActionKind::kPull};
};

/// The life of one device through the steps in the order in which the simulation takes them.
class DeviceLife
{
  public:
    DeviceLife(const Scenario& scenario, const NodeIndex node)
        : scenario_(scenario), setup_(scenario.nodes[node]), node_(node)
    {
        AddAll();
        std::stable_sort(steps_.begin(), steps_.end(),
                         [](const Step& left, const Step& right) { return left.at < right.at; });
    }

    /// What nobody hears. Throws YamlError for supply events that do not fit.
    [[nodiscard]] std::vector<Happening> Unheard()
    {
        std::vector<Happening> unheard;
        for (std::size_t place = 0U; place < steps_.size(); ++place)
        {
            const Step& step = steps_[place];
            switch (step.kind)
            {
            case StepKind::kUse:
                if (!HasSupply(step) && !ComesUntil(place))
                {
                    unheard.push_back({step.at, step.source, step.what});
                }
                break;
            case StepKind::kOff:
                TakeOff(step);
                break;
            case StepKind::kOn:
                cycle_ends_ = kNever;
                break;
            case StepKind::kAction:
                TakeAction(step);
                break;
            }
        }
        return unheard;
    }

  private:
    [[nodiscard]] std::string Named(const std::string& what) const
    {
        return what + " of device " + setup_.name;
    }
    [[noreturn]] static void Refuse(const Step& step, const std::string& why, const std::string& expected)
    {
        throw YamlError(step.source.file, step.source.place, step.what + why, expected);
    }
    /// Calls `add` with each item that is of this device.
    template <typename Item, typename Adder> void ForOwn(const std::vector<Item>& items, const Adder& add)
    {
        for (const Item& item : items)
        {
            if (item.node == node_)
            {
                add(item);
            }
        }
    }
    void Use(const Nanoseconds at, const Nanoseconds until, const Source& source, const std::string& what)
    {
        steps_.push_back({at, until, StepKind::kUse, source, Named(what), {}});
    }
    void AddAll()
    {
        ForOwn(scenario_.acknowledges,
               [this](const Acknowledge& item) { Use(item.at, item.at + item.pulse, item.source, "acknowledge"); });
        ForOwn(scenario_.nmt, [this](const NmtEvent& item) { Use(item.at, item.at, item.source, "NMT event"); });
        ForOwn(scenario_.power,
               [this](const PowerCycle& item)
               {
                   const Nanoseconds end = item.at + item.off;
                   steps_.push_back({item.at, end, StepKind::kOff, item.source, Named("power cycle"), {}});
                   steps_.push_back({end, end, StepKind::kOn, item.source, "", {}});
               });
        ForOwn(scenario_.actions,
               [this](const Action& item)
               {
                   const std::string what = Named(NameOf(kActionWords, item.kind));
                   steps_.push_back({item.at, item.at, StepKind::kAction, item.source, what, item.kind});
               });
        ForOwn(scenario_.gfc, [this](const GfcEvent& item) { Use(item.at, item.at, item.source, "GFC"); });
    }
    /// A device comes at the end of its first instant.
    [[nodiscard]] bool HasSupply(const Step& step) const
    {
        return step.at > setup_.phase && is_there_ && cycle_ends_ == kNever;
    }
    /// Whether the supply comes while somebody still presses.
    [[nodiscard]] bool ComesUntil(const std::size_t place) const
    {
        const Step& use = steps_[place];
        return std::any_of(steps_.begin() + static_cast<std::ptrdiff_t>(place), steps_.end(),
                           [&use](const Step& later)
                           {
                               const bool comes =
                                   later.kind == StepKind::kOn ||
                                   (later.kind == StepKind::kAction &&
                                    (later.action == ActionKind::kInsert || later.action == ActionKind::kReplace));
                               return comes && later.at < use.until;
                           }) ||
               (use.at <= setup_.phase && setup_.phase < use.until);
    }
    void TakeOff(const Step& step)
    {
        if (!HasSupply(step))
        {
            Refuse(step, ", which has no supply", "a time at which it has one");
        }
        cycle_ends_ = step.until;
    }
    void TakeAction(const Step& step)
    {
        const bool needs_absence = step.action == ActionKind::kInsert;
        if (step.at < setup_.phase)
        {
            Refuse(step, " before it comes", "a time from its 'phase' on");
        }
        if (cycle_ends_ != kNever)
        {
            Refuse(step, " during its power cycle", "a time from " + runtime::ExactText(cycle_ends_) + " on");
        }
        if (step.action != ActionKind::kReplace && is_there_ == needs_absence)
        {
            Refuse(step, is_there_ ? ", which is there" : ", which is not there",
                   is_there_ ? "a pull before it" : "an insert before it");
        }
        is_there_ = step.action != ActionKind::kPull;
    }

    const Scenario& scenario_;
    const NodeSetup& setup_;
    NodeIndex node_;
    std::vector<Step> steps_;
    bool is_there_{true};
    Nanoseconds cycle_ends_{kNever}; ///< kNever: none is under way.
};
} // namespace

std::vector<Happening> UnheardIn(const Scenario& scenario)
{
    std::vector<Happening> unheard;
    for (NodeIndex node = 0U; node < scenario.nodes.size(); ++node)
    {
        const std::vector<Happening> more = DeviceLife(scenario, node).Unheard();
        unheard.insert(unheard.end(), more.begin(), more.end());
    }
    return unheard;
}

void RequireSupply(const Scenario& scenario)
{
    for (const Happening& unheard : UnheardIn(scenario))
    {
        if (unheard.source.file == scenario.file) // Of the extended scenario: told after the run.
        {
            throw YamlError(unheard.source.file, unheard.source.place,
                            unheard.what + " at " + runtime::ExactText(unheard.at) + ", which has no supply then",
                            "a time at which it has one");
        }
    }
}
} // namespace counterpoint::simulator
