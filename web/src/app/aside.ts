import type { EngineClient } from "../engine/client";
import type { Equations, Hydrostatics } from "../engine/engine";
import { rewind } from "./recording/rewind";
import type { Session } from "./session";

/** A second engine beside the one that runs, for what takes longer than a picture may wait. */
export class Aside {
  private client: EngineClient | null = null;
  /** What is open there: a source and its values, as they were handed to the run. */
  private held: { source: unknown; overrides: unknown } | null = null;
  private turn: Promise<unknown> = Promise.resolve();
  private readonly newest: Record<string, number> = {};

  constructor(private readonly startClient: () => EngineClient) {}

  /** How the hulls of the run in hand float at rest with the crane as it stands; null where the same asked for something newer. */
  hydrostatics(session: Session, asker = "panel"): Promise<Hydrostatics | null> {
    return this.inTurn(`hydrostatics for ${asker}`, async () => {
      const snapshot = await session.snapshot();
      const client = await this.opened(session);
      await client?.restore(snapshot);
      return client?.hydrostatics() ?? null;
    });
  }

  /** How they float at rest with the crane as the run began, without some bodies; null where the same asked for something newer. */
  hydrostaticsAtStart(session: Session, without: readonly string[], asker: string): Promise<Hydrostatics | null> {
    return this.inTurn(`hydrostatics for ${asker}`, async () => (await this.opened(session))?.hydrostatics(without) ?? null);
  }

  /** The matrices of the method at the moment that is shown; null where the same asked for something newer. */
  equations(session: Session, asker = "panel"): Promise<Equations | null> {
    return this.inTurn(`equations for ${asker}`, async () => {
      const { shown } = session;
      const snapshot = shown.isBack ? null : await session.snapshot();
      const client = await this.opened(session);
      if (!client) return null;
      if (snapshot) await client.restore(snapshot);
      else await this.goTo(client, session);
      return client.equations();
    });
  }

  /** The state at the moment that is shown; null where something newer was asked. */
  snapshot(session: Session): Promise<Uint8Array | null> {
    return this.inTurn("snapshot", async () => {
      if (!session.shown.isBack) return session.snapshot();
      const client = await this.opened(session);
      if (!client) return null;
      await this.goTo(client, session);
      return client.snapshot();
    });
  }

  /** To an earlier moment; with the parameters of then the engine is no more the one that was opened. */
  private async goTo(client: EngineClient, { shown, values }: Session): Promise<void> {
    const { recording, time_s } = shown;
    if (recording) await rewind(client, recording, time_s, values.inForce, () => (this.held = null));
  }

  /** Questions of one kind that a newer one overtakes are not answered; one that fails leaves an engine to be opened anew. */
  private inTurn<T>(kind: string, reckon: () => Promise<T | null>): Promise<T | null> {
    const asked = (this.newest[kind] ?? 0) + 1;
    this.newest[kind] = asked;
    const result = this.turn.then(() => (asked === this.newest[kind] ? reckon() : null));
    this.turn = result.catch(() => (this.held = null));
    return result;
  }

  private async opened({ source, values }: Session): Promise<EngineClient | null> {
    const { overrides } = values;
    if (!source) return null;
    this.client ??= this.startClient();
    if (this.held?.source !== source || this.held.overrides !== overrides) {
      this.held = null;
      await this.client.open(source.text, source.file, overrides, source.opened ?? null);
      this.held = { source, overrides };
    }
    return this.client;
  }
}
