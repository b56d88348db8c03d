// What is shown of the answers of each study.

const KMH = 3.6;
const get = (id) => document.getElementById(id);
const plots = Object.fromEntries(["curve", "waves", "rail", "ground"].map((id) => [id, new Plot(get(id))]));

const headline = (shown) => {
  const [, large, rest] = /^(\d+ km\/h) \((.*)\)$/.exec(shown) ?? [];
  return large ? [large, node("small", {}, ` ${rest}`)] : [node("small", {}, shown)];
};

const kmh = (speeds) => speeds.map((v) => KMH * v);
const mm = (values) => values.map((u) => (u === null ? null : 1e3 * u));
const reach = (values, share = 0.06) => {
  const there = values.filter((v) => v !== null && isFinite(v));
  const [low, high] = [Math.min(0, ...there), Math.max(...there)];
  return { from: low < 0 ? low - share * (high - low) : 0, to: high + share * (high - low) || 1 };
};
const both = (v) => `${digits(v)} km/h (${digits(v / KMH)} m/s)`;
const second = { factor: 1 / KMH, label: "speed [m/s]" };

const VIEWS = {
  critical_speed({ arrays, answers, concerns }, { concerns: others, speed, coarse }) {
    const critical = answers[0];
    get("what").textContent = critical.what;
    get("number").replaceChildren(...headline(critical.shown));
    get("number").dataset.value = critical.value;
    get("answers").replaceChildren(...answers.flatMap(({ what, shown }) => [node("dt", {}, what), node("dd", {}, shown)]));
    get("doubts").replaceChildren(...[...others, ...concerns].map((c) => node("li", {}, `${c.message}: ${c.remedy}`)));
    get("doubts-head").hidden = others.length + concerns.length === 0;
    const x = kmh(arrays.speed), down = mm(arrays.max_down), alone = arrays.single_axle_max_down;
    const series = [
      ...(alone ? [{ name: "heaviest axle alone, downward", x, y: mm(alone) }] : []),
      { name: alone ? "this train, downward" : "largest downward", x, y: down, dash: alone && "9 4" },
      { name: alone ? "this train, upward" : "largest upward", x, y: mm(arrays.max_up), dash: "2 3" },
    ];
    const marks = [{ at: KMH * critical.value, name: "critical speed" }].filter(() => /^\d/.test(critical.shown));
    marks.push({ at: speed, name: "line speed" });
    plots.curve.draw({
      title: `Largest rail deflection against speed${coarse ? " (coarse)" : ""}`, told: `${critical.what}: ${critical.shown}.`,
      x: { from: x[0], to: x.at(-1), label: "speed [km/h]", second }, y: { ...reach(series.flatMap((s) => s.y)), label: "deflection [mm]" }, series, marks,
      read: (at) => {
        const i = nearest(x, at);
        return [x[i], `${both(x[i])}: ${series.map((s) => `${s.name} ${digits(s.y[i])} mm`).join(", ")}`];
      },
    });
  },

  dispersion({ arrays, answers }) {
    const { frequency: x, mode, phase_velocity: speeds, track_phase_velocity: track } = arrays;
    const ground = mode.map((_, j) => ({ name: j === 0 ? "waves of the ground, undisturbed" : "", x, y: x.map((_, i) => speeds[i * mode.length + j]) }));
    const one = { name: ground[0].name, x: ground.flatMap((g) => [...g.x, g.x[0]]), y: ground.flatMap((g) => [...g.y, null]) };
    const crossing = answers.find((a) => a.key === "crossing_speed");
    const series = [one, ...(track ? [{ name: "wave of the track alone", x, y: track, dash: "9 4" }] : [])];
    if (crossing) series.push({ name: "where they meet", x: [answers[1].value], y: [crossing.value], dots: true });
    const most = Math.max(...one.y.filter((v) => v !== null), 1);
    plots.waves.draw({
      title: "Waves of ground and of track, apart",
      told: crossing ? `${crossing.what}, ${crossing.shown} at ${answers[1].shown}.` : "The two do not meet at these frequencies.",
      x: { from: x[0], to: x.at(-1), label: "frequency [Hz]" }, y: { from: 0, to: 1.15 * most, label: "phase speed [m/s]" }, series,
      read: (at) => {
        const i = nearest(x, at), there = (v) => (v === null || v === undefined ? "none" : `${both(KMH * v)}`);
        return [x[i], `${digits(x[i])} Hz: first wave of the ground ${there(speeds[i * mode.length])}, of the track ${there(track?.[i])}`];
      },
    });
  },

  track_response({ arrays }, { axles, speed }) {
    const { x, rail, base } = arrays;
    const series = [{ name: "rail", x, y: mm(rail) }, { name: "ground under the track", x, y: mm(base), dash: "9 4" }];
    plots.rail.draw({
      title: `Rail at ${both(speed)}`, told: "The train runs to the right; dots are its axles.",
      x: { from: x[0], to: x.at(-1), label: "distance ahead of the leading axle [m]" }, y: { ...reach(series.flatMap((s) => s.y)), down: true, label: "deflection, down [mm]" },
      series: [...series, { name: "axles", x: axles.map((a) => axles[0][0] - a[0]), y: axles.map(() => 0), dots: true }],
      read: (at) => {
        const i = nearest(x, at);
        return [x[i], `at ${digits(x[i])} m: rail ${digits(1e3 * rail[i])} mm, ground ${digits(1e3 * base[i])} mm, downward`];
      },
    });
  },

  contour({ arrays }, { axles, speed }) {
    const { x, y, ...fields } = arrays;
    const values = fields[Object.keys(fields).find((name) => fields[name].length === x.length * y.length)];
    const largest = values.reduce((most, u) => Math.max(most, Math.abs(u)), 0);
    const half = 0.5 * (x[1] - x[0]);
    plots.ground.draw({
      title: `Ground at ${both(speed)}`, told: "Seen from above: vertical displacement; the train runs to the right, its leading axle at 0.", equal: true,
      x: { from: x[0] - half, to: x.at(-1) + half, label: "distance ahead of the leading axle [m]" }, y: { from: y[0] - half, to: y.at(-1) + half, label: "across [m]" },
      field: { values, columns: x.length, rows: y.length, largest, scale: 1e3, unit: "mm" },
      series: [{ name: "", x: axles.map((a) => axles[0][0] - a[0]).filter((at) => at >= x[0]), y: axles.map(() => 0), dots: true }],
      read: (at, across) => {
        const i = nearest(x, at), j = nearest(y, across);
        return [x[i], `${digits(x[i])} m ahead, ${digits(y[j])} m across: ${digits(1e3 * values[j * x.length + i])} mm downward`];
      },
    });
  },
};
