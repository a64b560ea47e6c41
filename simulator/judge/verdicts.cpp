// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/judge/verdicts.hpp"

#include "simulator/scenario/names.hpp"

#include <algorithm>
#include <cstdlib>

namespace counterpoint::simulator
{
namespace
{

// Whether the fault is one of a device, and another device is judged, which is told of it by the bus alone.
bool IsElsewhere(const Scenario& scenario, const Expectation& expectation, const FaultClass row)
{
    const bool is_of_device = row == FaultClass::kChannel || row == FaultClass::kConfiguration ||
                              row == FaultClass::kSharedSource || row == FaultClass::kSupervisor ||
                              row == FaultClass::kClock || row == FaultClass::kCrossLink;
    const NodeIndex place = scenario.faults[expectation.fault].node;
    return is_of_device && place < scenario.nodes.size() &&
           scenario.nodes[place].device != scenario.nodes[expectation.node].device;
}

// The row of the table of limits: of the expectation, or of its fault. The self tests read within the diagnostic
// interval what both channels read from one place. With a channel a CPU a copy is all that its kernel reads.
FaultClass LimitClassOf(const Scenario& scenario, const Expectation& expectation)
{
    const FaultSetup& fault = scenario.faults[expectation.fault];
    const FaultClass row = (expectation.fault_class == FaultClass::kInvalid) ? ClassOf(fault) : expectation.fault_class;
    if (expectation.fault_class == FaultClass::kInvalid && IsElsewhere(scenario, expectation, row))
    {
        return FaultClass::kBus;
    }
    if (expectation.fault_class != FaultClass::kInvalid || fault.kind != FaultKind(NodeFault::kBitFlip))
    {
        return row;
    }
    const NodeSetup& node = scenario.nodes[fault.node];
    const bool is_whole = node.role == runtime::CpuRole::kWhole;
    if (row == FaultClass::kSharedSource)
    {
        return node.self_tests ? FaultClass::kConfiguration : row;
    }
    return is_whole ? row : FaultClass::kSharedSource;
}

Nanoseconds TimeOf(const Limit& limit)
{
    return (limit.result == Result::kSuccessful) ? Nanoseconds{limit.us} * kNanosecondsPerMicrosecond : kNoLimit;
}

/// Whether the node is meant: of a device with two CPUs each of them.
bool IsMeant(const Expectation& expectation, const NodeIndex node)
{
    return node == expectation.node || (expectation.is_series && node == expectation.node + 1U);
}

const Event* ClosedAfter(const Journal& journal, const Expectation& expectation, const Nanoseconds from)
{
    const auto found = std::find_if(journal.Events().begin(), journal.Events().end(),
                                    [&expectation, from](const Event& event)
                                    {
                                        return event.kind == EventKind::kOutput && IsMeant(expectation, event.node) &&
                                               event.srdo == expectation.srdo && event.value == 0U && event.at >= from;
                                    });
    return (found == journal.Events().end()) ? nullptr : &*found;
}

/// Answers questions about a finished run.
class Judgement
{
  public:
    Judgement(const Scenario& scenario, const Journal& journal, Network& network)
        : scenario_(scenario), journal_(journal), network_(network)
    {
    }

    [[nodiscard]] ExpectationVerdict Of(const Expectation& expectation)
    {
        switch (expectation.kind)
        {
        case ExpectationKind::kReleased:
        case ExpectationKind::kSafe:
            return OfOutput(expectation);
        case ExpectationKind::kValue:
            return OfValue(expectation);
        case ExpectationKind::kCause:
            return OfCause(expectation);
        case ExpectationKind::kDeviceFault:
            return OfDeviceFault(expectation);
        case ExpectationKind::kDetectedBy:
            return OfDetection(expectation);
        case ExpectationKind::kSafeWithin:
            return OfLimit(expectation);
        case ExpectationKind::kNoFault:
            return OfNoFault(expectation);
        default:
            return {};
        }
    }

    /// What was asked at its time.
    [[nodiscard]] ExpectationVerdict OfFound(const Expectation& expectation, const std::string& found) const
    {
        const bool is_absence = expectation.kind == ExpectationKind::kNoEvent;
        return {0U, (found == expectation.is) != is_absence, WantedOf(expectation), found, {}};
    }

  private:
    /// Whom a manager is asked about: by its name, if the scenario has it.
    [[nodiscard]] std::string NameOfAsked(const std::uint8_t node_id) const
    {
        for (const NodeSetup& node : scenario_.nodes)
        {
            if (node.node_id == node_id)
            {
                return node.name;
            }
        }
        return std::to_string(node_id);
    }

