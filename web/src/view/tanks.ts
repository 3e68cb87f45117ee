import { BoxGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial } from "three";
import type { ModelInfo, RoomInfo } from "../engine/engine";
import type { Palette } from "./palette";

/** Distance of the drawn liquid from the walls, relative to the smallest edge of its room. */
const WALL = 0.02;
/** Share of foam in the colour of the liquid, and the share of it that shines: it is seen through a hull, against the sea. */
const LIGHT = { foam: 0.05, own: 0.5 };

/** Returns the value of a column at the present moment; NaN if there is no such column. */
export type Reading = (column: string) => number;

/** Returns the level of the liquid above the bottom of a room, m: at rest if it has no column. */
export function levelIn({ low_m, high_m, level_m, level_column, level_zero_m }: RoomInfo, read: Reading): number {
  const read_m = level_column === null ? NaN : read(level_column) + level_zero_m;
  return Math.min(high_m[2] - low_m[2], Math.max(0, Number.isFinite(read_m) ? read_m : level_m));
}

/** Liquids in the tanks of bodies: the edges of each room, and a box up to the level of its liquid. */
export class Tanks {
  private readonly liquids: { box: Mesh; room: RoomInfo }[];

  /** Adds the tanks to the bodies that carry them. */
  constructor({ tanks, bodies }: Pick<ModelInfo, "tanks" | "bodies">, drawn: readonly Group[], palette: Palette) {
    const colour = palette.shallow.clone().lerp(palette.foam, LIGHT.foam);
    const liquid = new MeshStandardMaterial({ color: colour, emissive: colour, emissiveIntensity: LIGHT.own, roughness: 0.25 });
    const edges = new LineBasicMaterial({ color: palette.marking });
    this.liquids = tanks.flatMap(({ body, rooms }) => {
      const carrier = drawn[bodies.findIndex(({ name }) => name === body)];
      return rooms.map((room) => {
        const box = new Mesh(new BoxGeometry().translate(0, 0, 0.5), liquid);
        carrier?.add(box, edgesOf(room, edges));
        return { box, room };
      });
    });
    this.fill(() => NaN);
  }

  /** Sets the levels from the columns of a moment. */
  fill(read: Reading): void {
    for (const { box, room } of this.liquids) {
      const [x, y] = [0, 1].map((k) => (room.low_m[k] + room.high_m[k]) / 2);
      const [length, breadth, height] = [0, 1, 2].map((k) => room.high_m[k] - room.low_m[k]);
      const wall = WALL * Math.min(length, breadth, height);
      box.position.set(x, y, room.low_m[2]);
      box.scale.set(length - wall, breadth - wall, Math.max(1e-6, levelIn(room, read)));
    }
  }
}

function edgesOf({ low_m, high_m }: RoomInfo, material: LineBasicMaterial): LineSegments {
  const [x, y, z] = [0, 1, 2].map((k) => high_m[k] - low_m[k]);
  const edges = new LineSegments(new EdgesGeometry(new BoxGeometry(x, y, z)), material);
  edges.position.set(...([0, 1, 2].map((k) => (low_m[k] + high_m[k]) / 2) as [number, number, number]));
  return edges;
}
