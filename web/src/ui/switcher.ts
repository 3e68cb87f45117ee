import { byId } from "./dom";

/** Shows one panel at a time: among all panels on a narrow screen, among those beside the picture on a wide one, where the plots stay. */
export function enableSwitcher(): void {
  for (const button of buttons()) button.addEventListener("click", () => showPanel(button.dataset.panel!));
  document.querySelector(".skip-link")!.addEventListener("click", (event) => {
    // A link would change the address, and with it the page.
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

/** Tells a panel that it is visible: its content may be old. */
const OPENED = "panel-opened";

export function onPanelOpened(id: string, act: () => void): void {
  byId(id).addEventListener(OPENED, act);
}

export function isPanelOpen(id: string): boolean {
  return byId(id).classList.contains("is-open");
}

/** Offers a panel if it has content; an open panel without content is replaced by the controls. */
export function offerPanel(id: string, isOffered: boolean): void {
  const button = buttons().find(({ dataset }) => dataset.panel === id)!;
  button.hidden = !isOffered;
  if (!isOffered && isPanelOpen(id)) showPanel("controls");
}

function buttons(): HTMLButtonElement[] {
  return [...document.querySelectorAll<HTMLButtonElement>(".switcher button")];
}
