export type Vector = [number, number, number];

/** A surface as the image of the unit sphere. */
export type Surface = (unit: Vector) => Vector;

/** Angular momentum about the centre of mass, body axes, N m s: J omega. */
export function momentumOf(inertia: readonly (readonly number[])[], omega: Vector): Vector {
  return inertia.map((row) => row[0] * omega[0] + row[1] * omega[1] + row[2] * omega[2]) as Vector;
}

export function sizeOf(vector: Vector): number {
  return Math.hypot(...vector);
}

/** Where the angular momentum of this size lies: a free body keeps its size. */
export function momentumSphere(size: number): Surface {
  return ([x, y, z]) => [size * x, size * y, size * z];
}

/**
 * Where angular momenta h of the kinetic energy T lie (MacCullagh's ellipsoid): h' J^-1 h = 2 T. With J = C C' (Cholesky) they are
 * sqrt(2 T) C u of the unit vectors u.
 */
export function energyEllipsoid(inertia: readonly (readonly number[])[], energy_J: number): Surface {
  const [[a], [b, c], [d, e, f]] = cholesky(inertia);
  const size = Math.sqrt(2 * Math.max(0, energy_J));
  return ([x, y, z]) => [size * a * x, size * (b * x + c * y), size * (d * x + e * y + f * z)];
}

function cholesky(m: readonly (readonly number[])[]): [[number], [number, number], Vector] {
  const root = (square: number) => Math.sqrt(Math.max(0, square));
  const over = (value: number, by: number) => (by > 0 ? value / by : 0);
  const a = root(m[0][0]);
  const b = over(m[1][0], a);
  const c = root(m[1][1] - b * b);
  const d = over(m[2][0], a);
  const e = over(m[2][1] - d * b, c);
  return [[a], [b, c], [d, e, root(m[2][2] - d * d - e * e)]];
}

const STEPS = 48;
const MERIDIANS = 6;
const PARALLELS = 5;

/** A surface by its meridians and parallels. */
export function circlesOf(surface: Surface): Vector[][] {
  const circle = (point: (angle: number) => Vector) => Array.from({ length: STEPS + 1 }, (_, k) => surface(point((2 * Math.PI * k) / STEPS)));
  const meridians = Array.from({ length: MERIDIANS }, (_, k) => (Math.PI * k) / MERIDIANS).map((at) =>
    circle((angle) => [Math.cos(at) * Math.cos(angle), Math.sin(at) * Math.cos(angle), Math.sin(angle)]),
  );
  const parallels = Array.from({ length: PARALLELS }, (_, k) => (Math.PI * (k + 1)) / (PARALLELS + 1) - Math.PI / 2).map((at) =>
    circle((angle) => [Math.cos(at) * Math.cos(angle), Math.cos(at) * Math.sin(angle), Math.sin(at)]),
  );
  return [...meridians, ...parallels];
}
