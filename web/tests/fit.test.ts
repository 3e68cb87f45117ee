import type { BodyInfo } from "../src/engine/engine";
import { describe, expect, it } from "vitest";
import { cornersOf, fitDistance, frame, gatheredCorners, middleOf, reachOf, rotate, unit, roomIn } from "../src/view/fit";
import { gridSpacing } from "../src/view/spacing";
import type { Vec3 } from "../src/view/fit";
import { boxOf, edgesOf, withFrame } from "../src/view/solids";

const quarterAboutZ = [Math.SQRT1_2, 0, 0, Math.SQRT1_2] as const;

/** Inertia, which no drawing uses. */
const UNUSED: BodyInfo["inertia_kg_m2"] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

it("rotates vectors by a quaternion w, x, y, z", () => {
  const turned = rotate(quarterAboutZ, [1, 0, 0]);
  [0, 1, 0].forEach((value, i) => expect(turned[i]).toBeCloseTo(value, 12));
});

it("transforms the corners of a body's box to the world frame", () => {
  const corners = cornersOf([5, 0, 0, ...quarterAboutZ], [{ low: [-2, -1, -1], high: [2, 1, 1] }]);
  expect(corners.length).toBe(8);
  expect(Math.max(...corners.map(([x]) => x))).toBeCloseTo(6, 12);
  expect(Math.max(...corners.map(([, y]) => y))).toBeCloseTo(2, 12);
  expect(middleOf(corners).map((value) => Math.round(value))).toEqual([5, 0, 0]);
});

it("gives the box around a body's shape, and the box with its frame", () => {
  const body = { name: "arm", parent: "tower", floats: false, is_submerged: false, colour: null, at_start: null, mass_kg: 500, inertia_kg_m2: UNUSED };
  const cylinder = boxOf({ ...body, shape: { kind: "cylinder", radius_m: 0.5, length_m: 7, axis: "x" } }, undefined);
  expect(edgesOf(cylinder)).toEqual([7, 1, 1]);
  const sphere = boxOf({ ...body, shape: { kind: "sphere", radius_m: 1 } }, undefined);
  expect(withFrame(sphere, 2)).toEqual({ low: [-1, -1, -1], high: [2, 2, 2] });
});

it("gives a hull the box of its mesh, wherever its centre of mass is", () => {
  const body = { name: "hull", parent: "world", floats: true, is_submerged: false, colour: null, at_start: null, mass_kg: 500, inertia_kg_m2: UNUSED, shape: { kind: "sphere", radius_m: 1 } as const };
  const vertices_m: [number, number, number][] = [[-9, -2, -3], [11, 0, 1], [0, 2, 1]];
  const hull = { name: "water", body: "hull", origin_m: [0, 0, -1] as [number, number, number], draught_m: 2, length_m: 20, beam_m: 4, is_linear: true };
  expect(boxOf(body, { ...hull, mesh: { vertices_m, triangles: [[0, 1, 2]] } })).toEqual({ low: [-9, -2, -3], high: [11, 2, 1] });
});

