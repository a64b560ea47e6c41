// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "simulator/scenario/names.hpp"
#include "simulator/scenario/network_names.hpp"
#include "simulator/scenario/schema.hpp"

// What is on the bus, and what happens to it. [SRS_SIM_047]
namespace counterpoint::simulator
{
namespace
{
using T = ValueType;
constexpr Range kAny{0U, 0xFFFFFFFFFFFFFFFFU};
constexpr Range kWords32{0U, 0xFFFFFFFFU};
constexpr Range kControllers{1U, 2U};
constexpr Range kBitRates{10000U, 1000000U};

const KeySpec kSrdo{"srdo", Number({1U, 64U}), kNeeded, "1", "number of the SRDO"};
const KeySpec kFault{"fault", T::kText, kOptional, "loss",
                     "name of one of the faults; may be left out when there is only one"};
} // namespace

const std::vector<SectionSpec> kWorldSections{
    Section(
        "scenario", "a scenario", "The whole file.",
        {{"extends", T::kText, kOptional, "chain.yaml",
          "another scenario, relative to this file: its single values are defaults, its lists come first; one step "
          "only"},
         {"title", T::kText, kOptional, "Loss of one frame", "shown to people"},
         {"description", T::kParagraph, kOptional, "A frame is lost.", "shown to people"},
         {"nodes",
          {T::kNamedMaps, {}, nullptr, "node"},
          kOptional,
          "{sensor: {dcf: sensor.dcf}}",
          "the devices by their names, 1 to 127; needed here or in what is extended, unless there are managers"},
         {"managers", Maps("manager"), kOptional, "[{network: chain.yaml}]",
          "network managers; the devices are then whole ones with their services, and start when a manager says so"},
         {"profiles", SomeOf<kProfileWords>(), kOptional, "[cia302, el6751]",
          "start-up profiles of its managers that it is written for, whatever their network files say: the first one, "
          "or that of --profile"},
         {"bitrate", Number(kBitRates), kOptional, "500000",
          "bit/s: 10000, 20000, 50000, 100000, 125000, 250000, 500000 (default), 800000, 1000000"},
         {"duration", T::kDuration, kOptional, "1000 ms", "simulated time; needed here or in what is extended"},
         {"seed", Number(kAny), kOptional, "7", "for everything that is left to chance; default 1"},
         {"inputs", Maps("input"), kOptional, "[{at: 20 ms, node: sensor, object: 0x2000:01, value: 1}]",
          "inputs of producers change"},
         {"logic", Maps("logic"), kOptional, "[{node: controller, set: 0x2000:01, op: and, from: [0x2200:01]}]",
          "objects of producers that are computed from objects of consumers"},
         {"acknowledge", Maps("acknowledge"), kOptional, "[{at: 150 ms, node: actuator, srdo: 1}]",
          "acknowledge inputs"},
         {"nmt", Maps("nmt"), kOptional, "[{at: 600 ms, node: all, command: stop}]", "NMT states and commands"},
         {"power", Maps("power"), kOptional, "[{at: 600 ms, node: sensor, off: 20 ms}]",
          "nodes that lose their supply for a while"},
         {"gfc", Maps("gfc"), kOptional, "[{at: 600 ms, node: sensor}]",
          "nodes that send the global fail-safe command"},
         {"events", Maps("events"), kOptional, "[{at: 3 s, do: pull, node: relay}]",
          "what happens to devices and managers, and frames of somebody else"},
         {"faults", Maps("fault"), kOptional, "[{fault: loss, frames: {identifier: 0x104}}]", "what goes wrong"},
         {"expect", Maps("expect"), kOptional, "[{that: no_fault}]", "what has to come out"}}),
    Section("nodes", "nodes",
            "The devices: a map of names to nodes; 'all' and 'bus' are no names, a number from 1 to 127 is the "
            "node-ID, too.",
            {}),
    Section(
        "node", "a node",
        "A node is the shipped kernel with both shipped channels, configured through the kernel's object access.",
        {{"dcf", T::kText, kNeeded, "sensor.dcf",
          "the device, relative to this file: SRDOs, mapping, signatures and the objects from 0x5F00 on are taken from "
          "it"},
         {"node_id", Number({1U, 127U}), kOptional, "1", "instead of the one in the DCF"},
         {"serial", Number(kWords32), kOptional, "77", "1018h:04 instead of the DCF's; with managers"},
         {"controllers", Number(kControllers), "1", "2",
          "CAN controllers; 2, or a DCF that names two: the first has the normal frames (and everything else), the "
          "second the inverse frames"},
         {"structure", OneOf<kStructureWords>(), "one_cpu", "two_cpu",
          "two_cpu: NAME.a and NAME.b, a kernel with one channel each, joined by the cross link; cpu_a, cpu_b and link "
          "instead of controllers, phase and counters"},
         {"cpu_a", Map("cpu"), kOptional, "{phase: 130 us, counter: {ppm: 20}}", "of two_cpu: what is its own"},
         {"cpu_b", Map("cpu"), kOptional, "{phase: 640 us, counter: {ppm: -20}}", "of two_cpu: what is its own"},
         {"link", Map("link"), kOptional, "{timeout: 10 ms, delay: 200 us}", "of two_cpu: the link between them"},
         {"self_tests", OneOf<kYesWords>(), "true", "false",
          "the device runs the self tests of safety_core/selftest; they have to fit into its diagnostic interval"},
         {"phase", T::kDuration, "0 ms", "130 us", "instant of power-on; cycles follow from then on"},
         {"start_at", T::kDuration, kOptional, "10 ms",
          "enters OPERATIONAL; default 10 ms, with managers when one says so"},
         {"counter_a", Map("counter"), kOptional, "{ppm: 20, start_us: 1000}",
          "the first counter; the node's cycle runs on its oscillator"},
         {"counter_b", Map("counter"), kOptional, "{ppm: -15}", "the second counter"}}),
    Section("cpu", "a CPU", "One CPU of two: it has one counter, the other CPU's is the second one.",
            {{"phase", T::kDuration, "0 ms", "640 us", "instant of power-on; cycles follow from then on"},
             {"counter", Map("counter"), kOptional, "{ppm: -20, start_us: 5000}",
              "its clock; its cycle runs on the same oscillator"}}),
    Section("link", "a link", "The link between the two CPUs of a device; what it must hold is in decision 0005.",
            {{"timeout", T::kLasting, "10 ms", "20 ms", "greatest age of what the other CPU said; 3 cycles or more"},
             {"delay", T::kDuration, "0.1 ms", "200 us", "how long a message takes"},
             {"jitter", T::kDuration, "0 ms", "50 us", "each message takes up to so much longer, drawn from the seed"},
             {"clock_tolerance", T::kLasting, "2 ms", "1 ms",
              "greatest difference of the clocks' progress in the interval; at most half the time-out; half of it, "
              "less two "
              "time-outs' share of the interval, holds drift and jitter of half an interval"},
             {"clock_interval", T::kLasting, "500 ms", "1 s",
              "within it and a time-out a drift above the tolerance is found; at least four time-outs"},
             {"stamp_tolerance", T::kDuration, "0.05 ms", "100 us",
              "by how much the stamps of one frame may differ on the two CPUs; below the time-out"}}),
    Section("counter", "a counter", "One of the two counters of a node.",
            {{"ppm", T::kPpm, "0", "-15", "drift; positive is fast"},
             {"start_us", Number(kWords32), "0", "4294900000", "first reading in microseconds"}}),
    Section("input", "an input", "The input behind the normal object of a producer changes.",
            {kAtKey,
             kNodeKey,
             {"object", T::kObject, kNeeded, "0x2000:01", "the normal object of a producer"},
             {"value", Number(kAny), kNeeded, "1", "its input from then on; fits its bits"}}),
    Section("logic", "a logic rule", "Normal is computed from normal, inverse from inverse objects, all of one length.",
            {kNodeKey,
             {"set", T::kObject, kNeeded, "0x2000:01", "the normal object of a producer"},
             {"op", OneOf<runtime::kOperationWords>(), kNeeded, "and", "copy and not take one object"},
             {"from", T::kObjects, kNeeded, "[0x2200:01, 0x2200:02]", "normal objects of consumers"}}),
    Section("acknowledge", "an acknowledge",
            "The acknowledge input of both channels is 1 for a while; where several overlap until the last one ends.",
            {kAtKey, kNodeKey, kSrdo, {"pulse", T::kLasting, "50 ms", "50 ms", "how long the input is pressed"}}),
    Section("nmt", "an NMT event", "The state of a node is set, or an NMT command is followed.",
            {kAtKey,
             {"node", T::kNode, kNeeded, "all", "which node, or all"},
             {"state", OneOf<runtime::kNmtWords>(), kOptional, "stopped", "the node is in this state"},
             {"command", OneOf<kCommandWords>(), kOptional, "reset_node",
              "instead of state: reset_node starts the kernel anew, reset_communication passes initialising"},
             {"start_after", T::kDuration, kOptional, "10 ms",
              "after a reset: enters OPERATIONAL so much later; else it stays pre-operational until told"}}),
    Section("power", "a power cycle",
            "A node loses its supply: outputs close, frames are forgotten, counters begin again.",
            {kAtKey,
             kNodeKey,
             {"off", T::kLasting, kNeeded, "20 ms", "how long the supply is away"},
             {"start_after", T::kDuration, kOptional, "10 ms",
              "enters OPERATIONAL so long after power-on; else it stays pre-operational until told"}}),
    Section("gfc", "a GFC event", "The node sends the global fail-safe command.", {kAtKey, kNodeKey}),
};

const std::vector<SectionSpec> kExpectationSections{
    Section(
        "expect", "an expectation",
        "An expectation; its other keys follow from 'that'. One that holds, or does not, whatever happens is refused.",
        {{"that", OneOf<kExpectationWords>(), kNeeded, "safe_within", "what is expected"}, kProfileKey}),
    Expected("released", "The output of the SRDO is open at that time.", {kNodeKey, kSrdo, kAtKey}),
    Expected("safe", "The output of the SRDO is not open at that time.", {kNodeKey, kSrdo, kAtKey}),
    Expected("value", "The application uses this value at that time.",
             {kNodeKey,
              {"object", T::kObject, kNeeded, "0x2200:01", "the normal object of a consumer"},
              {"is", Number(kAny), kNeeded, "1", "the value"},
              kAtKey}),
    Expected(
        "cause", "The application was told of this cause.",
        {kNodeKey, kSrdo, {"is", OneOf<runtime::kCauseWords>(), kNeeded, "sct", "the cause; none: no cause at all"}}),
    Expected(
        "device_fault", "The device safe state was entered for this reason.",
        {kNodeKey, {"is", OneOf<runtime::kDeviceFaultWords>(), kNeeded, "clock", "the reason; none: not entered"}}),
    Expected("detected_by", "The first to notice the fault at this node was this party.",
             {kFault,
              kNodeKey,
              {"by", SomeOf<kPartyWords>(), kNeeded, "[comparator, guard]",
               "the party, or a list: any of them; channels: both in one cycle; kernel: by the comparator's echo "
               "and test; self_test: also one that says nothing"}}),
    Expected("safe_within", "The output was open when the fault came, and was safe within the computed limit.",
             {kFault,
              kNodeKey,
              kSrdo,
              {"limit", OneOf<kFaultClassWords>(), kOptional, "bus",
               "row of the table of limits; without it the row follows from the fault"}}),
    Expected("no_fault", "No cause, no device fault, no watchdog.",
             {{"node", T::kNode, kOptional, "actuator", "at which node; without: nowhere"}}),
};
} // namespace counterpoint::simulator
