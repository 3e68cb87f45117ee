/** Returns the spacing of the grid for a model of this size, m: 1, 2 or 5 times a power of ten. */
export function gridSpacing(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size / 5));
  const parts = [1, 2, 5, 10].map((part) => part * power);
  const away = (part: number) => Math.abs(Math.log((part * 5) / size));
  return parts.reduce((best, part) => (away(part) < away(best) ? part : best));
}
