import "uplot/dist/uPlot.min.css";
import "./styles/main.css";
import { runClock } from "./app/clock";
import { Gallery, galleryFolder } from "./app/gallery";
import { exposeHandle } from "./app/handle";
import { OPENING_SCENARIO } from "./app/opening";
import { Session } from "./app/session";
import { EngineClient } from "./engine/client";
import type { Fault } from "./engine/engine";
import { Plots } from "./plots/plots";
import { showAbout } from "./ui/about";
import { showFaults } from "./ui/alert";
import { Controls } from "./ui/controls";
import { Floating } from "./ui/floating";
import { Readouts } from "./ui/readouts";
import { enableSaving } from "./ui/saving";
import { Scenarios } from "./ui/scenarios";
import { Settings } from "./ui/settings";
import { enableSwitcher } from "./ui/switcher";
import { Transport } from "./ui/transport";
import { showWarnings } from "./ui/warnings";
import { createScene } from "./view/scene";

const worker = new Worker(new URL("./engine/worker.ts", import.meta.url), { type: "module" });
const session = new Session(new EngineClient(worker, galleryFolder(document.baseURI)));
showFaults(session);
showWarnings(session);
showAbout(session);
enableSwitcher();
enableSaving(session);
new Controls(session);
new Settings(session);
new Readouts(session);
new Floating(session);
new Transport(session);
const plots = new Plots(session);
const scene = createScene(session);
exposeHandle(session);
runClock(session, () => {
  scene.draw();
  plots.draw();
});
void openFirst();

async function openFirst(): Promise<void> {
  try {
    const gallery = await Gallery.load(document.baseURI);
    const scenarios = new Scenarios(session, gallery);
    const asked = new URLSearchParams(location.search).get("scenario") ?? gallery.opening ?? null;
    if (asked === null || !(await scenarios.openNamed(asked))) {
      const why = session.fault;
      await scenarios.openNamed(OPENING_SCENARIO);
      if (why) session.report(why);
    }
  } catch (fault) {
    session.report(fault as Fault);
  }
}
