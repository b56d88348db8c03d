// What is asked when; faults at their fields; files opened.

const QUICK = 60; // ms of a coarse answer that leaves time for more
const REST = 150; // ms without a change after which the full answers are computed
const SLOW = ["critical_speed", "track_response", "dispersion", "contour"];

const state = { title: "My ground", source: "", layers: [], base: "rigid", track: {}, train: {}, count: "1", speed: "250", from: "36", to: "720" };
const layers = new Layers(get("layers"), get("base"), () => {
  state.edited = true;
  get("soils").value = "";
  changed();
});
let asking, resting;
// what stands on the page: of each study the case text and its full answer; the case text of the coarse curve, and its time [ms]
const shown = { took: 0 };

// Something was changed: coarse answers now, full ones when it rests.
function changed() {
  get("case").textContent = caseText(state, SLOW);
  get("save").href = `data:application/toml;charset=utf-8,${encodeURIComponent(get("case").textContent)}`;
  follow();
  get("state").textContent = "computing";
  delete document.body.dataset.settled;
  clearTimeout(resting);
  resting = setTimeout(rest, REST);
  // the curve does not change with the line speed, and a rail is quick enough to be told in full at once
  const curve = caseText({ ...state, speed: "" }, ["critical_speed"], true);
  const studies = curve === shown.curve ? ["track_response"] : shown.took < QUICK ? ["critical_speed", "track_response"] : ["critical_speed"];
  const speed = parseSpeed(state.speed), rail = caseText(state, ["track_response"]), since = performance.now();
  asking.ask({ ask: "solve", case: caseText(state, studies, true) }, (reply) => {
    if (!judged(reply)) return;
    shown.took = performance.now() - since;
    show(reply, speed, true);
    if (studies[0] === "critical_speed") Object.assign(shown, { curve, critical_speed: undefined });
    if (studies.includes("track_response")) shown.track_response = { text: rail, told: reply.studies.track_response };
    get("state").textContent = "coarse, while you move";
  });
}

// Every full answer that is not there yet, one study after the other, so that a change never waits long.
function rest() {
  clearTimeout(resting);
  if (asking.running) return (resting = setTimeout(rest, 10));
  const study = SLOW.find((name) => shown[name]?.text !== caseText(state, [name]));
  if (!study || get("shown").dataset.faulty) return settled(!study);
  const text = caseText(state, [study]), speed = parseSpeed(state.speed);
  asking.ask({ ask: "solve", case: text }, (reply) => {
    if (!judged(reply, study)) return settled(false);
    show(reply, speed, false);
    shown[study] = { text, told: reply.studies[study] };
    resting = setTimeout(rest, 0);
  }, true);
}

function settled(whole) {
  if (whole) get("state").textContent = "";
  document.body.dataset.settled = whole ? "whole" : "faulty";
}

// Shows the faults of a reply at their fields; true if there is none.
function judged({ faults = [], failed }, study) {
  for (const place of document.querySelectorAll(".fault")) place.remove();
  for (const field of document.querySelectorAll("[aria-invalid]")) {
    field.removeAttribute("aria-invalid");
    field.removeAttribute("aria-describedby");
  }
  const elsewhere = failed ? [{ message: failed }] : [];
  faults.forEach((fault, i) => {
    const field = fieldOf(fault.key);
    if (!field) return elsewhere.push(fault);
    const told = node("p", { class: "fault", id: `fault-${i}` }, said(fault));
    const holder = field.closest("li, .layer, .slide, .row, .pick, .small") ?? field;
    if (holder.matches("li, .layer")) holder.append(told);
    else holder.after(told);
    field.setAttribute("aria-invalid", "true");
    field.setAttribute("aria-describedby", told.id);
  });
  get("faults").hidden = elsewhere.length === 0;
  get("faults").replaceChildren(...elsewhere.map((fault) => node("p", {}, said(fault))));
  const faulty = faults.length > 0 || failed !== undefined;
  if (faulty) get("shown").dataset.faulty = study ?? "all";
  else delete get("shown").dataset.faulty;
  if (faulty) {
    get("state").textContent = faults.length ? "not answered: see the fault beside its field" : "not answered";
    document.body.dataset.settled = "faulty";
  }
  return !faulty;
}

const said = ({ message, help }) => (help ? `${message} (${help})` : message);