    [[nodiscard]] std::string WantedOf(const Expectation& expectation) const
    {
        const std::string kind = NameOf(kExpectationWords, expectation.kind);
        const bool is_of_manager = IsOfManager(expectation.kind);
        const std::string node =
            is_of_manager ? ((expectation.node_id == 0U) ? "" : " of node " + NameOfAsked(expectation.node_id))
                          : " of node " + NameOfNode(expectation.node);
        const std::string srdo =
            (expectation.kind == ExpectationKind::kOutput) ? " SRDO " + std::to_string(expectation.srdo) : "";
        const std::string at = MillisecondsText(expectation.at);
        const std::string manager =
            (expectation.manager == 0U) ? "" : ", manager " + std::to_string(expectation.manager);
        if (IsOfEvents(expectation.kind))
        {
            return ((expectation.kind == ExpectationKind::kEvent) ? "event " : "no event ") + expectation.is + node +
                   " from " + MillisecondsText(expectation.from) + " to " + at + manager;
        }
        return kind + node + srdo + " is " + expectation.is + " at " + at + manager;
    }

    [[nodiscard]] const std::string& NameOfNode(const NodeIndex node) const
    {
        return scenario_.nodes[node].name;
    }

    [[nodiscard]] const std::string& NameOfPlace(const Expectation& expectation) const
    {
        const NodeSetup& setup = scenario_.nodes[expectation.node];
        return expectation.is_series ? setup.device : setup.name;
    }

    [[nodiscard]] std::string Place(const Expectation& expectation) const
    {
        return NameOfPlace(expectation) + " SRDO " + std::to_string(expectation.srdo);
    }

    [[nodiscard]] bool IsOpen(const NodeIndex node, const std::uint8_t srdo, const Nanoseconds at) const
    {
        bool is_open = false;
        for (const Event& event : journal_.Events())
        {
            const bool is_this = event.kind == EventKind::kOutput && event.node == node && event.srdo == srdo;
            is_open = (is_this && event.at <= at) ? event.value != 0U : is_open;
        }
        return is_open;
    }

    /// Two outputs in series are open while both are.
    [[nodiscard]] bool IsOpen(const Expectation& expectation, const std::uint8_t srdo, const Nanoseconds at) const
    {
        return IsOpen(expectation.node, srdo, at) &&
               (!expectation.is_series || IsOpen(expectation.node + 1U, srdo, at));
    }

    [[nodiscard]] ExpectationVerdict OfOutput(const Expectation& expectation) const
    {
        const bool is_open = IsOpen(expectation, expectation.srdo, expectation.at);
        const bool wants_open = expectation.kind == ExpectationKind::kReleased;
        return {0U,
                is_open == wants_open,
                Place(expectation) + (wants_open ? " released" : " safe") + " at " + MillisecondsText(expectation.at),
                is_open ? "released" : "safe",
                {}};
    }

    /// What the application of that node used last.
    [[nodiscard]] std::uint64_t UsedAt(const NodeIndex node, const Expectation& expectation,
                                       const std::uint64_t safe) const
    {
        const std::uint64_t object = (std::uint64_t{expectation.object.index} << 8U) | expectation.object.sub;
        std::uint64_t value = safe;
        for (const Event& event : journal_.Events())
        {
            const bool is_this = event.kind == EventKind::kValue && event.node == node && event.other == object;
            value = (is_this && event.at <= expectation.at) ? event.value : value;
        }
        return value;
    }

    [[nodiscard]] ExpectationVerdict OfValue(const Expectation& expectation)
    {
        const Node& node = network_.At(expectation.node);
        const runtime::VariablePair* const pair = node.Model().PairOf(expectation.object);
        const std::uint64_t safe = network_.At(expectation.node).App().SafeValueOf(expectation.object);
        // Behind a closed output no value counts, whatever the application last saw.
        const bool is_open = IsOpen(expectation, pair->srdo, expectation.at);
        const std::uint64_t value = is_open ? UsedAt(expectation.node, expectation, safe) : safe;
        const bool is_same =
            !is_open || !expectation.is_series || UsedAt(expectation.node + 1U, expectation, safe) == value;
        return {0U,
                is_same && value == expectation.value,
                NameOfPlace(expectation) + " " + ObjectText(expectation.object) + " is " +
                    std::to_string(expectation.value) + " at " + MillisecondsText(expectation.at),
                std::to_string(value) + (is_same ? "" : ", and another one on the second CPU"),
                {}};
    }

