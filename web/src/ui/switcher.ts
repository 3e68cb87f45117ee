import { byId } from "./dom";

/** The panels take turns: of all on a narrow screen, of those beside the picture on a wide one, where the plots are always there. */
export function enableSwitcher(): void {
  for (const button of buttons()) button.addEventListener("click", () => showPanel(button.dataset.panel!));
  document.querySelector(".skip-link")!.addEventListener("click", (event) => {
    // The address would be another one, which asks for another page.
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

/** Says to a panel that it is in sight: what it shows may be old. */
const OPENED = "panel-opened";

export function onPanelOpened(id: string, act: () => void): void {
  byId(id).addEventListener(OPENED, act);
}

export function isPanelOpen(id: string): boolean {
  return byId(id).classList.contains("is-open");
}

/** Offers a panel where it has something to show; one that is open and no more offered gives way to the controls. */
export function offerPanel(id: string, isOffered: boolean): void {
  const button = buttons().find(({ dataset }) => dataset.panel === id)!;
  button.hidden = !isOffered;
  if (!isOffered && isPanelOpen(id)) showPanel("controls");
}

function buttons(): HTMLButtonElement[] {
  return [...document.querySelectorAll<HTMLButtonElement>(".switcher button")];
}
