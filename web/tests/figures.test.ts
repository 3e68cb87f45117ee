import { describe, expect, it } from "vitest";
import { heightsOf, tick } from "../src/plots/chart";
import { coloursOf, DrawnLine } from "../src/plots/drawn";
import { Figures, MOST_LINES, titleAndLabels } from "../src/plots/figures";
import { hasWords, labelOf, linesOf } from "../src/plots/lines";
import { statisticsOf } from "../src/plots/statistics";
import { decimalsFor, shownUnit } from "../src/plots/units";
import { defaultView, MOST_PLOTS, plotOf, viewOf } from "../src/plots/view";
import { FOLLOWING, isWindow, stretchOf } from "../src/plots/window";
import { Columns } from "../src/engine/columns";
import { readModel } from "../src/engine/engine";
import type { Channel, LimitInfo } from "../src/engine/engine";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { channelOf, CHANNELS, FakeEngine } from "./fake";
import { filesOf, gallery, initEngine, read } from "./gallery";
import { opened } from "./opened";

await initEngine();
const fixedShip = readModel(new FakeEngine().model_json());
const described = { ...fixedShip, joints: fixedShip.joints.map((joint) => ({ ...joint, free_coordinates: ["ship.yaw"] })) };
const WRENCH = ["force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"];
const wrench = (variable: string, thing: string): Channel => channelOf(variable, ["joint", "component"], [[thing], WRENCH], ["N", "N", "N", "N m", "N m", "N m"]);

describe("lines that can be drawn", () => {
  it("every column except the time can be drawn in its unit, and derived lines", () => {
    const channels = [...CHANNELS.slice(0, 8), wrench("joint_reaction", "pendant"), channelOf("valve_flow", ["valve"], [["main"]], ["m^3/s"])];
    const figures = new Figures(described, channels);
    const columns = channels.flatMap((channel) => channel.columns).filter((name) => name !== "time");
    expect(figures.lines.map(({ id }) => id)).toEqual([...columns, ["x", "y", "z"].map((axis) => `pendant.joint_reaction.force_${axis}`).join("+")]);
    expect(figures.line("pendant.joint_reaction.moment_y")).toMatchObject({ thing: "pendant", what: "joint reaction moment y", unit: "N m" });
    expect(figures.line("main.valve_flow")).toMatchObject({ thing: "main", unit: "m^3/s" });
    expect(labelOf(figures.line("kinetic_energy")!)).toBe("kinetic energy");
    expect([figures.line("ship.yaw")!.wraps, figures.line("ship.angular_velocity.z")!.wraps]).toEqual([true, false]);
  });

  it.each(gallery)("has a unique legend label without a word repeated in succession: %s", async (name) => {
    const { run } = await opened(name);
    const labels = linesOf(run.model, run.channels).map(labelOf);
    expect(labels.length).toBeGreaterThan(10);
    expect(new Set(labels).size).toBe(labels.length);
    expect(labels.filter((label) => /\b(\w+) \1\b/.test(label))).toEqual([]);
  });

  it("does not repeat in a label a word that the element's name contains", () => {
    const said = (thing: string, variable: string) => labelOf(new Figures(described, [channelOf(variable, ["thing"], [[thing]], ["N"])]).lines[0]);
    expect(said("main_line", "line_tension")).toBe("main line tension");
    expect(said("line_2", "line_tension")).toBe("line 2 tension");
    expect(said("main", "line_tension")).toBe("main line tension");
  });

  it("a search finds a line by words of its name or description, in any order", () => {
    const [line] = new Figures(described, [channelOf("daf", ["thing"], [["hoist"]], ["1"])]).lines;
    expect(["hoist", "DAF hoist", "hoist.daf", ""].every((words) => hasWords(line, words))).toBe(true);
    expect(hasWords(line, "hoist roll")).toBe(false);
    expect(hasWords({ ...line, about: "tension over weight" }, "weight")).toBe(true);
  });

  it("each hull has a plot of its heave with the wave elevation", () => {
    const hull = { name: "water", body: "ship", origin_m: [0, 0, 1.5] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, is_linear: true, mesh: null };
    const channels = [channelOf("position", ["body", "axis"], [["ship"], ["x", "y", "z"]], ["m"]), channelOf("wave_elevation", ["hull"], [["water"]], ["m"])];
    const figures = new Figures({ ...described, hulls: [hull] }, channels);
    const heave = figures.all.find(({ title }) => title === "Heave of ship")!;
    expect(heave.labels).toEqual(["Heave", "Wave"]);
    expect(heave.lines.map(({ columns, offset }) => [columns[0], offset ?? 0])).toEqual([["ship.position.z", 1.5], ["water.wave_elevation", 0]]);
    // A single hull shows heave by default.
    expect(figures.defaults()).toEqual([heave.lines.map(({ id }) => id), ["ship.velocity.z"]]);
  });

  it("the plots that a scenario names come first, without columns that are not there", () => {
    const view = { camera: "", plots: [["ship.velocity.z", "nonesuch"], ["nonesuch"]] };
    const channels = [channelOf("velocity", ["body", "axis"], [["ship"], ["x", "y", "z"]], ["m/s"])];
    expect(new Figures({ ...described, view }, channels).defaults()).toEqual([["ship.velocity.z"]]);
  });

  it("forces and moments are in separate groups with short labels", () => {
    const figures = new Figures(described, [wrench("excitation_force", "water")]);
    expect(figures.all.map(({ title, labels }) => [title, labels])).toEqual([
      ["water: excitation force (N)", ["x", "y", "z"]],
      ["water: excitation force (N m)", ["moment x", "moment y", "moment z"]],
    ]);
  });

  it("a plot has the title of its group, otherwise the name that its lines have in common", () => {
    const figures = new Figures(described, CHANNELS);
    const lines = (...ids: string[]) => ids.map((id) => figures.line(id)!);
    const rates = ["y", "z", "x"].map((axis) => `ship.angular_velocity.${axis}`);
    expect(titleAndLabels(lines(...rates), figures.ofLines(rates))).toMatchObject({ title: "Rates of ship", labels: ["Pitch", "Yaw", "Roll"] });
    expect(titleAndLabels(lines("ship.roll", "ship.yaw"), figures.ofLines(["ship.roll", "ship.yaw"]))).toEqual({ title: "ship", labels: ["roll", "yaw"] });
    expect(titleAndLabels(lines("ship.roll", "kinetic_energy"), undefined).title).toBe("ship roll, kinetic energy");
  });
});