    [[nodiscard]] ExpectationVerdict OfCause(const Expectation& expectation) const
    {
        std::vector<SrdoCause> causes; // Each once, as they came.
        std::string seen;
        for (const Event& event : journal_.Events())
        {
            const bool is_this =
                event.kind == EventKind::kSignal && IsMeant(expectation, event.node) && event.srdo == expectation.srdo;
            const auto cause = static_cast<SrdoCause>(event.value);
            if (is_this && std::find(causes.begin(), causes.end(), cause) == causes.end())
            {
                causes.push_back(cause);
                seen += (seen.empty() ? "" : ", ") + std::string(Name(cause));
            }
        }
        const bool is_there = std::find(causes.begin(), causes.end(), expectation.cause) != causes.end();
        return {0U,
                (expectation.cause == SrdoCause::kNone) ? seen.empty() : is_there,
                Place(expectation) + " cause " + Name(expectation.cause),
                seen.empty() ? "none" : seen,
                {}};
    }

    [[nodiscard]] ExpectationVerdict OfDeviceFault(const Expectation& expectation) const
    {
        DeviceFault fault = DeviceFault::kNone;
        for (const Event& event : journal_.Events())
        {
            const bool is_this = event.kind == EventKind::kDeviceFault && IsMeant(expectation, event.node);
            fault = (is_this && fault == DeviceFault::kNone) ? static_cast<DeviceFault>(event.value) : fault;
        }
        return {0U,
                fault == expectation.device_fault,
                NameOfPlace(expectation) + " device fault " + Name(expectation.device_fault),
                Name(fault),
                {}};
    }

    [[nodiscard]] Detection FirstDetection(const Expectation& expectation, const Nanoseconds from) const
    {
        const Detection one = DetectionAt(journal_, expectation.node, from);
        const Detection other =
            expectation.is_series ? DetectionAt(journal_, expectation.node + 1U, from) : Detection{};
        const bool is_other = other.at >= 0 && (one.at < 0 || other.at < one.at);
        return is_other ? other : one;
    }

    [[nodiscard]] ExpectationVerdict OfDetection(const Expectation& expectation) const
    {
        const Nanoseconds effect = journal_.EffectOf(expectation.fault);
        const Detection detection = (effect < 0) ? Detection{} : FirstDetection(expectation, effect);
        ExpectationVerdict verdict;
        verdict.wanted = "detected at " + NameOfPlace(expectation) + " by ";
        for (const Party party : expectation.parties)
        {
            verdict.holds = verdict.holds || (effect >= 0 && party == detection.party);
            verdict.wanted += std::string(party == expectation.parties.front() ? "" : " or ") + Name(party);
        }
        verdict.seen = (effect < 0) ? "the fault never happened" : DetectionText(detection);
        verdict.effect = effect;
        verdict.detection = (effect < 0) ? std::nullopt : std::optional<Detection>(detection);
        return verdict;
    }

    /// What the limit counts from: see semantics 5.
    [[nodiscard]] Nanoseconds ReferenceOf(const Measurement& measurement, const Event& closed) const
    {
        const FaultSetup& fault = scenario_.faults[measurement.fault];
        if (measurement.fault_class == FaultClass::kBus || measurement.fault_class == FaultClass::kBusNextNormal)
        {
            return closed.since;
        }
        const bool is_by_the_inverse = RowOf(fault.kind).limit.shown == Shown::kByTheInverse && !fault.length;
        if (is_by_the_inverse && closed.inverse >= measurement.effect)
        {
            return closed.inverse;
        }
        return measurement.effect;
    }

    /// A fault of the bus after which the next normal frame still came, while it could be waited for, has the limit of
    /// that; before the run nobody knows.
    void TakeNextNormal(const Expectation& expectation, const Event& closed, Measurement& measurement)
    {
        const bool follows = expectation.fault_class == FaultClass::kInvalid;
        const DeviceConfig& config = network_.At(expectation.node).Model().Config();
        const Nanoseconds behind =
            Nanoseconds{LateCycleUs(config) + config.output_time_us} * kNanosecondsPerMicrosecond;
        const bool came =
            closed.next_normal > closed.since && closed.next_normal - closed.since <= measurement.limit - behind;
        if (follows && measurement.fault_class == FaultClass::kBus && came)
        {
            Expectation next = expectation;
            next.fault_class = FaultClass::kBusNextNormal;
            measurement.fault_class = next.fault_class;
            measurement.limit = LimitOf(scenario_, next, network_.At(expectation.node).Model());
        }
    }