describe("fitting the camera", () => {
  const back = unit([-0.6, -1, 0.6]);
  const points = cornersOf([0, 0, 0, 1, 0, 0, 0], [{ low: [-10, -5, -2.5], high: [10, 5, 2.5] }]);

  it.each([0.46, 1, 2.4])("fits every point into the picture, with one point at its edge, at aspect %f", (aspect) => {
    const lens = { fov: 0.6, aspect };
    const distance = fitDistance(points, [0, 0, 0], back, [0, 0, 1], lens);
    const edge = Math.max(...points.map((point) => fill(point, distance, lens)));
    expect(edge).toBeCloseTo(1, 9);
  });

  it("fits the points with equal margins on opposite sides", () => {
    const lens = { fov: 0.6, aspect: 1.6 };
    const { target, distance } = frame(points, back, [0, 0, 1], lens);
    const shifted = points.map((point): Vec3 => [point[0] - target[0], point[1] - target[1], point[2] - target[2]]);
    const fills = shifted.map((point) => fill(point, distance, lens));
    expect(Math.max(...fills)).toBeCloseTo(1, 9);
    expect(fills.filter((value) => value > 0.999).length).toBeGreaterThanOrEqual(2);
    expect(distance).toBeLessThan(fitDistance(points, [0, 0, 0], back, [0, 0, 1], lens));
  });

  it("keeps the size of a ship whose lost load sinks away", () => {
    const ship = { low: [-40, -10, -5], high: [40, 10, 5] } as const;
    const load = { low: [-2, -2, -2], high: [2, 2, 2] } as const;
    const at = (depth_m: number) => [0, 0, 0, 1, 0, 0, 0, 0, 15, -depth_m, 1, 0, 0, 0];
    const reach = reachOf(at(0), [ship, load]);
    expect(reach).toBeCloseTo(Math.hypot(40, 10, 5), 9);
    const lens = { fov: 0.6, aspect: 1.6 };
    const distance = (depth_m: number) => frame(gatheredCorners(at(depth_m), [ship, load], reach), back, [0, 0, 1], lens).distance;
    expect(distance(40)).toBeGreaterThan(distance(0));
    const farthest = Math.max(...Array.from({ length: 300 }, (_, k) => distance(10 * k)));
    // At 2.5 times the distance the ship has 40 % of her size in the picture.
    expect(farthest).toBeLessThan(2.5 * distance(0));
    expect(distance(3000)).toBeLessThanOrEqual(distance(0));
  });

  /** Distance of a point from the middle of the picture; 1 at its edge. */
  function fill(point: Vec3, distance: number, lens: { fov: number; aspect: number }): number {
    const side = unit([-back[1], back[0], 0]);
    const top: Vec3 = [
      back[1] * side[2] - back[2] * side[1],
      back[2] * side[0] - back[0] * side[2],
      back[0] * side[1] - back[1] * side[0],
    ];
    const along = (axis: Vec3) => point[0] * axis[0] + point[1] * axis[1] + point[2] * axis[2];
    const depth = distance - along(back);
    const tan = Math.tan(lens.fov / 2);
    return Math.max(Math.abs(along(side)) / (depth * tan * lens.aspect), Math.abs(along(top)) / (depth * tan));
  }
});

it("the spacing of the grid follows from the size of the model", () => {
  expect(gridSpacing(Math.hypot(20, 10, 5))).toBe(5);
  expect(gridSpacing(0.6)).toBeCloseTo(0.1);
  expect(gridSpacing(200)).toBe(50);
});

describe("uncovered part of a picture", () => {
  const buttons = { left: 600, top: 8, right: 792, bottom: 52 };

  it("the uncovered part is the whole picture if nothing covers it", () => {
    expect(roomIn(800, 400, [])).toEqual({ left: 0, top: 0, right: 800, bottom: 400 });
  });

  it("the uncovered part is the largest part that no control covers", () => {
    expect(roomIn(800, 400, [buttons])).toEqual({ left: 0, top: 52, right: 800, bottom: 400 });
    expect(roomIn(800, 400, [buttons, { left: 8, top: 8, right: 150, bottom: 110 }])).toEqual({ left: 0, top: 110, right: 800, bottom: 400 });
    expect(roomIn(390, 320, [{ left: 8, top: 270, right: 382, bottom: 314 }])).toEqual({ left: 0, top: 0, right: 390, bottom: 270 });
  });

  it("the uncovered part is the tallest part if height counts", () => {
    const byHeight = ({ top, bottom }: { top: number; bottom: number }) => bottom - top;
    expect(roomIn(800, 400, [buttons], byHeight)).toEqual({ left: 0, top: 0, right: 600, bottom: 400 });
  });

  it("the whole picture is used if everything is covered", () => {
    expect(roomIn(100, 50, [{ left: -5, top: -5, right: 105, bottom: 55 }])).toEqual({ left: 0, top: 0, right: 100, bottom: 50 });
  });
});