describe("units", () => {
  it("angles are shown in degrees, and forces, energies and powers in thousands", () => {
    const shown = ["rad", "rad/s", "rad/s^2", "N", "N m", "J", "W", "m", "m^3/s", "1", "N m/rad"].map((unit) => shownUnit(unit, "deg").unit);
    expect(shown).toEqual(["°", "°/s", "°/s²", "kN", "kN m", "kJ", "kW", "m", "m³/s", "", "N m/rad"]);
    expect(["rad", "rad/s"].map((unit) => shownUnit(unit, "deg").scale)).toEqual([180 / Math.PI, 180 / Math.PI]);
    expect(shownUnit("rad/s", "rad")).toEqual({ unit: "rad/s", scale: 1, decimals: 5 });
  });

  it("small numbers have more decimals", () => {
    const angle = shownUnit("rad", "deg");
    expect([20, 0.02, 2e-5, 0, 1e-30, NaN].map((largest) => decimalsFor(angle, largest))).toEqual([2, 4, 7, 2, 9, 2]);
  });
});

describe("a drawn line", () => {
  const limit = (at_least: number | null, at_most: number | null): LimitInfo => ({ name: "most_heel", column: "ship.roll", unit: "deg", unit_si: Math.PI / 180, at_least, at_most, from_s: 7, until_s: null, steps: [], percentile: 100 });
  const figures = new Figures(described, CHANNELS);
  const drawn = (id: string, limits: LimitInfo[]) => new DrawnLine(figures.line(id)!, "", "roll", new Columns(CHANNELS), "deg", limits);

  it("a drawn line has the limits of its column in the displayed unit", () => {
    const { bounds } = drawn("ship.roll", [limit(-5, 3)]);
    expect(bounds.map(({ name, value, from_s }) => [name, Number(value.toFixed(12)), from_s])).toEqual([["most heel", -5, 7], ["most heel", 3, 7]]);
    expect(drawn("ship.pitch", [limit(-5, 3)]).bounds).toEqual([]);
    expect(drawn("ship.roll", [limit(null, 3)]).bounds.length).toBe(1);
  });

  it("a drawn line has the colour of its axis of rotation, or another if it is taken", () => {
    const lines = ["ship.roll", "ship.angular_velocity.x", "ship.pitch", "kinetic_energy"].map((id) => figures.line(id)!);
    expect(coloursOf(lines)).toEqual(["roll", "yaw", "pitch", "line-4"]);
    const many = Array.from({ length: MOST_LINES }, () => figures.line("kinetic_energy")!);
    expect(new Set(coloursOf(many)).size).toBe(MOST_LINES);
  });

  it("numbers on an axis are short", () => {
    expect([0, 20, 100, -0.5, 0.25, 1.000001, 3e-7, -2e-6].map(tick)).toEqual(["0", "20", "100", "−0.5", "0.25", "1.000001", "3.0×10⁻⁷", "−2.0×10⁻⁶"]);
  });

  it("an axis includes a nearby zero, and a limit unless the lines become too small", () => {
    const [low, high] = heightsOf(40, 41, 1e-9, []);
    expect(low).toBeGreaterThan(39.9);
    expect(high).toBeLessThan(41.1);
    expect(heightsOf(1, 3, 1e-9, [])[0]).toBeLessThan(0);
    expect(heightsOf(0, 3, 1e-9, [5])[1]).toBeGreaterThan(5);
    expect(heightsOf(0, 0.1, 1e-9, [5])[1]).toBeLessThan(0.2);
    // A constant value is a horizontal line in the middle.
    const [bottom, top] = heightsOf(2, 2, 1e-9, []);
    expect(bottom).toBeLessThan(2);
    expect(top).toBeGreaterThan(2);
  });
});

