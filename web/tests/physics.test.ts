import { beforeAll, describe, expect, it } from "vitest";
import { expectedAmplitudes } from "../src/forecast/sea";
import { Simulation } from "../src/engine/pkg/kingpost_wasm.js";
import { readModel } from "../src/engine/engine";
import type { Hydrostatics, InputInfo } from "../src/engine/engine";
import { Runner } from "../src/engine/runner";
import { closest, crossings, linesOf, valuesOver } from "../src/physics/modes";
import type { NaturalMode } from "../src/physics/modes";
import { isByTimeline, lostWith, releaseOf } from "../src/physics/release";
import { areaOf, armOf, bothSides, lossOf } from "../src/physics/righting";
import type { Arms } from "../src/physics/righting";
import { spectrumOf, wavesOf } from "../src/physics/sea_spectrum";
import { filesOf, initEngine, read } from "./gallery";

const DEGREE = Math.PI / 180;

/** GZ of a wall-sided hull: a sine of twice the heel relative to her equilibrium, every half degree. */
function sine(height_m: number, rest: number): Arms {
  const heel = Array.from({ length: 361 }, (_, k) => (k - 180) * 0.5 * DEGREE);
  return { heel, arm: heel.map((at) => height_m * Math.sin(2 * (at - rest))), rest };
}

describe("righting arms", () => {
  it("righting arms to the other side follow from those to one side, for GZ = GM sin phi - a cos phi", () => {
    const [gm, a] = [1.4, 0.2];
    const arm = (phi: number) => gm * Math.sin(phi) - a * Math.cos(phi);
    const points = Array.from({ length: 13 }, (_, k) => ({ heel_rad: 5 * k * DEGREE, arm_m: arm(5 * k * DEGREE), trim_rad: 0 }));
    const arms = bothSides({ side: "starboard", points, equilibrium_rad: Math.atan(a / gm) });
    arms.heel.forEach((heel, k) => expect(arms.arm[k]).toBeCloseTo(arm(heel), 12));
    // A list to port is the mirror image.
    const port = bothSides({ side: "port", points, equilibrium_rad: Math.atan(a / gm) });
    expect(port.heel.map((heel) => heel + 0)).toEqual(arms.heel);
    port.heel.forEach((heel, k) => expect(port.arm[k]).toBeCloseTo(-arm(-heel), 12));
    expect(port.rest).toBe(-arms.rest!);
  });

  it("the area under righting arms agrees with its formula; 0 if the end is not beyond the start", () => {
    const arms = sine(0.4, 0);
    // The trapezoidal rule with half degrees has an error of the order of its squared step.
    expect(areaOf(arms, 0, 0.7)).toBeCloseTo(0.4 * Math.sin(0.7) ** 2, 5);
    expect(areaOf(arms, 0.3, 0.3)).toBe(0);
    expect(areaOf(arms, 0.3, 0.1)).toBe(0);
    expect(armOf(arms, 2)).toBeNaN();
  });

  it("a ship that loses her load rolls as far beyond her new equilibrium as she was before it", () => {
    const [start, rest] = [0, 0.08];
    const loss = lossOf(sine(0.4, start), sine(0.4, rest), 60 * DEGREE)!;
    // Areas 0.4 sin^2: between the two equilibria, and up to the heel at which the arm is zero again or water enters.
    expect(loss.area_1).toBeCloseTo(0.4 * Math.sin(0.08) ** 2, 5);
    expect(loss.area_2).toBeCloseTo(0.4 * Math.sin(60 * DEGREE - rest) ** 2, 4);
    expect(loss.reach).toBeCloseTo(2 * rest, 4);
    expect(loss.way).toBe(1);
  });

  it("area 2 ends where the righting arm vanishes, and a roll to port counts to port", () => {
    const loss = lossOf(sine(0.4, 0.02), sine(0.4, -0.1), 90 * DEGREE)!;
    expect(loss.way).toBe(-1);
    expect([loss.start, loss.rest]).toEqual([-0.02, 0.1]);
    const early = { ...sine(0.4, -0.1), arm: sine(0.4, -0.1).arm.map((arm, k) => (k < 100 ? 0.01 : arm)) };
    expect(lossOf(sine(0.4, 0.02), early, 90 * DEGREE)!.end).toBeLessThan(90 * DEGREE);
  });

  it("no largest roll is given if the righting arms cannot stop the ship", () => {
    expect(lossOf(sine(0.4, -0.5), sine(0.4, 0.2), 0.3)!.reach).toBeNull();
    expect(lossOf({ ...sine(0.4, 0), rest: null }, sine(0.4, 0.2), 1)).toBeNull();
  });
});