    [[nodiscard]] Measurement Measure(const Expectation& expectation)
    {
        const runtime::DeviceModel& model = network_.At(expectation.node).Model();
        Measurement measurement;
        measurement.fault = expectation.fault;
        measurement.node = expectation.node;
        measurement.place = NameOfPlace(expectation);
        measurement.srdo = expectation.srdo;
        measurement.fault_class = LimitClassOf(scenario_, expectation);
        measurement.limit = LimitOf(scenario_, expectation, model);
        measurement.effect = journal_.EffectOf(expectation.fault);
        if (measurement.effect < 0)
        {
            return measurement;
        }
        measurement.was_open = IsOpen(expectation, expectation.srdo, measurement.effect - 1);
        const Event* const closed = ClosedAfter(journal_, expectation, measurement.effect);
        if (closed != nullptr)
        {
            measurement.closed = closed->at;
            TakeNextNormal(expectation, *closed, measurement);
            measurement.reference = ReferenceOf(measurement, *closed);
            measurement.elapsed =
                closed->at - measurement.reference + model.Config().output_time_us * kNanosecondsPerMicrosecond;
        }
        measurement.detection = FirstDetection(expectation, measurement.effect);
        // What somebody noticed at that very instant would have closed it as well.
        measurement.is_commanded = closed != nullptr && IsCommanded(journal_, closed->node, closed->srdo, closed->at) &&
                                   DetectionAt(journal_, closed->node, closed->at).at != closed->at;
        return measurement;
    }

    [[nodiscard]] ExpectationVerdict OfLimit(const Expectation& expectation)
    {
        const Measurement measurement = Measure(expectation);
        ExpectationVerdict verdict;
        verdict.holds = measurement.Holds();
        const bool has_limit = measurement.limit != kNoLimit;
        verdict.wanted = Place(expectation) + " safe within " +
                         (has_limit ? LimitText(measurement.limit) : "a limit, where its times give none,") +
                         " after '" + scenario_.faults[expectation.fault].name +
                         "' (limit: " + Name(measurement.fault_class) + ")";
        if (measurement.effect < 0)
        {
            verdict.seen = "the fault never happened";
        }
        else if (!measurement.was_open)
        {
            verdict.seen = "the output was not released when the fault came";
        }
        else if (measurement.is_commanded)
        {
            verdict.seen = "closed by a command or without supply at " + MillisecondsText(measurement.closed);
        }
        else
        {
            verdict.seen = (measurement.elapsed < 0) ? "not safe until the end" : MillisecondsText(measurement.elapsed);
        }
        verdict.measurement = measurement;
        return verdict;
    }

    [[nodiscard]] std::string FaultText(const Event& event) const
    {
        const std::string where = NameOfNode(event.node) + " ";
        if (event.kind == EventKind::kSignal)
        {
            return where + Name(static_cast<SrdoCause>(event.value));
        }
        if (event.kind == EventKind::kDeviceFault)
        {
            return where + Name(static_cast<DeviceFault>(event.value));
        }
        if (event.kind == EventKind::kWatchdog)
        {
            return where + "watchdog";
        }
        return (event.kind == EventKind::kConfigurationInvalid) ? where + "configuration invalid" : "";
    }

    [[nodiscard]] ExpectationVerdict OfNoFault(const Expectation& expectation) const
    {
        ExpectationVerdict verdict;
        const bool is_any = expectation.node == kNoNode;
        verdict.wanted = "no fault" + (is_any ? std::string() : " at " + NameOfPlace(expectation));
        for (const Event& event : journal_.Events())
        {
            const bool is_here = event.node != kNoNode && (is_any || IsMeant(expectation, event.node));
            const bool is_harmless = event.kind == EventKind::kSignal &&
                                     event.value == static_cast<std::uint64_t>(SrdoCause::kWaitingPastSct);
            if (is_here && !is_harmless && verdict.seen.empty())
            {
                const std::string text = FaultText(event);
                verdict.seen = text.empty() ? "" : text + " at " + MillisecondsText(event.at);
            }
        }
        verdict.holds = verdict.seen.empty();
        verdict.seen = verdict.holds ? "none" : verdict.seen;
        return verdict;
    }

