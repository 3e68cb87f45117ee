import type { Axis } from "./axes";
import { withoutDeadZone } from "./lever";

/** Sticks of a gamepad with the standard layout, in the order of its axes; a push away from the hand is negative. */
const STICKS: [Axis, number][] = [
  ["left_x", 1],
  ["left_y", -1],
  ["right_x", 1],
  ["right_y", -1],
];

/** Reads the first gamepad with the standard layout with every picture, while it is connected. */
export function enableGamepad(take: (axis: Axis, deflection: number | null) => void, say: (name: string, isThere: boolean) => void): void {
  let isWatched = false;
  const look = () => {
    const pad = gamepad();
    for (const [at, [axis, sign]] of STICKS.entries()) {
      const deflection = pad ? withoutDeadZone(sign * (pad.axes[at] ?? 0)) : 0;
      take(axis, deflection || null);
    }
    isWatched = pad !== undefined;
    if (isWatched) requestAnimationFrame(look);
  };
  addEventListener("gamepadconnected", ({ gamepad: { id } }) => {
    say(id, true);
    if (!isWatched) look();
  });
  addEventListener("gamepaddisconnected", ({ gamepad: { id } }) => say(id, false));
}

function gamepad(): Gamepad | undefined {
  return navigator.getGamepads().find((pad) => pad?.connected && pad.mapping === "standard") ?? undefined;
}
