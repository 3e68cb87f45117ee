import { Vector3 } from "three";
import type { Color, Group, InterleavedBufferAttribute } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { Columns } from "../engine/columns";
import type { PointInfo } from "../engine/engine";
import type { LineInfo, Ropes } from "../engine/ropes";
import { shapeOf } from "./catenary";
import type { Vec3 } from "./fit";

/** Width of a rope, pixels: it is seen from afar too. */
const WIDTH_PX = 2.2;
/** Points along a mooring line. */
const POINTS = 49;

/** Mooring lines, hawsers and the ropes that loads hang on, which are no bodies. */
export class DrawnRopes {
  private readonly lines: { line: LineInfo; drawn: Line2 }[];
  private readonly pendants: { from: PointInfo; to: PointInfo; drawn: Line2 }[];

  /** Puts what is drawn into the world; `names` are those of the bodies. */
  constructor(
    { lines, pendants }: Ropes,
    private readonly columns: Columns,
    private readonly names: readonly string[],
    private readonly bodies: readonly Group[],
    world: Group,
    colour: Color,
  ) {
    const isKnown = (...points: PointInfo[]) => points.every(({ body }) => body === "world" || names.includes(body));
    this.lines = lines.filter((line) => isKnown(line.first, line.second)).map((line) => ({ line, drawn: rope(POINTS, colour) }));
    this.pendants = pendants.filter(({ from, to }) => isKnown(from, to)).map((pendant) => ({ ...pendant, drawn: rope(2, colour) }));
    const drawn = [...this.lines, ...this.pendants].map((one) => one.drawn);
    if (drawn.length > 0) world.add(...drawn);
  }

  /** Draws them between their ends now, as the row has their tensions. */
  place(row: ArrayLike<number>): void {
    for (const { from, to, drawn } of this.pendants) lay(drawn, [this.worldOf(from), this.worldOf(to)]);
    for (const { line, drawn } of this.lines) {
      const read = (variable: string) => this.columns.read(row, `${line.name}.${variable}`);
      const reading = {
        tension_N: read("line_tension"),
        end_tension_N: read("line_end_tension"),
        grounded_length_m: read("line_grounded_length"),
      };
      lay(drawn, shapeOf(line, this.worldOf(line.first), this.worldOf(line.second), reading, POINTS));
    }
  }

  private worldOf({ body, position_m }: PointInfo): Vec3 {
    const group = this.bodies[this.names.indexOf(body)];
    const at = new Vector3(...position_m);
    return group ? at.applyQuaternion(group.quaternion).add(group.position).toArray() : position_m;
  }
}

function rope(points: number, colour: Color): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(new Float32Array(3 * points));
  const line = new Line2(geometry, new LineMaterial({ color: colour, linewidth: WIDTH_PX }));
  line.frustumCulled = false;
  return line;
}

/** Moves a line in place: each of its parts has both its ends. */
function lay(line: Line2, points: readonly Vec3[]): void {
  const { data } = line.geometry.getAttribute("instanceStart") as InterleavedBufferAttribute;
  for (let i = 0; i + 1 < points.length; i++) {
    data.array.set(points[i], 6 * i);
    data.array.set(points[i + 1], 6 * i + 3);
  }
  data.needsUpdate = true;
}