    const Scenario& scenario_;
    const Journal& journal_;
    Network& network_;
};
} // namespace

Nanoseconds LimitOf(const Scenario& scenario, const Expectation& expectation, const runtime::DeviceModel& model)
{
    const FaultClass fault_class = LimitClassOf(scenario, expectation);
    SrdoTimes times{};
    for (const runtime::SrdoModel& srdo : model.Srdos())
    {
        times = (srdo.number == expectation.srdo) ? srdo.times : times;
    }
    const FaultSetup& fault = scenario.faults[expectation.fault];
    const NodeSetup& node = scenario.nodes[expectation.node];
    const bool is_peers_clock = fault_class == FaultClass::kClock && fault.kind == FaultKind(NodeFault::kClock) &&
                                node.role != runtime::CpuRole::kWhole &&
                                scenario.nodes[fault.node].device == node.device;
    if (fault_class == FaultClass::kCrossLink || is_peers_clock)
    {
        // The clocks are compared by messages, the last of which may be as old as the time-out.
        const Nanoseconds own = node.link.timeout + (is_peers_clock ? node.link.clock_interval : 0);
        const auto own_us = static_cast<std::uint32_t>(own / kNanosecondsPerMicrosecond);
        return TimeOf(ComputeLimit(model.Config(), LinkTime{own_us}));
    }
    return TimeOf(ComputeLimit(model.Config(), times, fault_class));
}

Nanoseconds ClosedAt(const Journal& journal, const Expectation& expectation, const Nanoseconds from)
{
    const Event* const closed = ClosedAfter(journal, expectation, from);
    return (closed == nullptr) ? -1 : closed->at;
}

std::string LimitText(const Nanoseconds limit)
{
    return (limit == kNoLimit) ? "none" : MillisecondsText(limit);
}

/// Refused by a device that is well: nothing of the scenario shows what it was to do. [SRS_SIM_660]
bool IsVainGfc(const Event& event)
{
    return event.kind == EventKind::kGfc && event.value == 0U &&
           event.other != static_cast<std::uint64_t>(Result::kDeviceFault);
}

std::string GfcText(const Event& event)
{
    switch (static_cast<Result>(event.other))
    {
    case Result::kGfcUnsupported:
        return "refused: 1300h is 0";
    case Result::kNmtError:
        return "refused: not OPERATIONAL";
    case Result::kInvalidConfiguration:
        return "refused: 13FEh is not A5h";
    default:
        return "refused";
    }
}

std::string StoreText(const Event& event)
{
    constexpr std::uint32_t kNotInThisState = 0x08000022U;
    const ObjectAddress object{static_cast<std::uint16_t>(event.other >> 8U), static_cast<std::uint8_t>(event.other)};
    const auto abort = static_cast<std::uint32_t>(event.other >> 32U);
    const std::string why = (abort == kNotInThisState) ? " (not in the present state)" : "";
    const std::string refused = ": refused, " + runtime::AbortText(static_cast<AbortCode>(abort)) + why;
    return ObjectText(object) + " = " + std::to_string(event.value) + ((abort == 0U) ? "" : refused);
}

std::vector<ExpectationVerdict> Judge(const Scenario& scenario, const Journal& journal, Network& network,
                                      const std::vector<std::string>& found)
{
    Judgement judgement(scenario, journal, network);
    std::vector<ExpectationVerdict> verdicts;
    for (std::size_t index = 0U; index < scenario.expectations.size(); ++index)
    {
        const Expectation& expectation = scenario.expectations[index];
        verdicts.push_back(IsOfNetwork(expectation.kind) ? judgement.OfFound(expectation, found[index])
                                                         : judgement.Of(expectation));
        verdicts.back().expectation = index;
    }
    for (std::size_t index = 0U; index < scenario.faults.size(); ++index)
    {
        if (!scenario.faults[index].is_optional && journal.EffectOf(index) < 0)
        {
            const std::string wanted = "fault " + runtime::Shown(scenario.faults[index].name) + " happens";
            verdicts.push_back({kOfItself, false, wanted, "never happened", {}});
        }
    }
    for (const Event& event : journal.Events())
    {
        if (event.kind == EventKind::kStore && (event.other >> 32U) != 0U)
        {
            const std::string& name = scenario.nodes[event.node].name;
            const std::string wanted = "store into " + name + " at " + MillisecondsText(event.at) + " is taken";
            verdicts.push_back({kOfItself, false, wanted, StoreText(event), {}});
        }
        else if (IsVainGfc(event))
        {
            const std::string& name = scenario.nodes[event.node].name;
            const std::string wanted = "GFC of " + name + " at " + MillisecondsText(event.at) + " is sent";
            verdicts.push_back({kOfItself, false, wanted, GfcText(event), {}});
        }
    }
    return verdicts;
}
} // namespace counterpoint::simulator
