/**
 * A lock that a worker holds as long as it lives: when the system ends the worker, which no event reports, the lock
 * becomes free at once. Without locks (on a page that is not secure, or in a frame on another site, where a browser may deny
 * them) only silence tells that a worker has ended.
 */
const locks = (): LockManager | undefined => (globalThis.navigator as Navigator | undefined)?.locks;

let laid = 0;

/** Asks a worker to hold a lock. */
export function layLifeline(worker: Worker): void {
  if (!locks()) return;
  laid += 1;
  worker.postMessage({ lifeline: `kingpost-engine-${Date.now()}-${Math.random()}-${laid}` });
}

/** Holds the lock for the worker's life; `held` is called when it is held. */
export function holdLifeline(name: string, held: () => void): void {
  request(name, () => {
    held();
    return new Promise(() => {});
  });
}

/** Calls `cut` when the worker that holds the lock has ended. */
export function whenCut(name: string, cut: () => void): void {
  request(name, cut);
}

function request(name: string, granted: () => void | Promise<void>): void {
  locks()?.request(name, granted).catch(() => {});
}