describe("a load that can be released", () => {
  const runner = new Runner((...of) => new Simulation(...of), () => 0);
  let opened: ReturnType<Runner["open"]>;
  beforeAll(async () => {
    await initEngine();
    const text = read("scenarios/loss_of_hook_load.yaml");
    opened = runner.open(text, "loss_of_hook_load.yaml", {}, JSON.parse(await filesOf(text)) as Record<string, string>);
  });

  it("a load that can be released has an input, and a scenario without one has none", async () => {
    const release = releaseOf(opened.model, opened.inputs)!;
    expect(release.name).toBe("hoist_rope");
    expect(isByTimeline(release)).toBe(true);
    expect(opened.timeline_switch).toBe("timeline");
    const text = read("scenarios/lowering_by_winch.yaml");
    const other = new Simulation(text, "", "{}", await filesOf(text));
    expect(releaseOf(readModel(other.model_json()), JSON.parse(other.inputs_json()) as InputInfo[])).toBeNull();
    other.free();
  });

  it("the loss of a hook load has the areas and heels that Python computes", () => {
    const before = runner.hydrostatics([]);
    const lost = lostWith(before, "hoist_rope", opened.model.bodies);
    expect(lost).toEqual(["lift"]);
    const after = runner.hydrostatics(lost);
    const [with_it, without] = [before, after].map(({ hulls }: Hydrostatics) => bothSides(hulls[0].righting_arm!));
    const loss = lossOf(with_it, without, Math.PI / 2)!;
    // kingpost.analysis.lift_rules.hook_load_loss(before, after), of the same scenario.
    expect(loss.start / DEGREE).toBeCloseTo(-0.033933592494577176, 9);
    expect(loss.rest / DEGREE).toBeCloseTo(4.981687036808579, 9);
    expect(loss.end / DEGREE).toBeCloseTo(38.64590544777638, 9);
    expect(loss.area_1).toBeCloseTo(0.005993363768351448, 12);
    expect(loss.area_2).toBeCloseTo(0.13994539515610352, 12);
    // The state of the present engine has not changed.
    expect(runner.hydrostatics().hulls[0].heel_rad).toBeCloseTo(before.hulls[0].heel_rad, 12);
  });
});

