import { byId } from "./dom";

/**
 * Shows one panel at a time: of all panels on a narrow screen; on a wide screen of those beside the picture, and the
 * plots are always visible.
 */
export function enableSwitcher(): void {
  for (const button of buttons()) button.addEventListener("click", () => showPanel(button.dataset.panel!));
  document.querySelector(".skip-link")!.addEventListener("click", (event) => {
    // A link would change the address, and thus the page.
    event.preventDefault();
    showPanel("controls");
    byId("controls").focus();
  });
}

/** Opens a panel by its id. */
export function showPanel(id: string): void {
  for (const button of buttons()) {
    const panel = button.dataset.panel!;
    button.setAttribute("aria-pressed", String(panel === id));
    byId(panel).classList.toggle("is-open", panel === id);
  }
  byId(id).dispatchEvent(new Event(OPENED));
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
  if (!isOffered && isPanelOpen(id)) showPanel("controls");
}

function buttons(): HTMLButtonElement[] {
  return [...document.querySelectorAll<HTMLButtonElement>(".switcher button")];
}
