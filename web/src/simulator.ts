import "uplot/dist/uPlot.min.css";
import "./styles/runs.css";
import { ForecastLine } from "./forecast/line";
import { openForecast } from "./forecast/open";
import { filmToken } from "./app/address";
import { BackgroundEngine } from "./app/background_engine";
import { isCalm } from "./app/calm";
import { runClock } from "./app/clock";
import { galleryFolder } from "./app/gallery";
import type { Gallery } from "./app/gallery";
import { exposeHandle } from "./app/handle";
import { faultOfGallery } from "./app/faults";
import { Rest } from "./app/rest";
import { Session } from "./app/session";
import { EngineClient } from "./engine/client";
import { asFault } from "./engine/engine";
import type { Fault } from "./engine/engine";
import { EquationsPanel } from "./equations/equations";
import { exportTool } from "./export/dialog";
import type { FilmDialog } from "./film/dialog";
import type { Studio } from "./film/film";
import { Instruments } from "./instruments/instruments";
import { Levers } from "./levers/levers";
import { Periods } from "./physics/periods";
import { PhysicsPanel } from "./physics/physics";
import { Plots } from "./plots/plots";
import { Runs } from "./runs/runs";
import { language, texts } from "./texts";
import { announce } from "./ui/announcer";
import { showAbout } from "./ui/about";
import { showFaults } from "./ui/alert";
import { Controls } from "./ui/controls";
import { byId } from "./ui/dom";
import { Floating } from "./ui/floating";
import { showPace } from "./ui/pace";
import { Readouts } from "./ui/readouts";
import { enableSaving } from "./ui/saving";
import { Scenarios } from "./ui/scenarios";
import type { Choice } from "./ui/scenarios";
import { Scrubber } from "./ui/scrubber";
import { Settings } from "./ui/settings";
import { enableSwitcher } from "./ui/switcher";
import { Transport } from "./ui/transport";
import { showModelWarnings, showWarnings } from "./ui/warnings";
import { LinkNotice } from "./share/notice";
import { enableSharing } from "./share/share";
import { createScene } from "./view/scene";

/** The simulator page, as the start page and the browser's history use it. */
export interface Simulator {
  /** Opens the scenario of the address, or the file of a history state. */
  goTo(state: Choice | null): Promise<void>;
  holds(state: Choice | null): boolean;
  openFiles(texts: Record<string, string>): Promise<void>;
  /** Starts the run, or the scenario that is being opened. */
  start(): void;
  pause(): void;
  report(fault: Fault): void;
  /** Sets the title of the document to that of the run. */
  entitle(): void;
}

/** Starts the engine and builds the page around a session; the gallery may still be loading then. */
export function startSimulator(gallery: Promise<Gallery>): Simulator {
  const startWorker = () => new Worker(new URL("./engine/worker.ts", import.meta.url), { type: "module", name: language });
  const startClient = () => new EngineClient(startWorker, galleryFolder(document.baseURI));
  const session = new Session(startClient());
  const rest = new Rest();
  buildPage(session, startClient, rest);
  exposeHandle(session, rest);
  // A scenario that opens while the start page is visible sets the title later, when the simulator becomes visible.
  const entitle = () => {
    if (!byId("app").hidden) document.title = session.run ? texts.page.title(session.run.model.title) : texts.page.name;
  };
  session.listen({ opened: entitle });
  const linkNotice = new LinkNotice(session);
  const scenarios = new Scenarios(session, document.baseURI, (link) => linkNotice.tell(link));
  const offered = gallery.then((known) => scenarios.offer(known));
  return {
    async goTo(state) {
      try {
        await offered;
      } catch (fault) {
        return session.beEmpty(faultOfGallery(asFault(fault)));
      }
      await scenarios.goTo(state);
      if (!session.run && session.fault) session.beEmpty(session.fault);
    },
    holds: (state) => scenarios.holds(state),
    openFiles: (texts) => scenarios.openFiles(texts),
    start: () => session.start(),
    pause: () => session.pause(),
    report: (fault) => session.report(fault),
    entitle,
  };
}

/** Returns a function that opens the dialog for films, which is loaded then. */
function filmOpener(studio: Studio): () => Promise<void> {
  let dialog: Promise<FilmDialog> | null = null;
  return async () => {
    dialog ??= import("./film/dialog").then(({ FilmDialog }) => new FilmDialog(studio));
    (await dialog.catch((thrown: unknown) => {
      dialog = null;
      throw thrown;
    })).open();
  };
}

function buildPage(session: Session, startClient: () => EngineClient, rest: Rest): void {
  showFaults(session);
  showModelWarnings(session);
  showWarnings(session);
  showAbout(session);
  enableSwitcher();
  enableSaving(session);
  enableSharing(session, () => ({ plot: plots.first, camera: scene.viewpoint() }));
  const levers = new Levers(session);
  new Controls(session, () => levers.ask());
  new Settings(session);
  new Readouts(session);
  showPace(session);
  const background = new BackgroundEngine(startClient);
  new Floating(session, background);
  new Instruments(session);
  new Transport(session);
  new Scrubber(session);
  announce(session);
  const scene = createScene(session, background);
  const runs = new Runs(session);
  scene.haunt(runs);
  const studio = { session, background, scene, plots: () => plots.shown };
  const plots: Plots = new Plots(session, background, runs, [exportTool(session, scene, () => plots.shown, runs, filmOpener(studio))]);
  const token = filmToken(location.hash);
  if (token !== null) void import("./film/command").then(({ obeyCommand }) => obeyCommand(studio, token));
  new EquationsPanel(session, background, (what) => scene.highlight(what));
  const startSweep = () => new Worker(new URL("./physics/worker.ts", import.meta.url), { type: "module", name: language });
  const physics = new PhysicsPanel(session, background, new Periods(startSweep, galleryFolder(document.baseURI)));
  const forecast = openForecast(session, background, galleryFolder(document.baseURI));
  new ForecastLine(forecast);
  forecast.onChange(() => {
    plots.foresee(forecast.outlook);
    scene.foresee(forecast.outlook);
  });
  runClock(session, () => {
    // A page that films for the command is not seen: it draws frames alone.
    if (token !== null) return;
    const isNew = [scene.draw(), plots.draw()].includes(true);
    physics.draw();
    rest.frame(!isNew && !session.isGoing && !session.isWaiting && isCalm());
  });
}
