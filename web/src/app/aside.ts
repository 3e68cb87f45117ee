import type { EngineClient } from "../engine/client";
import type { Hydrostatics } from "../engine/engine";
import type { Session } from "./session";

/** A second engine beside the one that runs, for what takes longer than a picture may wait. */
export class Aside {
  private client: EngineClient | null = null;
  /** What is open there: a source and its values, as they were handed to the run. */
  private held: { source: unknown; overrides: unknown } | null = null;
  private turn: Promise<unknown> = Promise.resolve();
  private newest = 0;

  constructor(private readonly startClient: () => EngineClient) {}

  /** How the hulls of the run in hand float at rest with the crane as it stands; null where something newer was asked. */
  hydrostatics(session: Session): Promise<Hydrostatics | null> {
    const asked = ++this.newest;
    const result = this.turn.then(() => (asked === this.newest ? this.reckon(session) : null));
    this.turn = result.catch(() => (this.held = null));
    return result;
  }

  private async reckon(session: Session): Promise<Hydrostatics | null> {
    const { source, values } = session;
    const { overrides } = values;
    const snapshot = await session.snapshot();
    if (!source) return null;
    this.client ??= this.startClient();
    if (this.held?.source !== source || this.held.overrides !== overrides) {
      this.held = null;
      await this.client.open(source.text, source.file, overrides, source.opened ?? null);
      this.held = { source, overrides };
    }
    await this.client.restore(snapshot);
    return this.client.hydrostatics();
  }
}
