import "uplot/dist/uPlot.min.css";
import "../styles/scene.css";
import "../styles/plots.css";
import "../styles/controls.css";
import { runClock } from "../app/clock";
import { Gallery, galleryFolder } from "../app/gallery";
import { fixed } from "../app/format";
import type { Source } from "../app/run";
import { Session } from "../app/session";
import { EngineClient } from "../engine/client";
import { asFault } from "../engine/engine";
import type { Values } from "../engine/engine";
import { fetchText } from "../engine/network";
import { faultOfNetwork } from "../engine/faults";
import { runIn } from "../share/link";
import { holdsRun } from "../app/address";
import { language, texts } from "../texts";
import { byId, setText } from "../ui/dom";
import { isFileAddress } from "./address";
import type { FigureChoice } from "./address";
import { Graph } from "./graph";
import { Panel } from "./panel";
import { Picture } from "./picture";
import { Player, settableIn } from "./player";
import type { FromFigure, ToFigure } from "./protocol";
import { words } from "./words";

/** Name of the channel by which the figures of a page tell each other that one of them plays. */
const CHANNEL = "kingpost figures";
const PLAY = "M5 3v14l12-7z";
const PAUSE = "M4 3h4v14H4zM12 3h4v14h-4z";

/** A figure with a running engine, as the figure page uses it. */
export interface Live {
  take(message: ToFigure): void;
}

/** Starts the engine and opens the scenario of a figure; resolves when it can be played. */
export async function bringToLife(choice: FigureChoice, hash: string, tell: (message: FromFigure) => void): Promise<Live> {
  const startWorker = () => new Worker(new URL("../engine/worker.ts", import.meta.url), { type: "module", name: language });
  const session = new Session(new EngineClient(startWorker, galleryFolder(document.baseURI)));
  const channel = new BroadcastChannel(CHANNEL);
  const player = new Player(session, tell, () => channel.postMessage(null));
  channel.onmessage = () => player.isPlaying && player.pause();
  const refuse = (message: string) => {
    setText(byId("alert"), message);
    tell({ kind: "error", code: "choice", message });
  };
  const picture = new Picture(session, choice.camera, refuse);
  const graph = new Graph(byId("plot"), session, choice.plot, refuse);
  new Panel(byId("controls"), session, choice.controls, (name, value) => player.set(name, value), refuse);
  showTransport(session, player);
  session.listen({ faulted: (fault) => setText(byId("alert"), fault ? `${fault.message}${fault.note ? ` ${fault.note}` : ""}` : "") });
  runClock(session, () => {
    player.tick();
    picture.draw();
    graph.draw();
  });
  const moment_s = await open(session, choice, hash);
  const { run } = session;
  if (!run) throw session.fault ?? new Error("nothing is open");
  if (choice.caption === "") document.title = byId("title").textContent = run.model.title;
  tell({ kind: "ready", title: run.model.title, duration_s: run.model.duration_s, columns: run.columns.names, settable: settableIn(session) });
  if (moment_s !== null) player.goTo(moment_s);
  return { take: (message) => obey(message, player, picture) };
}

function obey(message: ToFigure, player: Player, picture: Picture): void {
  if (message.kind === "set") player.set(message.name, message.value);
  else if (message.kind === "time") player.goTo(message.time_s);
  else if (message.kind === "camera") picture.look(message.camera);
  else if (message.kind === "play") player.play();
  else if (message.kind === "pause") player.pause();
}

/** Opens the run of a link, or the scenario; returns the moment of the link, null if there is none. */
async function open(session: Session, choice: FigureChoice, hash: string): Promise<number | null> {
  try {
    const { source, values, moment_s } = await asked(choice, hash);
    await session.open(source, values);
    return moment_s;
  } catch (thrown) {
    session.beEmpty(asFault(thrown));
    return null;
  }
}

async function asked({ scenario, set }: FigureChoice, hash: string): Promise<{ source: Source; values: Values; moment_s: number | null }> {
  const base = document.baseURI;
  if (holdsRun(hash)) {
    const { scenario: held, values, changes, moment } = await runIn(hash);
    const source = "gallery" in held ? await (await Gallery.load(base)).read(held.gallery) : held;
    return { source: { ...source, changes }, values: { ...values, ...set }, moment_s: moment?.time_s ?? null };
  }
  const source = scenario !== null && isFileAddress(scenario) ? await fileAt(scenario) : await (await Gallery.load(base)).read(scenario ?? "");
  return { source, values: set, moment_s: null };
}

/** Reads a scenario file on the host of the app; files that it names are in its folder. */
async function fileAt(address: string): Promise<Source> {
  const url = new URL(address, document.baseURI);
  if (url.origin !== location.origin) throw { kind: "scenario", message: words.elsewhere(address) };
  const text = await fetchText(url.href);
  if (text === null) throw faultOfNetwork(url.href, texts.engine.not_there);
  const folder = new URL("./", url).href;
  return { text, file: url.pathname.slice(url.pathname.lastIndexOf("/") + 1), folder };
}

function showTransport(session: Session, player: Player): void {
  const play = byId("play", HTMLButtonElement);
  const again = byId("again", HTMLButtonElement);
  play.addEventListener("click", () => (player.isPlaying ? player.pause() : player.play()));
  again.addEventListener("click", () => player.again());
  const words_of = texts.transport;
  again.setAttribute("aria-label", words_of.reset);
  const show = () => {
    const label = player.isPlaying ? words_of.pause : words_of.start;
    if (play.getAttribute("aria-label") !== label) play.setAttribute("aria-label", label);
    byId("play-icon", SVGElement).setAttribute("d", player.isPlaying ? PAUSE : PLAY);
  };
  session.listen({
    statusChanged: (status) => {
      play.disabled = again.disabled = status === "loading" || status === "empty";
      show();
    },
    moved: (_run, { time_s }) => setText(byId("time"), `${fixed(time_s, 2)} s`),
    opened: (_run, _frame) => setText(byId("time"), `${fixed(0, 2)} s`),
  });
  show();
}
