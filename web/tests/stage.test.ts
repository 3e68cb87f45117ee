import { expect, it } from "vitest";
import type { Moment, Recording } from "../src/app/recording/recording";
import type { Run } from "../src/app/session";
import { Stage } from "../src/view/stage";
import type { View } from "../src/view/view";

it("a stage shows liquids, overlays and the ghost of a moment before it draws the moment", () => {
  const calls: [string, number][] = [];
  const canvas = {} as HTMLCanvasElement;
  const view = {
    hold: () => undefined,
    letGo: () => undefined,
    showTensions: () => undefined,
    still: (_frame: Moment, _surface: unknown, time_s: number) => {
      calls.push(["still", time_s]);
      return canvas;
    },
  } as unknown as View;
  const run = { lines: [], channels: [] } as unknown as Run;
  const recording = { rows: { items: [] } } as unknown as Recording;
  const stage = new Stage(view, run, recording, { width: 64, height: 64 }, ({ time_s }) => calls.push(["complete", time_s]), () => calls.push(["ended", NaN]));
  const moment = (time_s: number) => ({ time_s, row: [], poses: [], line_points: [], surface: null }) as unknown as Moment;
  for (const time_s of [1, 2]) expect(stage.draw(moment(time_s))).toBe(canvas);
  stage.end();
  expect(calls).toEqual([["complete", 1], ["still", 1], ["complete", 2], ["still", 2], ["ended", NaN]]);
});
