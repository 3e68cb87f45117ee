import { byId } from "./dom";

/**
 * Shows one panel at a time: of all panels on a narrow screen; on a wide screen of those beside the picture, and the
 * plots are always visible. On a phone the panel is a sheet over the picture: a press of its button pushes it down.
 */
export function enableSwitcher(): void {
  for (const button of buttons()) {
    button.addEventListener("click", () => (isSheet() && button.getAttribute("aria-pressed") === "true" ? pull("down") : showPanel(button.dataset.panel!)));
  }
  addEventListener("resize", refresh);
  document.querySelector(".skip-link")!.addEventListener("click", (event) => {
    // A link would change the address, and thus the page.
    event.preventDefault();
    showPanel("controls");
    byId("controls").focus();
  });
}

/** Opens a panel by its id. */
export function showPanel(id: string): void {
  open(id);
  pull("up");
}

function open(id: string): void {
  for (const { dataset } of buttons()) byId(dataset.panel!).classList.toggle("is-open", dataset.panel === id);
  refresh();
  byId(id).dispatchEvent(new Event(OPENED));
}

/** Pulls the sheet up or down unless the user has done so; the sticks need the picture. */
export function pullByDefault(to: "up" | "down"): void {
  if (byId("app").dataset.pulled !== "by_hand") byId("app").dataset.sheet = to;
  refresh();
}

function pull(to: "up" | "down"): void {
  Object.assign(byId("app").dataset, { sheet: to, pulled: "by_hand" });
  refresh();
}

/** Whether the panel is a sheet over the picture, which the styles of the screen's size say. */
function isSheet(): boolean {
  return getComputedStyle(byId("app")).getPropertyValue("--panel-is-sheet") === "yes";
}

function refresh(): void {
  const isDown = isSheet() && byId("app").dataset.sheet === "down";
  for (const button of buttons()) button.setAttribute("aria-pressed", String(!isDown && byId(button.dataset.panel!).classList.contains("is-open")));
}

/** Event that reports to a panel that it has become visible, so that it updates its content. */
const OPENED = "panel-opened";

export function onPanelOpened(id: string, act: () => void): void {
  byId(id).addEventListener(OPENED, act);
}

export function isPanelOpen(id: string): boolean {
  return byId(id).classList.contains("is-open");
}

/** Shows or hides the button of a panel; if the open panel is hidden, the controls are shown instead. */
export function offerPanel(id: string, isOffered: boolean): void {
  const button = buttons().find(({ dataset }) => dataset.panel === id)!;
  button.hidden = !isOffered;
  if (!isOffered && isPanelOpen(id)) open("controls");
}

function buttons(): HTMLButtonElement[] {
  return [...document.querySelectorAll<HTMLButtonElement>(".switcher button")];
}
