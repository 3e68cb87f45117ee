import "./styles/main.css";
import { figurePageFor } from "./app/address";
import { faultOfSize } from "./app/faults";
import { Gallery } from "./app/gallery";
import { Pages } from "./app/pages";
import { enablePalettes } from "./app/palette";
import type { Fault } from "./engine/engine";
import { keepOffline, watchOffline } from "./offline/register";
import { StartPage } from "./start/start";
import { fillPage } from "./texts/page";
import { enableFiles } from "./ui/files";

const figure_page = figurePageFor(location);
if (figure_page === null) begin();
else location.replace(figure_page);

function begin(): void {
  fillPage();
  enablePalettes();
  const gallery = Gallery.load(document.baseURI);
  const loadSimulator = () => import("./simulator");
  const start = new StartPage(
    (query, starts) => pages.open(query, starts),
    () => void loadSimulator().catch(() => undefined),
  );
  const pages: Pages = new Pages(
    start,
    async () => {
      const { startSimulator } = await loadSimulator();
      void keepOffline();
      return startSimulator(gallery);
    },
    gallery.then(({ opening }) => opening).catch(() => undefined),
  );
  gallery.then((known) => start.offer(known)).catch((fault: Fault) => start.lack(fault.message));
  watchOffline();
  enableFiles(
    (texts) => void pages.openFiles(texts),
    (file, most_bytes) => pages.report(faultOfSize(file, most_bytes)),
  );
  void pages.show(null);
}
