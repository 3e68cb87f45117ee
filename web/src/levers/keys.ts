import type { Axis } from "./axes";

/** Keys for the positive and the negative side of each axis. */
const KEYS: Record<string, [Axis, number]> = {
  w: ["left_y", 1],
  s: ["left_y", -1],
  d: ["left_x", 1],
  a: ["left_x", -1],
  i: ["right_y", 1],
  k: ["right_y", -1],
  l: ["right_x", 1],
  j: ["right_x", -1],
};

/** Keys of each stick: up, left, down, right. */
export const HINTS = { left: ["W", "A", "S", "D"], right: ["I", "J", "K", "L"] };

/** Deflection of a stick by a key while Shift is pressed. */
const FINE = 0.3;

/**
 * Moves the sticks by the letter keys unless the user types text; `take` gets null when the last key of an axis is
 * released.
 */
export function enableKeys(take: (axis: Axis, deflection: number | null) => void): void {
  const down = new Map<string, number>();
  const tell = (axis: Axis) => {
    const sides = [...down].filter(([key]) => KEYS[key][0] === axis);
    take(axis, sides.length === 0 ? null : sides.reduce((sum, [key, size]) => sum + size * KEYS[key][1], 0));
  };
  const letGo = (key: string) => down.delete(key) && tell(KEYS[key][0]);
  addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(key in KEYS) || event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
    const size = event.shiftKey ? FINE : 1;
    if (down.get(key) === size) return;
    down.set(key, size);
    tell(KEYS[key][0]);
  });
  addEventListener("keyup", ({ key }) => letGo(key.toLowerCase()));
  addEventListener("blur", () => [...down.keys()].forEach(letGo));
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest("input, select, textarea, dialog, [contenteditable]") !== null;
}