describe("natural periods over a parameter", () => {
  const pendulum = (length_m: number) => ({ coordinate: "swing", period_s: 2 * Math.PI * Math.sqrt(length_m / 9.81), damping_ratio: 0.01 });
  const roll = { coordinate: "hull.roll", period_s: 12, damping_ratio: 0.05 };
  const found = valuesOver([5, 45], 25).map((value) => ({ value, modes: [roll, pendulum(value)] }));

  it("values of a sweep are evenly spaced, and each halves a gap", () => {
    const values = valuesOver([0, 24], 25);
    expect(values.slice(0, 4)).toEqual([0, 24, 16, 8]);
    expect([...values].sort((a, b) => a - b)).toEqual(Array.from({ length: 25 }, (_, k) => k));
  });

  it("each line has one mode, and a pendulum has the period T at the length g (T / 2 pi)^2", () => {
    const lines = linesOf(found);
    expect(lines.map(({ coordinate, places }) => [coordinate, places.length])).toEqual([["hull.roll", 25], ["swing", 25]]);
    const [met, ...others] = crossings(lines, 9.5);
    expect(others).toEqual([]);
    expect(met.coordinate).toBe("swing");
    // Interpolated linearly between values 1.7 m apart.
    expect(met.value).toBeCloseTo(9.81 * (9.5 / (2 * Math.PI)) ** 2, 1);
    expect(crossings(lines, 40)).toEqual([]);
    expect(closest(lines, 40)?.value).toBe(45);
  });

  it("a line ends where no period is near its last one, and continues over a missing value", () => {
    const far = linesOf([{ value: 0, modes: [roll] }, { value: 1, modes: [{ ...roll, period_s: 30 }] }]);
    expect(far.length).toBe(2);
    expect(linesOf(found.filter(({ value }) => value < 10 || value > 14))[1].places.length).toBeLessThan(25);
    expect(linesOf(found.filter(({ value }) => value < 10 || value > 14)).length).toBe(2);
    const heave = [7, 10].map((period_s) => ({ coordinate: "hull.z", period_s, damping_ratio: 0.1 }));
    expect(linesOf([{ value: 0, modes: [roll, ...heave] }]).map(({ number }) => number)).toEqual([undefined, 1, 2]);
    expect(linesOf([{ value: 0, modes: [{ ...roll, period_s: 120 }, { ...roll, period_s: 0.3 }] }])).toEqual([]);
  });
});

describe("modes of the engine", () => {
  it("the engine's modes of the vessel have the periods that Python computes: roll, and both swings of the load", async () => {
    await initEngine();
    const text = read("scenarios/offshore_vessel.yaml");
    const engine = new Simulation(text, "", JSON.stringify({ rope_length_m: 25 }), await filesOf(text));
    const modes = JSON.parse(engine.natural_modes_json()) as NaturalMode[];
    engine.free();
    const periods = (coordinate: string) => modes.filter((mode) => mode.coordinate === coordinate).map(({ period_s }) => period_s);
    // kingpost.modes("offshore_vessel", rope_length_m=25).damped_period, to the digits that were printed.
    expect(periods("hull.roll")).toHaveLength(1);
    expect(periods("hull.roll")[0]).toBeCloseTo(13.991, 2);
    expect(periods("pendant.second")[0]).toBeCloseTo(10.039, 2);
    expect(periods("pendant.first")[0]).toBeCloseTo(9.322, 2);
  });
});

describe("spectrum of the sea", () => {
  const seaOf = async (scenario: string, overrides: Record<string, unknown>) => {
    await initEngine();
    const text = read(`scenarios/${scenario}.yaml`);
    const files = await filesOf(text);
    const engine = new Simulation(text, "", JSON.stringify(overrides), files);
    const waves = wavesOf(engine, expectedAmplitudes(engine, (resolved) => new Simulation(resolved, "", "{}", files)));
    engine.free();
    return waves;
  };

  it("the sea's spectrum has the peak period and the significant height of the scenario", async () => {
    for (const peak_s of [8, 12]) {
      const waves = await seaOf("offshore_vessel", { waves: true, peak_period_s: peak_s, significant_height_m: 2.5 });
      // Each wave is spread over 5 % of its frequency.
      expect(Math.abs(spectrumOf(waves)!.peak_s / peak_s - 1)).toBeLessThan(0.05);
      expect(4 * Math.sqrt(waves.amplitude_m.reduce((sum, a) => sum + (a * a) / 2, 0))).toBeCloseTo(2.5, 6);
    }
  });

  it("the spectrum of one regular wave has its peak at the period of the wave", () => {
    const sea = spectrumOf({ omega: [0.7], amplitude_m: [1] })!;
    expect(Math.abs(sea.peak_s / ((2 * Math.PI) / 0.7) - 1)).toBeLessThan(0.005);
  });

  it("calm water has no spectrum", async () => {
    expect(spectrumOf(await seaOf("offshore_vessel", { waves: false }))).toBeNull();
  });
});
