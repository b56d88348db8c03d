// The state of the page as a case file, and back.

// What a field says: a number as it is, anything else in quotes, for the program to judge.
const written = (text) => (/^[+-]?(0|[1-9]\d*)(\.\d+)?([eE][+-]?\d+)?$/.test(text) ? text : JSON.stringify(text));
const line = (key, text) => (String(text).trim() === "" ? "" : `${key} = ${written(String(text).trim())}\n`);
// km/h where no unit is given
const speed = (text) => (/^[+-]?[\d.]+$/.test(String(text).trim()) ? `${String(text).trim()} km/h` : String(text).trim());
const range = (from, to, step) => {
  const part = (key, text) => (text === "" ? [] : [`${key} = ${written(text)}`]);
  return `{ ${[...part("from", from), ...part("to", to), `step = "${step} km/h"`].join(", ")} }`;
};

const words = (key, text) => (text ? `${key} = ${JSON.stringify(text)}\n` : "");

function material({ name, shear_speed, poisson, density, damping }) {
  return words("name", name) + line("shear_speed", shear_speed) + line("poisson", poisson) + line("density", density) + line("damping_ratio", ratio(damping));
}

// 3 % is 0.03, and what is no number stays as it is
function ratio(percent) {
  const text = String(percent).trim();
  return text === "" || isNaN(Number(text)) ? text : String(Number((Number(text) / 100).toPrecision(15)));
}

function soil({ layers, base }) {
  const rigid = base === "rigid" ? 'base = "rigid"\n' : "";
  return `[soil]\n${rigid}` + layers.map((layer) => `[[soil.layer]]\n${line("thickness", layer.thickness)}${material(layer)}`).join("") +
    (base && !rigid ? `[soil.half_space]\n${material(base)}` : "");
}

function train({ train, count }) {
  if (train.toml) return train.toml;
  return String(count).trim() === "1" ? "" : `[train]\nvehicle = "${train.name}"\n${line("count", count)}`;
}

// About `count` speeds over the range, in steps of 1, 2, 5 or 10 km/h and so on; what is no range is left to the program.
function steps(from, to, count) {
  const step = Math.max((parseFloat(to) - parseFloat(from)) / count, 0.1) || 5;
  const power = 10 ** Math.floor(Math.log10(step));
  return Number((power * [1, 2, 5, 10].find((n) => n * power >= 0.999 * step)).toPrecision(6));
}

const STUDIES = {
  critical_speed: (s, coarse) =>
    `[critical_speed]\nspeeds = ${range(speed(s.from), speed(s.to), steps(s.from, s.to, coarse ? 14 : 90))}\n` +
    line("line_speed", speed(s.speed)) + `accuracy = ${coarse ? "1e-2" : "1e-3"}\n`,
  dispersion: () => "[dispersion]\nfrequencies = { from = 1.0, to = 80.0, step = 1.0 }\n",
  track_response: (s) => `[track_response]\nspeeds = [${written(speed(s.speed))}]\n`,
  contour: (s) => `[contour]\nspeeds = [${written(speed(s.speed))}]\nx = { from = -40.0, to = 20.0 }\ny = { from = -20.0, to = 20.0 }\nspacing = 0.5\n`,
};

// The case that asks `studies`: coarse while a slider moves.
function caseText(state, studies, coarse = false) {
  const named = (key, part) => (part.name ? `${key} = "${part.name}"\n` : "");
  const single = !state.train.toml && String(state.count).trim() === "1";
  // what was changed is not what the source says
  const said = (text) => text && (state.edited ? `changed from: ${text}` : text);
  return words("title", state.title + (state.edited ? ", changed" : "")) + words("source", said(state.source)) +
    named("track", state.track) + (single ? named("train", state.train) : "") + "\n" +
    [soil(state), state.track.toml ?? "", train(state), ...studies.map((study) => STUDIES[study](state, coarse))].filter(Boolean).join("\n");
}

// A material of the program as fields show it.
const shownMaterial = (m) => ({ name: m.name, shear_speed: m.shear_speed, poisson: m.poisson, density: m.density, damping: tidy(100 * m.damping_ratio) });
const tidy = (value) => Number(value.toPrecision(12));

function profileState({ layers, half_space }) {
  return {
    layers: layers.map((layer) => ({ thickness: layer.thickness, ...shownMaterial(layer) })),
    base: half_space ? shownMaterial(half_space) : "rigid",
  };
}
