import { asFault } from "../engine/engine";
import type { FilmChoice } from "./choice";
import { makeFilm } from "./film";
import type { Studio } from "./film";
import { words } from "./words";

/** Largest part of a file that is sent at once, bytes; the server of the command takes no larger one. */
const PART_BYTES = 4e6;
/** Interval at which the command hears how far the film is, ms, and at which the run is looked at. */
const TELL_EVERY_MS = 500;
const LOOK_EVERY_MS = 50;

/** Film that `kingpost film` asks for. */
interface Order extends FilmChoice {
  camera: string;
}

/** Makes the film that `kingpost film` asks for, and sends it to the server of the command, which ends the browser then. */
export async function obeyCommand(studio: Studio, token: string): Promise<void> {
  const command = new Command(token);
  try {
    const order = await command.order();
    await opened(studio);
    if (!studio.scene.lookBy(order.camera)) throw { kind: "setting", message: words.no_camera(order.camera, studio.scene.cameras().join(", ")) };
    const end_s = await runTo(studio, order.to_s, (time_s) => command.tell("run", time_s, order.to_s));
    const isShort = end_s < order.to_s - studio.session.run!.model.step_s / 2;
    const choice = { ...order, to_s: Math.min(order.to_s, end_s) };
    const film = await makeFilm(studio, choice, (done, of) => command.tell("film", done, of), command.gone.signal);
    for (let from = 0; from < film.size; from += PART_BYTES) await command.send("part", film.slice(from, from + PART_BYTES));
    await command.send("done", isShort ? (studio.session.fault?.message ?? words.stopped(end_s)) : "");
  } catch (thrown) {
    // Without the command nobody is left to hear, and a page that works on would keep a processor busy.
    await command.send("failed", asFault(thrown).message).catch(() => close());
  }
}

const pause = () => new Promise((resolve) => setTimeout(resolve, LOOK_EVERY_MS));

/** Waits until the scenario is open. */
async function opened({ session }: Studio): Promise<void> {
  while (!session.run || session.status === "loading" || session.isWaiting) {
    if (session.fault) throw session.fault;
    await pause();
  }
}

/** Runs to a time as fast as possible; returns the time that was reached, s. */
async function runTo({ session }: Studio, to_s: number, tell: (time_s: number) => void): Promise<number> {
  session.runTo(to_s);
  while (session.isGoing || session.isWaiting) {
    tell(session.shown.recording!.now.time_s);
    await pause();
  }
  return session.shown.recording!.now.time_s;
}

/** Server of the command, which takes what is sent under a token that it made for this film. */
class Command {
  private told_ms = -Infinity;
  /** Aborts the work when the command has gone. */
  readonly gone = new AbortController();

  constructor(private readonly token: string) {}

  async order(): Promise<Order> {
    return (await (await fetch(this.addressOf("order"))).json()) as Order;
  }

  /** Reports progress, not more often than the command needs it. */
  tell(stage: "run" | "film", done: number, of: number): void {
    if (performance.now() - this.told_ms < TELL_EVERY_MS) return;
    this.told_ms = performance.now();
    this.gone.signal.throwIfAborted();
    void this.send("progress", JSON.stringify({ stage, done, of })).catch(() => this.gone.abort());
  }

  async send(kind: "progress" | "part" | "done" | "failed", body: string | Blob): Promise<void> {
    const answer = await fetch(this.addressOf(kind), { method: "POST", body });
    if (!answer.ok) throw new Error(answer.statusText);
  }

  private addressOf(kind: string): string {
    return `./film/${this.token}/${kind}`;
  }
}
