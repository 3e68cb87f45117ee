const STYLE = `
:host { display: block; margin: 1em 0; }
:host([hidden]) { display: none; }
figure { margin: 0; }
.picture { position: relative; aspect-ratio: 16 / 10; background: #dbe7f0; overflow: hidden; }
.picture > img, ::slotted(img) { position: absolute; inset: 0; width: 100%; height: 100%; object-fit: cover; cursor: pointer; }
iframe { position: absolute; inset: 0; width: 100%; height: 100%; border: 0; }
button { position: absolute; inset: 0; width: 72px; height: 72px; margin: auto; border: 0; border-radius: 50%; background: #1d3c67; color: #fff; cursor: pointer; }
button:focus-visible { outline: 3px solid #1d3c67; outline-offset: 3px; }
button svg { display: block; width: 28px; margin: auto; fill: currentColor; }
button[aria-busy] { animation: kingpost-waits 1s infinite alternate; }
@keyframes kingpost-waits { to { opacity: 0.55; } }
@media (prefers-reduced-motion: reduce) { button[aria-busy] { animation: none; } }
figcaption { padding: 0.5em 0; }
[role="alert"]:not(:empty) { padding: 0.5em 0; color: #a8231c; }
[hidden] { display: none !important; }
`;
const PLAY = "M5 3v14l12-7z";

/** Parts of the element: the still with its button, the frame's place, the caption, and a line for faults. */
export interface Parts {
  picture: HTMLElement;
  still: HTMLImageElement;
  slot: HTMLSlotElement;
  start: HTMLButtonElement;
  caption: HTMLElement;
  alert: HTMLElement;
}

/** Fills a shadow root with the parts of a figure. */
export function partsIn(root: ShadowRoot, label: string): Parts {
  const make = <K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Record<string, string>, ...children: Node[]): HTMLElementTagNameMap[K] => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  };
  const style = document.createElement("style");
  style.textContent = STYLE;
  const still = make("img", { part: "still", alt: "", loading: "lazy", hidden: "" });
  const slot = make("slot", {}, still);
  const start = make("button", { type: "button", part: "start", "aria-label": label });
  start.innerHTML = `<svg viewBox="0 0 20 20" aria-hidden="true"><path d="${PLAY}"/></svg>`;
  const picture = make("div", { class: "picture", part: "picture" }, slot, start);
  const caption = make("figcaption", { part: "caption", hidden: "" });
  const alert = make("div", { role: "alert", part: "alert" });
  root.append(style, make("figure", {}, picture, alert, caption));
  return { picture, still, slot, start, caption, alert };
}

/** Returns the frame of a figure; it may have the whole screen, and the clipboard for nothing. */
export function frameOf(address: string, title: string): HTMLIFrameElement {
  const frame = document.createElement("iframe");
  frame.setAttribute("src", address);
  frame.setAttribute("title", title);
  frame.setAttribute("part", "frame");
  return frame;
}