describe("default plots", () => {
  /** Scenarios and the duration of their runs, s. A fixed hull does not move, but its crane does. */
  const cases: [string, number][] = [["paper", 1], ["dual_draglink_crane", 1], ["knuckle_boom_crane", 1], ["flexible_boom", 0.5], ["sphere_decay", 2], ["floating_hemisphere", 2], ["tennis_racket", 2], ["chain", 1], ["a_frame_over_the_stern", 2], ["slew_and_land", 40]];

  it.each(cases)("the default plots show motion: %s", async (name, time_s) => {
    const text = read(`scenarios/${name}.yaml`);
    const simulation = new Simulation(text, name, "{}", await filesOf(text));
    const channels = JSON.parse(simulation.channels_json()) as Channel[];
    const columns = new Columns(channels);
    const named = readModel(simulation.model_json());
    const plots = new Figures({ ...named, view: { ...named.view, plots: [] } }, channels).defaults();
    const rows = [simulation.row()];
    for (let i = 0; i < 20; i++) {
      simulation.step(Math.round(time_s / 20 / simulation.step_s()));
      rows.push(simulation.row());
    }
    expect(plots.length).toBe(2);
    for (const lines of plots) {
      const deviations = lines.map((id) => {
        const values = rows.map((row) => row[columns.at(id.replace(".heave", ".position.z"))]);
        return statisticsOf(rows.map((row) => row[0]), values).standard_deviation;
      });
      expect(Math.max(...deviations), `${name}: ${lines.join(", ")}`).toBeGreaterThan(1e-6);
    }
    simulation.free();
  });
});

describe("a stored view", () => {
  const figures = new Figures(described, CHANNELS);

  it("a stored view is read back unchanged", () => {
    const view = { plots: [plotOf(["ship.roll", "kinetic_energy"], "phase"), plotOf([], "arms")], angle: "rad" as const, window: { kind: "last" as const, length_s: 30 } };
    expect(viewOf(JSON.parse(JSON.stringify(view)), figures)).toEqual(view);
    const { plots } = defaultView(figures);
    expect(plots.map(({ lines }) => lines[0])).toEqual(["ship.angular_velocity.y", "ship.pitch"]);
  });

  it("a stored view is read without missing lines and invalid entries", () => {
    const kept = { plots: [{ lines: ["ship.roll", "gone.roll"], kind: "time" }, { lines: ["gone.roll"] }, 7, null], angle: "turns", window: { kind: "between", from_s: 3, to_s: 1 } };
    expect(viewOf(kept, figures)).toEqual({ plots: [plotOf(["ship.roll"])], angle: "deg", window: FOLLOWING });
    expect([viewOf(null, figures), viewOf("x", figures), viewOf({}, figures)]).toEqual([null, null, null]);
    const many = { plots: Array.from({ length: 20 }, () => plotOf(["ship.roll"])) };
    expect(viewOf(many, figures)!.plots.length).toBe(MOST_PLOTS);
  });
});

describe("visible time", () => {
  const extent = { now_s: 100, shown_s: 40, duration_s: 600, window_s: 600 };

  it("the visible time follows the user's choice", () => {
    expect(stretchOf(FOLLOWING, extent)).toEqual([0, 120]);
    expect(stretchOf({ kind: "all" }, extent)).toEqual([0, 100]);
    expect(stretchOf({ kind: "last", length_s: 30 }, extent)).toEqual([10, 40]);
    expect(stretchOf({ kind: "last", length_s: 60 }, extent)).toEqual([0, 60]);
    expect(stretchOf({ kind: "between", from_s: 5, to_s: 7 }, extent)).toEqual([5, 7]);
  });

  it("a choice of time that ends before it begins is not valid", () => {
    const choices: unknown[] = [{ kind: "between", from_s: 2, to_s: 1 }, { kind: "last", length_s: -1 }, { kind: "never" }, null, 3];
    expect(choices.map(isWindow)).toEqual([false, false, false, false, false]);
    expect([{ kind: "all" }, FOLLOWING].every(isWindow)).toBe(true);
  });
});

