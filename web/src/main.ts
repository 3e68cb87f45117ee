import "uplot/dist/uPlot.min.css";
import "./styles/main.css";
import { Aside } from "./app/aside";
import { enablePalettes } from "./app/palette";
import { runClock } from "./app/clock";
import { Gallery, galleryFolder } from "./app/gallery";
import { exposeHandle } from "./app/handle";
import { faultOfGallery } from "./app/faults";
import { Session } from "./app/session";
import { EngineClient } from "./engine/client";
import type { Fault } from "./engine/engine";
import { EquationsPanel } from "./equations/equations";
import { Instruments } from "./instruments/instruments";
import { Plots } from "./plots/plots";
import { announce } from "./ui/announcer";
import { showAbout } from "./ui/about";
import { showFaults } from "./ui/alert";
import { Controls } from "./ui/controls";
import { Floating } from "./ui/floating";
import { showPace } from "./ui/pace";
import { Readouts } from "./ui/readouts";
import { enableSaving } from "./ui/saving";
import { Scenarios } from "./ui/scenarios";
import { Scrubber } from "./ui/scrubber";
import { Settings } from "./ui/settings";
import { enableSwitcher } from "./ui/switcher";
import { Transport } from "./ui/transport";
import { showWarnings } from "./ui/warnings";
import { createScene } from "./view/scene";

enablePalettes();
const startWorker = () => new Worker(new URL("./engine/worker.ts", import.meta.url), { type: "module" });
const startClient = () => new EngineClient(startWorker, galleryFolder(document.baseURI));
const session = new Session(startClient());
showFaults(session);
showWarnings(session);
showAbout(session);
enableSwitcher();
enableSaving(session);
new Controls(session);
new Settings(session);
new Readouts(session);
showPace(session);
const aside = new Aside(startClient);
new Floating(session, aside);
new Instruments(session);
new Transport(session);
new Scrubber(session);
announce(session);
const plots = new Plots(session);
const scene = createScene(session, aside);
new EquationsPanel(session, aside, (what) => scene.highlight(what));
exposeHandle(session);
runClock(session, () => {
  scene.draw();
  plots.draw();
});
void openFirst();

async function openFirst(): Promise<void> {
  const scenarios = new Scenarios(session, document.baseURI);
  try {
    scenarios.offer(await Gallery.load(document.baseURI));
  } catch (fault) {
    return session.beEmpty(faultOfGallery(fault as Fault));
  }
  await scenarios.openAddress();
  if (!session.run && session.fault) session.beEmpty(session.fault);
}
