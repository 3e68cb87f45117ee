/** On a narrow screen the controls and the plots take turns; on a wide one both are there. */
export function enableSwitcher(): void {
  const app = document.querySelector<HTMLElement>(".app")!;
  const buttons = [...document.querySelectorAll<HTMLButtonElement>(".switcher button")];
  for (const button of buttons) {
    button.addEventListener("click", () => {
      app.dataset.panel = button.dataset.panel;
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
    });
  }
}