// The field of a key, or that of the table around it.
function fieldOf(key) {
  const fields = [...document.querySelectorAll("[data-keys]")], steps = key.split(/(?=[.[])/);
  for (let count = steps.length; count > 0; count--) {
    const path = steps.slice(0, count).join("");
    const field = fields.find((one) => one.dataset.keys.split(" ").includes(path));
    if (field) return field;
  }
  return null;
}

// The answers to a case at `speed` [km/h], each in its place.
function show({ studies, concerns, axles }, speed, coarse) {
  for (const [name, study] of Object.entries(studies)) VIEWS[name](study, { concerns, axles, speed, coarse });
}

// km/h of a speed as it is typed; NaN of what is none
function parseSpeed(text) {
  const [, number, unit] = /^\s*([\d.]+)\s*(km\/h|m\/s)?\s*$/.exec(text) ?? [];
  return Number(number) * (unit === "m/s" ? KMH : 1);
}

// The other unit beside every speed.
function follow() {
  const metres = (text) => (isNaN(parseSpeed(text)) ? "" : `${digits(parseSpeed(text) / KMH)} m/s`);
  get("speed-too").textContent = metres(state.speed);
  get("range-too").textContent = [state.from, state.to].map(metres).filter(Boolean).join(" to ");
  const speed = parseSpeed(state.speed);
  if (speed > 0) get("speed-slider").value = speed;
  get("speed-slider").setAttribute("aria-valuetext", `${state.speed} km/h`);
}

function fields() {
  for (const id of ["speed", "from", "to", "count"]) get(id).value = state[id];
  for (const id of ["track", "train"]) {
    get(id).querySelector("[value='']")?.remove();
    if (state[id].toml) get(id).prepend(node("option", { value: "" }, "as in the opened file"));
    get(id).value = state[id].name ?? "";
  }
  get("count").disabled = state.train.toml !== undefined;
  layers.show(state);
}

// A case file as the page's state.
function open(text, name) {
  asking.ask({ ask: "open", case: text, name }, ({ faults, failed, ...file }) => {
    const told = (...inside) => get("opened").replaceChildren(...inside);
    if (faults || failed) {
      const wrong = faults ?? [{ message: failed }];
      const one = (fault) => node("li", {}, `${fault.line ? `line ${fault.line}: ` : ""}${said(fault)}`);
      told(node("p", {}, `${name} was not opened, and nothing here has changed:`), node("ul", { class: "faults" }, ...wrong.map(one)));
      // it may have stopped a full answer
      return rest();
    }
    const exact = (v) => String(tidy(KMH * v));
    Object.assign(state, profileState(file.soil), { title: file.title, source: file.source ?? "", track: file.track, train: file.train, count: "1", edited: false });
    get("soils").value = "";
    if (file.speeds) [state.from, state.to] = file.speeds.map(exact);
    if (file.speed) state.speed = exact(file.speed);
    const left = file.left.length ? ` The page has no place for ${file.left.join(", ")}, and leaves it out.` : "";
    told(node("p", {}, `${name} is open.${left}`));
    fields();
    changed();
  });
}

async function read(file) {
  if (file.size > 1e6) return get("opened").replaceChildren(node("p", { class: "faults" }, `${file.name} has ${digits(file.size / 1e6)} MB: that is no case file`));
  open(await file.text(), file.name);
}

function listen(library) {
  const option = ({ name, title }) => node("option", { value: name }, title);
  get("soils").append(node("option", { value: "" }, "the layers below"), ...library.soils.map(option));
  get("track").append(...library.tracks.map(option));
  get("train").append(...library.vehicles.map(option));
  get("version").textContent = library.version;
  const soilOf = (name) => library.soils.find((soil) => soil.name === name);
  const take = (name) => {
    Object.assign(state, profileState(soilOf(name).soil), { title: soilOf(name).title, source: soilOf(name).source, edited: false });
    // critical speeds lie at 1.1 to 1.4 times the slowest shear wave speed in all published cases
    const slowest = Math.min(...[...state.layers, state.base].map((m) => m.shear_speed ?? Infinity));
    state.to = String(Math.min(720, 20 * Math.round((2.5 * KMH * slowest) / 20)));
    fields();
  };
  get("soils").onchange = ({ target }) => target.value && (take(target.value), changed());
  for (const id of ["track", "train"]) {
    get(id).onchange = ({ target }) => target.value && ((state[id] = { name: target.value }), fields(), changed());
  }
  for (const id of ["speed", "from", "to", "count"]) get(id).oninput = ({ target }) => ((state[id] = target.value), changed());
  get("speed-slider").oninput = ({ target }) => ((state.speed = get("speed").value = target.value), changed());
  get("add").onclick = () => layers.add();
  get("form").onsubmit = (event) => event.preventDefault();
  get("open").onchange = ({ target }) => target.files[0] && read(target.files[0]).then(() => (target.value = ""));
  document.ondragover = (event) => event.preventDefault();
  document.ondrop = (event) => {
    event.preventDefault();
    if (event.dataTransfer.files[0]) read(event.dataTransfer.files[0]);
  };
  Object.assign(state, { track: { name: "lamprea2022_ballasted" }, train: { name: "lamprea2022_axle" } });
  take("lamprea2022_layered");
  changed();
}

compiled().then(
  (module) => {
    asking = new Asking(module);
    asking.ask({ ask: "library" }, listen);
  },
  (error) => (get("state").textContent = `this browser cannot run the program: ${error.message}`),
);
