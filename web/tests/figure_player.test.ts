import { beforeAll, describe, expect, it } from "vitest";
import type { Session } from "../src/app/session";
import { Player, settableIn } from "../src/figure/player";
import type { FromFigure } from "../src/figure/protocol";
import { openedDirectly } from "./direct";
import { initEngine, read } from "./gallery";
import { until } from "./until";

const goldens = JSON.parse(read("crates/kingpost/tests/golden/paper.json")) as { name: string; row: number[] }[];
beforeAll(() => initEngine());

/** A player of the paper's ship, with a picture every turn of the event loop. */
async function playing(overrides = {}) {
  const session = await openedDirectly("paper", overrides);
  const told: FromFigure[] = [];
  const started: number[] = [];
  const player = new Player(session, (message) => told.push(message), () => started.push(session.shown.time_s));
  const frame = async (wall_s = 0.02) => {
    void session.advance(wall_s);
    player.tick();
    await new Promise((resolve) => setTimeout(resolve));
  };
  /** Draws pictures until a condition holds. */
  const draw = async (holds: () => boolean) => {
    for (let i = 0; i < 20_000 && !holds(); i++) await frame();
    expect(holds()).toBe(true);
  };
  const last = () => told.filter((message) => message.kind === "state").at(-1)!;
  return { session, player, told, started, frame, draw, last };
}

const isAt = (session: Session, time_s: number) => () => Math.abs(session.shown.time_s - time_s) < 1e-9 && !session.isGoing && !session.isWaiting;

describe("the player of a figure", () => {
  it("reaches a time with the bits of kingpost run, and goes back and forth in the recording", async () => {
    const { session, player, draw, frame, last } = await playing({ load: true, torque_history: "pulse" });
    const { row } = goldens.find(({ name }) => name === "page")!;
    player.goTo(2);
    await draw(isAt(session, 2));
    await frame();
    expect(Array.from(last().row)).toEqual(row);
    player.goTo(1);
    await draw(isAt(session, 1));
    expect(session.shown.isBack).toBe(true);
    player.goTo(2);
    await draw(isAt(session, 2));
    await frame();
    expect(Array.from(last().row)).toEqual(row);
  });

  it("restarts for a value that acts at the start, and shows the same time again", async () => {
    const { session, player, draw, told } = await playing();
    player.goTo(0.3);
    await draw(isAt(session, 0.3));
    player.set("crane_x_m", 4);
    await draw(() => isAt(session, 0.3)() && session.values.inForce.crane_x_m === 4);
    expect(told).toContainEqual({ kind: "changed", name: "crane_x_m", value: 4 });
    expect(settableIn(session).find(({ name }) => name === "crane_x_m")!.value).toBe(4);
  });

  it("plays on after a value that acts at the start", async () => {
    const { session, player, draw, started } = await playing();
    player.play();
    expect(started).toHaveLength(1);
    await draw(() => session.shown.time_s > 0.2);
    player.set("crane_x_m", 4);
    await draw(() => session.values.inForce.crane_x_m === 4 && session.shown.time_s > 0.1);
    expect(player.isPlaying).toBe(true);
    player.pause();
    expect(player.isPlaying).toBe(false);
  });

  it("pauses once at the duration of the scenario, and plays on from there", async () => {
    const { session, player, draw, frame } = await playing();
    player.goTo(2.9);
    await draw(isAt(session, 2.9));
    player.play();
    await draw(() => !player.isPlaying);
    expect(session.shown.time_s).toBeGreaterThanOrEqual(3);
    const at_s = session.shown.time_s;
    player.play();
    await frame();
    await draw(() => session.shown.time_s > at_s);
    expect(player.isPlaying).toBe(true);
    player.pause();
  });

  it("reports unknown names and values of another kind, and the run goes on", async () => {
    const { session, player, told } = await playing();
    player.set("nonesuch", 1);
    expect(told.at(-1)).toMatchObject({ kind: "error", code: "name", message: expect.stringMatching(/^nonesuch: .*crane_x_m/) as unknown });
    player.set("crane_x_m", "far");
    await until(() => expect(told).toContainEqual(expect.objectContaining({ kind: "error", code: "setting" })));
    expect(session.run).not.toBeNull();
  });
});
