"use strict";
// Draws the timing diagram of one run at a time from the recording in #data. All times are nanoseconds.
(() => {
  const DATA = JSON.parse(document.getElementById("data").textContent);
  const $ = id => document.getElementById(id);
  const GUTTER = 210, RIGHT = 32, TOP = 46, AXIS = 26;
  const LOUD = new Set(["fault", "link", "self_test", "device_fault", "watchdog", "hung", "output", "frame_changed",
    "new_node_id"]);
  const esc = text => String(text).replace(/[&<>"]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" }[c]));
  const hex = id => id.toString(16).toUpperCase().padStart(3, "0") + "h";
  let run = null, lanes = [], hidden = new Set(), from = 0, to = 1, queued = false;

  function duration(ns) {
    const size = Math.abs(ns);
    const [unit, scale] = size >= 1e9 ? ["s", 1e9] : size >= 1e6 ? ["ms", 1e6] : ["µs", 1e3];
    return +(ns / scale).toFixed(unit === "µs" ? 1 : 3) + " " + unit;
  }
  const at = ns => (ns / 1e6).toFixed(3) + " ms";

  // Segments [from, to, value] of something that changes at events.
  function segments(events, first, value) {
    const list = [];
    let begin = 0, now = first;
    for (const event of events) {
      const next = value(event);
      if (next === now) continue;
      if (event.at_ns > begin) list.push([begin, event.at_ns, now]);
      begin = event.at_ns;
      now = next;
    }
    list.push([begin, run.duration_ns, now]);
    return list;
  }

  // Remaining SCT after each good pair and remaining SRVT after each normal frame, as lines.
  function timers(node, srdo) {
    const sct = srdo.sct_ms * 1e6, srvt = srdo.srvt_ms * 1e6, lines = { sct: [], srvt: [], zero: [] };
    let normal = null, good = null, since = 0;
    const endSct = until => {
      if (good === null) return;
      const dead = good + sct;
      lines.sct.push([since, 1 - (since - good) / sct, Math.min(until, dead), Math.max(0, 1 - (until - good) / sct)]);
      if (until > dead) lines.zero.push([dead, until]);
    };
    const endSrvt = until => {
      if (normal === null) return;
      const stop = Math.min(until, normal + srvt);
      lines.srvt.push([normal, 1, stop, 1 - (stop - normal) / srvt]);
    };
    for (const event of run.events) {
      if (event.kind !== "reception" || event.node !== node.name || event.srdo !== srdo.number) continue;
      endSrvt(event.at_ns);
      if (event.identifier % 2 === 1) {
        normal = event.at_ns;
        continue;
      }
      if (event.good) {
        endSct(event.at_ns);
        good = normal;
        since = event.at_ns;
      }
      normal = null;
    }
    endSrvt(run.duration_ns);
    endSct(run.duration_ns);
    return lines;
  }

  function busLanes() {
    const pairs = new Map();
    for (const frame of run.frames) {
      const isSrdo = frame.identifier >= 0x101 && frame.identifier <= 0x180;
      const first = isSrdo ? frame.identifier - (frame.identifier + 1) % 2 : frame.identifier;
      if (!pairs.has(first)) pairs.set(first, { isSrdo, frames: [] });
      pairs.get(first).frames.push(frame);
    }
    const list = [];
    for (const [first, pair] of [...pairs].sort((a, b) => a[0] - b[0])) {
      const label = pair.isSrdo ? hex(first) + " / " + hex(first + 1) : hex(first);
      const mine = id => id === first || (pair.isSrdo && id === first + 1);
      const changed = run.events.filter(e => e.kind === "frame_changed" && mine(e.identifier));
      list.push({ kind: "frames", height: 32, label, note: pair.isSrdo ? "normal / inverse" : "", frames: pair.frames, changed });
    }
    return list;
  }

  function srdoLanes(node, srdo) {
    const mine = kind => run.events.filter(e => e.kind === kind && e.node === node.name && e.srdo === srdo.number);
    const ofNode = kind => run.events.filter(e => e.kind === kind && e.node === node.name);
    // A node that hangs says nothing any more; its output stage goes on.
    const stop = run.events.find(e => e.kind === "hung" && e.node === node.name);
    const untilHung = (events, first, value) => segments(stop ? [...events.filter(e => e.at_ns < stop.at_ns), stop] : events, first,
      e => e === stop ? "halted" : value(e));
    const bit = (mask, slot) => Math.floor(mask / 2 ** slot) % 2 === 1;
    const view = (letter, height) => ({
      kind: "state", height, label: "SRDO " + srdo.number + " channel " + letter.toUpperCase(),
      segments: untilHung(mine("view_" + letter), "off", e => e.state), words: { halted: "stands still" },
      marks: mine("cause_" + letter).map(e => [e.at_ns, e.text])
    });
    const onOff = (label, cut, events, value, words, height) => ({
      kind: "state", height: height || 15, label, words: { halted: "stands still", ...words },
      segments: cut(events, "off", e => value(e) ? "released" : "off")
    });
    // A CPU of two has one channel; the other one is heard over the link.
    const views = node.cpu ? [view(node.cpu, 16)] : [view("a", 16), view("b", 16)];
    const output = onOff("SRDO " + srdo.number + " output", segments, mine("output"), e => e.value !== 0, { released: "OPEN", off: "SAFE" }, 20);
    // In a network with managers nobody looks into the devices.
    if (run.managers.length) return srdo.direction === "consumer" ? [output] : [];
    if (srdo.direction === "producer") return views;
    if (srdo.direction !== "consumer") return [];
    const list = [
      { kind: "timers", height: 44, label: "SRDO " + srdo.number + " time left",
        note: "SCT " + srdo.sct_ms + " ms, SRVT " + srdo.srvt_ms + " ms", lines: timers(node, srdo), srdo },
      ...views,
      onOff("SRDO " + srdo.number + " comparator", untilHung, ofNode("verdict"), e => bit(e.agreed, srdo.slot), { released: "agreed", off: "not agreed" }),
      onOff("SRDO " + srdo.number + " permits", untilHung, ofNode("permits"), e => bit(e.value, srdo.slot), { released: "three", off: "none" }),
      output
    ];
    const values = new Map();
    for (const event of mine("value")) {
      if (!values.has(event.object)) values.set(event.object, []);
      values.get(event.object).push(event);
    }
    for (const [object, events] of [...values].sort()) {
      list.push({ kind: "value", height: 22, label: object + " as used", segments: untilHung(events, 0, e => e.value) });
    }
    return list;
  }

  // What a CPU of two has of the other one, and the messages that a fault hit.
  function linkLane(node) {
    if (!node.cpu) return [];
    const mine = kind => run.events.filter(e => e.kind === kind && e.node === node.name);
    const states = { alive: "released", waiting: "off", lost: "faulted" };
    return [{
      kind: "state", height: 16, label: "link to the other CPU",
      segments: segments(mine("link"), "off", e => states[e.state]),
      words: { released: "alive", off: "no contact yet", faulted: "LOST" },
      marks: mine("link_message").map(e => [e.at_ns, e.text])
    }];
  }

  // What the bus made of a device that a manager starts.
  function stateLane(node) {
    if (!run.managers.length) return [];
    const mine = run.events.filter(e => e.node === node.name && (e.kind === "nmt" || e.kind === "power_off"));
    const styles = { operational: "released", stopped: "faulted", pre_operational: "waiting", initialising: "waiting" };
    return [{
      kind: "state", height: 16, label: "NMT state", segments: segments(mine, "off", e => styles[e.state] || "off"),
      words: { released: "operational", faulted: "stopped", waiting: "pre-operational", off: "no supply" }
    }];
  }

  // What a manager told about each of its nodes.
  function managerLane(manager) {
    const told = manager.events.filter(e => e.text);
    return [{ kind: "state", height: 16, label: "events", segments: [], marks: told.map(e => [e.t_us * 1e3, e.text]) }];
  }

  function buildLanes() {
    lanes = [];
    const group = (name, note, content) => {
      if (hidden.has(name)) return;
      lanes.push({ kind: "head", height: 26, label: name, note });
      lanes.push(...content);
    };
    group("bus", run.bitrate / 1000 + " kbit/s", busLanes());
    for (const node of run.nodes) {
      group(node.name, "node " + node.node_id + ", " + node.dcf, [...linkLane(node), ...stateLane(node), ...node.srdos.flatMap(srdo => srdoLanes(node, srdo))]);
    }
    for (const manager of run.managers) group(manager.name, "node " + manager.node, managerLane(manager));
    let y = TOP;
    for (const lane of lanes) {
      lane.y = y;
      y += lane.height + 4;
    }
    lanes.bottom = y;
  }

  // ---- drawing -----------------------------------------------------------------------------------------------------
  let scale = 1;
  const limitText = m => m.limit_ns === null ? "none" : duration(m.limit_ns);
  const X = ns => GUTTER + (ns - from) * scale;
  const shown = (begin, end) => end >= from && begin <= to;
  const clip = ns => Math.max(from, Math.min(to, ns));
  const tip = text => text ? ` data-tip="${esc(text)}"` : "";

  function rect(cls, begin, end, y, height, text, least) {
    const x = X(clip(begin)), width = Math.max(least || 0.5, X(clip(end)) - x);
    return `<rect class="${cls}" x="${x.toFixed(1)}" y="${y}" width="${width.toFixed(1)}" height="${height}"${tip(text)}/>`;
  }

  function drawFrames(lane) {
    let out = "", lastX = [-9, -9];
    const half = (lane.height - 2) / 2;
    for (const f of lane.frames) {
      if (!shown(f.start_ns, f.end_ns)) continue;
      const inverse = f.identifier % 2 === 0 && lane.note !== ""; // Inverse frames have even identifiers.
      const row = inverse ? 1 : 0;
      const strange = f.sender === null || f.fate !== "complete";
      const x = X(f.start_ns);
      if (!strange && x - lastX[row] < 0.7) continue; // Closer than a pixel: one mark stands for both.
      lastX[row] = x;
      const text = `${hex(f.identifier)}  ${f.data || "no data"}\n${f.sender === null ? "inserted" : "from " + f.sender}` +
        `${f.fate === "complete" ? "" : ", " + f.fate.replace("_", " ")}\nends at ${at(f.end_ns)}, ${duration(f.end_ns - f.start_ns)} long`;
      const cls = f.sender === null ? "strange" : f.fate !== "complete" ? "lost" : inverse ? "inverse" : "normal";
      out += rect(cls, f.start_ns, f.end_ns, lane.y + row * (half + 2), half, text, strange ? 4 : 2.2);
    }
    for (const e of lane.changed) {
      if (!shown(e.at_ns, e.at_ns)) continue;
      const row = e.identifier % 2 === 0 && lane.note !== "" ? 1 : 0, y = lane.y + row * (half + 2) + half / 2, x = X(e.at_ns).toFixed(1);
      out += `<path class="strange" d="M${x} ${y - 7}l5 7-5 7-5-7z"${tip(`${e.text}\nreceiver: ${e.node}\n${at(e.at_ns)}`)}/>`;
    }
    return out;
  }

  function drawState(lane) {
    let out = "";
    for (const [begin, end, state] of lane.segments) {
      if (!shown(begin, end)) continue;
      const word = (lane.words && lane.words[state]) || state;
      out += rect(state, begin, end, lane.y, lane.height, `${lane.label}: ${word}\n${at(begin)} to ${at(end)}`);
      if ((X(clip(end)) - X(clip(begin))) > word.length * 7 + 10) {
        out += `<text class="in ${state}" x="${(X(clip(begin)) + 5).toFixed(1)}" y="${lane.y + lane.height / 2 + 4}">${esc(word)}</text>`;
      }
    }
    for (const [time, text] of lane.marks || []) {
      if (!shown(time, time)) continue;
      const x = X(time).toFixed(1), y = lane.y + lane.height / 2;
      out += `<path class="strange" d="M${x} ${y - 7}l5 7-5 7-5-7z"${tip(text + "\n" + at(time))}/>`;
    }
    return out;
  }

  function drawValue(lane) {
    const top = lane.y + 3, low = lane.y + lane.height - 3;
    const most = lane.segments.reduce((best, s) => Math.max(best, +s[2] || 0), 1);
    let path = "", out = "";
    for (const [begin, end, value] of lane.segments) {
      if (!shown(begin, end) || value === "halted") continue;
      const y = (low - (low - top) * value / most).toFixed(1);
      path += `${path ? "L" : "M"}${X(clip(begin)).toFixed(1)} ${y}L${X(clip(end)).toFixed(1)} ${y}`;
      out += `<rect x="${X(clip(begin))}" y="${lane.y}" width="${Math.max(1, X(clip(end)) - X(clip(begin)))}" height="${lane.height}" ` +
        `fill="transparent"${tip(`${lane.label} = ${value}\nfrom ${at(begin)} to ${at(end)}`)}/>`;
      if (X(clip(end)) - X(clip(begin)) > 24) out += `<text class="small muted" x="${X(clip(begin)) + 5}" y="${value ? low + 1 : top + 8}">${value}</text>`;
    }
    return `<path class="wave" d="${path}"/>` + out;
  }

  function drawTimers(lane) {
    const low = lane.y + lane.height, full = lane.height - 2;
    const y = part => (low - part * full).toFixed(1);
    let area = "", line = "", srvt = "", out = "";
    for (const [begin, first, end, last] of lane.lines.sct) {
      if (!shown(begin, end)) continue;
      const a = X(begin).toFixed(1), b = X(end).toFixed(1);
      area += `M${a} ${low}L${a} ${y(first)}L${b} ${y(last)}L${b} ${low}Z`;
      line += `M${a} ${y(first)}L${b} ${y(last)}L${b} ${last > 0 ? y(last) : low}`;
    }
    for (const [begin, first, end, last] of lane.lines.srvt) {
      if (shown(begin, end)) srvt += `M${X(begin).toFixed(1)} ${y(first)}L${X(end).toFixed(1)} ${y(last)}`;
    }
    out += `<clipPath id="c${lane.y}"><rect x="${GUTTER}" y="${lane.y - 2}" width="${width - GUTTER - RIGHT}" height="${lane.height + 4}"/></clipPath>`;
    out += `<g clip-path="url(#c${lane.y})"><line class="rule" x1="${GUTTER}" x2="${width - RIGHT}" y1="${low}" y2="${low}"/>`;
    out += `<path class="sct-area" d="${area}"/><path class="sct-line" d="${line}"/><path class="srvt-line" d="${srvt}"/>`;
    for (const [begin, end] of lane.lines.zero) {
      if (shown(begin, end)) out += `<line class="zero" x1="${X(clip(begin)).toFixed(1)}" x2="${X(clip(end)).toFixed(1)}" y1="${low}" y2="${low}"${tip("SCT expired at " + at(begin))}/>`;
    }
    out += "</g>";
    out += `<rect x="${GUTTER}" y="${lane.y}" width="${width - GUTTER - RIGHT}" height="${lane.height}" fill="transparent" data-timer="${lane.y}"/>`;
    return out;
  }

  function axis(bottom) {
    const span = to - from, room = (width - GUTTER - RIGHT) / 90;
    const raw = span / room, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map(f => f * power).find(s => s >= raw);
    const unit = step >= 1e9 ? ["s", 1e9] : step >= 1e5 ? ["ms", 1e6] : ["µs", 1e3];
    let out = "";
    for (let t = Math.ceil(from / step) * step; t <= to; t += step) {
      const x = X(t).toFixed(1), text = +(t / unit[1]).toFixed(3) + " " + unit[0];
      out += `<line class="grid" x1="${x}" x2="${x}" y1="${TOP - 6}" y2="${bottom}"/>`;
      out += `<text class="small muted" text-anchor="middle" x="${x}" y="${bottom + 16}">${text}</text>`;
    }
    return out;
  }

  function marks(bottom) {
    let out = "";
    const taken = [];
    const line = (cls, time, text, long) => {
      if (time === null || !shown(time, time)) return;
      const x = X(time), size = text.length * 6.6;
      const left = x + size + 6 > width;
      const begin = left ? x - size - 4 : x + 4;
      let row = 0;
      while (row < 2 && taken.some(([r, a, b]) => r === row && begin < b && begin + size > a)) ++row;
      taken.push([row, begin, begin + size]);
      out += `<line class="m-${cls}" x1="${x.toFixed(1)}" x2="${x.toFixed(1)}" y1="${6 + row * 13}" y2="${bottom}"${tip(long + "\n" + at(time))}/>`;
      out += `<text class="small t-${cls}" x="${begin.toFixed(1)}" y="${14 + row * 13}">${esc(text)}</text>`;
    };
    const m = measurement();
    if (m && m.reference_ns !== null) {
      const end = m.reference_ns + m.elapsed_ns, limit = m.reference_ns + m.limit_ns;
      if (shown(m.reference_ns, end)) out += rect("band", m.reference_ns, end, TOP - 6, bottom - TOP + 6);
      if (limit > end && shown(end, limit)) out += rect("spare", end, limit, TOP - 6, bottom - TOP + 6);
    }
    for (const event of run.events) {
      if (event.kind === "fault") line("fault", event.at_ns, event.fault, "Fault: " + event.fault + " (" + event.node + ")");
    }
    if (m) {
      line("found", m.detected_ns, "detected", "Detected by " + m.detected_by + ": " + m.detection_cause);
      line("safe", m.closed_ns, "safe", "Output of " + m.node + " SRDO " + m.srdo + " safe");
      if (m.reference_ns !== null) {
        if (m.limit_ns !== null) line("limit", m.reference_ns + m.limit_ns, "limit", "Limit " + duration(m.limit_ns) + ", counted from " + at(m.reference_ns));
      }
    }
    return out;
  }

  let width = 1200;
  function draw() {
    queued = false;
    width = Math.max(700, $("diagram").clientWidth);
    scale = (width - GUTTER - RIGHT) / (to - from);
    const bottom = lanes.bottom;
    let out = axis(bottom) + marks(bottom);
    const painters = { frames: drawFrames, state: drawState, value: drawValue, timers: drawTimers };
    for (const lane of lanes) {
      if (lane.kind === "head") {
        out += `<line class="rule" x1="0" x2="${width}" y1="${lane.y + 2}" y2="${lane.y + 2}"/>`;
        out += `<text class="head" x="0" y="${lane.y + 19}">${esc(lane.label)}</text>`;
        out += `<text class="small muted" text-anchor="end" x="${GUTTER - 10}" y="${lane.y + 19}">${esc(lane.note)}</text>`;
        continue;
      }
      const middle = lane.y + lane.height / 2 + (lane.note ? -1 : 4);
      out += `<text x="10" y="${middle}">${esc(lane.label)}</text>`;
      if (lane.note) out += `<text class="small muted" x="10" y="${middle + 13}">${esc(lane.note)}</text>`;
      out += painters[lane.kind](lane);
    }
    out += `<line class="cross" id="cross" y1="${TOP - 6}" y2="${bottom}" x1="-9" x2="-9"/>`;
    $("diagram").innerHTML = `<svg height="${bottom + AXIS}" viewBox="0 0 ${width} ${bottom + AXIS}" role="img">${out}</svg>`;
  }
  function redraw() {
    if (!queued) requestAnimationFrame(draw);
    queued = true;
  }

  // ---- choosing what to look at ------------------------------------------------------------------------------------
  function measurement() {
    const found = run.expectations.find(e => e.measurement);
    return found ? found.measurement : null;
  }
  function look(begin, end) {
    const least = 20e3, span = Math.max(least, Math.min(run.duration_ns, end - begin));
    from = Math.max(0, Math.min(run.duration_ns - span, begin));
    to = from + span;
    redraw();
  }
  function zoom(factor, centre) {
    const middle = centre === undefined ? (from + to) / 2 : centre;
    look(middle - (middle - from) * factor, middle + (to - middle) * factor);
  }
  function aroundFault() {
    const m = measurement(), fault = run.events.find(e => e.kind === "fault");
    if (!fault) return look(0, run.duration_ns);
    const begin = m && m.reference_ns !== null ? Math.min(fault.at_ns, m.reference_ns) : fault.at_ns;
    const end = m && m.reference_ns !== null ? m.reference_ns + Math.min(m.limit_ns, Math.max(m.elapsed_ns, m.limit_ns / 20) * 3) : fault.at_ns;
    const span = Math.max(30e6, end - begin);
    look(begin - span * 0.7, end + span * 0.5);
  }
  function describe() {
    $("run-title").textContent = run.title || run.scenario;
    $("run-text").textContent = run.description;
    const m = measurement();
    $("measure").innerHTML = !m ? "" : m.elapsed_ns === null
      ? `<span class="pill bad">not safe</span> limit <b>${limitText(m)}</b>`
      : `<span class="pill ${m.holds ? "good" : "bad"}">${m.holds ? "in time" : "TOO LATE"}</span> ` +
        `safe after <b>${duration(m.elapsed_ns)}</b> of <b>${limitText(m)}</b> (limit: ${esc(m.limit_class.replace(/_/g, " "))})` +
        `${m.closed_by_another_fault ? ", <b>closed by another fault</b>" : ""}; ` +
        `detected by <b>${esc(m.detected_by.replace(/_/g, " "))}</b>: ${esc(m.detection_cause.replace(/_/g, " "))}, at ${esc(m.node)} SRDO ${m.srdo}`;
    $("expectations").innerHTML = run.expectations.map(e =>
      `<li class="${e.holds ? "" : "failed"}">${esc(e.wanted)}: <b>${esc(e.seen)}</b></li>`).join("") || "<li>none</li>";
    const told = run.managers.flatMap(m => m.events.filter(e => e.text).map(e =>
      ({ kind: "manager", at_ns: e.t_us * 1e3, node: m.name, text: e.text })));
    $("timeline").innerHTML = [...run.events, ...told].filter(e => e.kind !== "reception").sort((a, b) => a.at_ns - b.at_ns).map(e =>
      `<li class="${LOUD.has(e.kind) ? "loud" : ""}" data-at="${e.at_ns}" data-kind="${e.kind}"><time>${at(e.at_ns)}</time><em>${esc(e.node || "bus")}</em>` +
      `<span>${esc(e.text)}</span></li>`).join("");
    $("places").innerHTML = ["bus", ...run.nodes.map(n => n.name), ...run.managers.map(m => m.name)].map(n =>
      `<button data-place="${esc(n)}" aria-pressed="${!hidden.has(n)}">${esc(n)}</button>`).join(" ");
    $("fault").style.display = run.faults.length ? "" : "none";
  }
  function pick(index) {
    run = DATA.runs[index];
    document.querySelectorAll("tr[data-run]").forEach(row => row.classList.toggle("picked", +row.dataset.run === index));
    buildLanes();
    describe();
    aroundFault();
    const first = $("timeline").querySelector("[data-kind=fault]");
    $("timeline").scrollTop = first ? first.offsetTop - 60 : 0;
  }

  // ---- hands -------------------------------------------------------------------------------------------------------
  const diagram = $("diagram"), box = $("tip");
  const timeAt = event => { // The drawing may be wider than its frame, and scrolled.
    const area = diagram.querySelector("svg").getBoundingClientRect();
    return from + ((event.clientX - area.left) * (width / area.width) - GUTTER) / scale;
  };
  diagram.addEventListener("wheel", event => {
    event.preventDefault();
    if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) return look(from + event.deltaX / scale, to + event.deltaX / scale);
    zoom(event.deltaY > 0 ? 1.25 : 0.8, Math.max(from, Math.min(to, timeAt(event))));
  }, { passive: false });
  let grip = null;
  diagram.addEventListener("pointerdown", event => {
    grip = { x: event.clientX, from, to };
    diagram.setPointerCapture(event.pointerId);
    diagram.classList.add("moving");
  });
  const letGo = () => { grip = null; diagram.classList.remove("moving"); };
  diagram.addEventListener("pointerup", letGo);
  diagram.addEventListener("pointercancel", letGo);
  diagram.addEventListener("pointermove", event => {
    if (grip) {
      const shift = (grip.x - event.clientX) / scale;
      box.style.display = "none";
      return look(grip.from + shift, grip.to + shift);
    }
    const time = timeAt(event), cross = $("cross");
    if (time < from || time > to) { box.style.display = "none"; return; }
    if (cross) { cross.setAttribute("x1", X(time)); cross.setAttribute("x2", X(time)); }
    const target = document.elementFromPoint(event.clientX, event.clientY);
    let text = target && target.dataset ? target.dataset.tip || "" : "";
    if (target && target.dataset && target.dataset.timer) {
      const lane = lanes.find(l => String(l.y) === target.dataset.timer);
      const left = (list, full) => { const s = list.find(([a, , b]) => time >= a && time <= b); return s ? duration((s[1] + (s[3] - s[1]) * (time - s[0]) / Math.max(1, s[2] - s[0])) * full) : null; };
      const sct = left(lane.lines.sct, lane.srdo.sct_ms * 1e6), srvt = left(lane.lines.srvt, lane.srdo.srvt_ms * 1e6);
      text = [sct && "SCT: " + sct + " left", srvt && "SRVT: " + srvt + " left"].filter(Boolean).join("\n") || "no pair held";
    }
    box.textContent = (text ? text + "\n" : "") + "pointer at " + at(time);
    box.style.display = "block";
    box.style.left = Math.min(event.clientX + 14, innerWidth - box.offsetWidth - 8) + "px";
    box.style.top = Math.min(event.clientY + 16, innerHeight - box.offsetHeight - 8) + "px";
  });
  diagram.addEventListener("pointerleave", () => { box.style.display = "none"; });
  document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const span = to - from;
    const keys = { ArrowLeft: () => look(from - span / 8, to - span / 8), ArrowRight: () => look(from + span / 8, to + span / 8),
      "+": () => zoom(0.7), "=": () => zoom(0.7), "-": () => zoom(1.4), "0": () => look(0, run.duration_ns), f: aroundFault };
    if (keys[event.key]) { keys[event.key](); event.preventDefault(); }
  });
  $("whole").onclick = () => look(0, run.duration_ns);
  $("fault").onclick = aroundFault;
  $("in").onclick = () => zoom(0.7);
  $("out").onclick = () => zoom(1.4);
  $("places").onclick = event => {
    const place = event.target.dataset.place;
    if (!place) return;
    if (!hidden.delete(place)) hidden.add(place);
    event.target.setAttribute("aria-pressed", !hidden.has(place));
    buildLanes();
    redraw();
  };
  $("timeline").onclick = event => {
    const item = event.target.closest("li");
    if (item) look(+item.dataset.at - (to - from) / 2, +item.dataset.at + (to - from) / 2);
  };
  document.querySelectorAll("tr[data-run]").forEach(row => {
    row.onclick = () => pick(+row.dataset.run);
    row.onkeydown = event => { if (event.key === "Enter") pick(+row.dataset.run); };
  });
  new ResizeObserver(redraw).observe(diagram);
  const wanted = parseInt(location.hash.slice(1), 10);
  pick(wanted > 0 && wanted < DATA.runs.length ? wanted : DATA.first || 0);
})();
