import type { EngineClient } from "../engine/client";
import type { Equations, Hydrostatics } from "../engine/engine";
import { rewind } from "./recording/rewind";
import type { Session } from "./session";

/** A second engine for computations that take longer than a frame. */
export class BackgroundEngine {
  private client: EngineClient | null = null;
  /** Source and values of the scenario that is open in this engine; null if none is open. */
  private held: { source: unknown; overrides: unknown } | null = null;
  private turn: Promise<unknown> = Promise.resolve();
  private readonly newest: Record<string, number> = {};

  constructor(private readonly startClient: () => EngineClient) {}

  /**
   * Computes how the hulls of the present run float at rest with the crane in its present pose; null if a newer request
   * came.
   */
  hydrostatics(session: Session, asker = "panel"): Promise<Hydrostatics | null> {
    return this.inTurn(`hydrostatics for ${asker}`, async () => {
      const snapshot = await session.snapshot();
      const client = await this.opened(session);
      await client?.restore(snapshot);
      return client?.hydrostatics() ?? null;
    });
  }

  /**
   * Computes how the hulls float at rest without some bodies and with the crane as at the start of the run; null if a
   * newer request came.
   */
  hydrostaticsAtStart(session: Session, without: readonly string[], asker: string): Promise<Hydrostatics | null> {
    return this.inTurn(`hydrostatics for ${asker}`, async () => (await this.opened(session))?.hydrostatics(without) ?? null);
  }

  /** Computes the matrices of the method at the moment that is shown; null if a newer request came. */
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

  /** Returns the engine's state at the moment that is shown; null if a newer request came. */
  snapshot(session: Session): Promise<Uint8Array | null> {
    return this.inTurn("snapshot", async () => {
      if (!session.shown.isBack) return session.snapshot();
      const client = await this.opened(session);
      if (!client) return null;
      await this.goTo(client, session);
      return client.snapshot();
    });
  }

  /** Hands this engine to a task, which opens in it what it needs; other requests wait until the task has ended. */
  lend<T>(task: (client: EngineClient) => Promise<T>): Promise<T> {
    const result = this.turn.then(() => {
      this.held = null;
      return task((this.client ??= this.startClient()));
    });
    this.turn = result.catch(() => undefined);
    return result;
  }

  /**
   * Brings this engine to an earlier moment; the parameters at that moment may differ from those with which the
   * scenario was opened.
   */
  private async goTo(client: EngineClient, { shown, values }: Session): Promise<void> {
    const { recording, time_s } = shown;
    if (recording) await rewind(client, recording, time_s, values.inForce, () => (this.held = null));
  }

  /** Answers only the newest request of each kind; after a failure the next request opens the scenario again. */
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
      await this.client.open(source.text, source.file, overrides, source.opened ?? null, [], source.folder);
      this.held = { source, overrides };
    }
    return this.client;
  }
}
