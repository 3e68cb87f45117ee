import { fixed } from "../app/format";
import type { Session } from "../app/session";
import { texts } from "../texts";
import { byId, byTestId, make, setText } from "./dom";
import { marksOf, wordsNear } from "./marks";
import type { Mark } from "./marks";

/** Largest distance of the pointer to a mark whose text is shown, as a share of the track. */
const NEAR = 1 / 100;

/** The recording as a time slider, with the moment that is shown and marks of events. */
export class Scrubber {
  private readonly range = byId("cursor", HTMLInputElement);
  private readonly list = byId("marks");
  private readonly time = byTestId("cursor-time");
  private marks: Mark[] = [];
  private listed = "";

  constructor(private readonly session: Session) {
    this.range.addEventListener("input", () => session.scrub(this.range.valueAsNumber));
    this.range.addEventListener("keydown", (event) => this.key(event));
    this.range.addEventListener("pointermove", (event) => this.point(event));
    const show = () => this.show();
    session.listen({ opened: show, advanced: show, moved: show, branched: show, statusChanged: show });
    this.show();
  }

  /** Moves from record to record by the arrow keys; the browser handles all other keys. */
  private key(event: KeyboardEvent): void {
    const records = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    const { recording, time_s } = this.session.shown;
    if (!records || !recording || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    this.session.scrub(recording.beside(time_s, records));
  }

  /** Shows the text of events near the pointer. */
  private point({ clientX }: PointerEvent): void {
    const { left, width } = this.list.getBoundingClientRect();
    this.range.title = wordsNear(this.marks, (clientX - left) / width, NEAR);
  }

  private show(): void {
    const { recording, time_s } = this.session.shown;
    this.range.disabled = recording === null;
    if (!recording) return;
    const { start_s, now } = recording;
    this.range.min = String(start_s);
    this.range.max = String(now.time_s);
    this.range.value = String(time_s);
    const words = texts.scrubber.time(fixed(time_s, 2), fixed(now.time_s, 2));
    setText(this.time, `${fixed(time_s, 2)} / ${fixed(now.time_s, 2)} s`);
    this.showMarks();
    const length_s = now.time_s - start_s;
    const happened = length_s > 0 ? wordsNear(this.marks, (time_s - start_s) / length_s, 0) : "";
    this.range.setAttribute("aria-valuetext", happened ? `${words}. ${happened}` : words);
  }

  private showMarks(): void {
    const { marks, start_s, now } = this.session.shown.recording!;
    this.marks = marksOf(marks, start_s, now.time_s);
    // During a run the marks shift slightly with every frame: they are moved only when the shift is visible.
    const listed = this.marks.map(({ share, words }) => `${share.toFixed(3)} ${words}`).join("\n");
    if (listed === this.listed) return;
    this.listed = listed;
    const item = ({ share, words }: Mark) => make("li", { style: `left: ${(100 * share).toFixed(2)}%` }, make("span", { class: "visually-hidden", lang: "en" }, words));
    this.list.replaceChildren(...this.marks.map(item));
  }
}
