import { PILLARS } from "../src/view/craft/column";
import { Box3, Raycaster, Vector3 } from "three";
import type { BufferGeometry } from "three";
import { describe, expect, it } from "vitest";
import type { DrawnLine } from "../src/engine/engine";
import { anchorsOf, distanceFrom } from "../src/view/craft/anchors";
import { distance, Place } from "../src/view/craft/place";
import { rolesOf } from "../src/view/craft/roles";
import { craftOf, sceneOf } from "../src/view/craft/craft";
import { boxOf, shapedHullOf } from "../src/view/solids";
import { gallery } from "./gallery";
import { opened } from "./opened";
import { PALETTE } from "./palette";

/** Distance of an anchor from the seabed, m. */
const ROUNDING_M = 0.01;

/** Returns the number of edges that are not passed equally often in both directions: 0 for closed solids. */
function openEdges(geometry: BufferGeometry): number {
  const { array, count } = geometry.attributes.position;
  const edges = new Map<string, number>();
  const name = (i: number) => [0, 1, 2].map((k) => Math.round(array[3 * i + k] * 1e3)).join();
  for (let i = 0; i < count; i += 3) {
    const corners = [name(i), name(i + 1), name(i + 2)];
    if (new Set(corners).size < 3) continue;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      const [key, sign] = from < to ? [`${from} ${to}`, 1] : [`${to} ${from}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + sign);
    });
  }
  return [...edges.values()].filter((passed) => passed !== 0).length;
}

describe.each(gallery)("drawing of %s", async (name) => {
  const { run, start } = await opened(name);
  const { works } = craftOf(run, start, PALETTE);

  it("each body of the model is drawn with the dimensions of its solid", () => {
    expect(works.length).toBe(run.model.bodies.length);
    run.model.bodies.forEach((body, i) => {
      const geometry = works[i].body.geometry()!;
      const drawn = new Box3().setFromBufferAttribute(geometry.attributes.position as never);
      const { low, high } = boxOf(body, shapedHullOf(run.model, body.name));
      const size = Math.hypot(...high.map((end, k) => end - low[k]));
      const away = [...drawn.min.toArray().map((end, k) => Math.abs(end - low[k])), ...drawn.max.toArray().map((end, k) => Math.abs(end - high[k]))];
      expect(Math.max(...away) / size, body.name).toBeLessThan(0.006);
    });
  });

  it("drawn solids are closed and have finite coordinates", () => {
    works.forEach(({ body, fittings, lit }, i) => {
      for (const [part, pieces] of Object.entries({ body, fittings, lit })) {
        const geometry = pieces.geometry();
        if (!geometry) continue;
        const what = `${part} of ${run.model.bodies[i].name}`;
        for (const attribute of Object.values(geometry.attributes)) expect(Array.from(attribute.array).every(Number.isFinite), what).toBe(true);
        expect(openEdges(geometry), what).toBe(0);
      }
    });
  });
});

describe.each(gallery)("attachments of lines, tubes and links of %s", async (name) => {
  const { simulation, run, start, moment } = await opened(name);
  const anchors = anchorsOf(sceneOf(run, start));

  it("all ends of lines, tubes and links are on a body or on the seabed", () => {
    const lines = run.lines.filter(({ points, radius_m }) => points > 1 && radius_m === 0);
    const pins = run.lines.filter(({ points }) => points === 1);
    const points = start.line_points;
    const last = (line: DrawnLine) => 3 * run.lines.slice(0, run.lines.indexOf(line) + 1).reduce((sum, one) => sum + one.points, 0) - 1;
    const onSeabed = lines.filter((line) => line.seabed !== null && points[last(line)] < line.seabed.height_m + ROUNDING_M).length;
    const links = rolesOf(run.model).filter((role) => role === "link").length;
    expect(anchors.length).toBe(2 * lines.length - onSeabed + pins.length + 2 * links + 2 * run.model.loops.length);
  });

  it("attachments stay on their body or its bracket while the body moves", () => {
    const steps = Math.ceil(1 / simulation.step_s());
    simulation.step(steps);
    const later = sceneOf(run, moment());
    const now = anchorsOf(later);
    expect(now.length).toBe(anchors.length);
    anchors.forEach(({ body, point, kind }, i) => {
      const end = new Place(later.poses, now[i].body).toWorld(now[i].point);
      const away = Math.min(distanceFrom(later, body, end), distance(end, new Place(later.poses, body).toWorld(point)));
      // The eye of a link is as near to its pivot as the loop's constraint is closed.
      expect(away, `${kind} on ${run.model.bodies[body].name}`).toBeLessThan(kind === "link" ? 0.06 : 0.02);
    });
  });
});

describe("roles of bodies", () => {
  const rolesIn = async (name: string) => {
    const { run } = await opened(name);
    const roles = rolesOf(run.model);
    return Object.fromEntries(run.model.bodies.map((body, i) => [body.name, roles[i]]));
  };

  it("the role of a body follows from its shape and its carrier", async () => {
    expect(await rolesIn("paper")).toEqual({ ship: "hull", tower: "column", arm: "boom" });
    expect(await rolesIn("lift_off_from_barge")).toEqual({ hull: "hull", pedestal: "column", boom: "boom", drum: "drum", ballast: "tank", lift: "cargo", barge_ship: "hull" });
    expect(await rolesIn("dual_draglink_crane")).toMatchObject({ drag_link_port: "link", drag_link_starboard: "link", jib: "boom" });
    expect(await rolesIn("supply_boat_lift")).toMatchObject({ boat: "hull", lift: "cargo" });
    expect(await rolesIn("container_to_quay")).toMatchObject({ quay: "quay", container: "cargo" });
    expect(await rolesIn("gyro_wave_energy")).toMatchObject({ gimbal_port: "gimbal", wheel_port: "wheel" });
    expect(new Set(Object.values(await rolesIn("chain")))).toEqual(new Set(["other"]));
  });
});

describe("deckhouses", () => {
  it("only hulls with a bow have a deckhouse", async () => {
    for (const [name, hull, hasHouse] of [["offshore_vessel", "hull", true], ["barge_crane_200t", "hull", false], ["paper", "ship", false], ["dual_draglink_crane", "ship", true]] as const) {
      const { run, start } = await opened(name);
      const { bridge } = craftOf(run, start, PALETTE);
      expect(bridge === null ? null : run.model.bodies[bridge.body].name, name).toBe(hasHouse ? hull : null);
    }
  });

  it("the deckhouse is aft if the crane stands forward", async () => {
    const { run, start } = await opened("offshore_vessel");
    const poses = Float64Array.from(start.poses);
    // The whole crane is moved 40 m forward.
    for (const body of [1, 2, 3]) poses[7 * body] += 40;
    const [aft, moved] = [start, { ...start, poses }].map((pose) => craftOf(run, pose, PALETTE).bridge!.point[0]);
    expect(aft).toBeGreaterThan(15);
    expect(moved).toBeLessThan(-10);
  });
});

describe("operator's cabs", () => {
  it("no pillar of a cab stands within 30 degrees of the view ahead", () => {
    const angles = PILLARS.map(([x, y]) => Math.abs((Math.atan2(y, x) * 180) / Math.PI));
    expect(Math.min(...angles)).toBeGreaterThan(30);
  });
});

describe("underwater vehicles", () => {
  it("a vehicle under water has an open frame below its foam, unlike a container", async () => {
    const openIn = async (scenario: string, name: string) => {
      const { run, start } = await opened(scenario);
      const i = run.model.bodies.findIndex((body) => body.name === name);
      const { low, high } = boxOf(run.model.bodies[i], undefined);
      // Across the vehicle, below the foam and beside the posts.
      const from = new Vector3(0.15 * high[0], 2 * low[1], 0.7 * low[2]);
      return new Raycaster(from, new Vector3(0, 1, 0)).intersectObject(craftOf(run, start, PALETTE).works[i].object()).length === 0;
    };
    expect(await openIn("underwater_vehicle", "vehicle")).toBe(true);
    expect(await openIn("container_to_quay", "container")).toBe(false);
  });
});
