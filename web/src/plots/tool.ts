import { make } from "../ui/dom";

/** Returns a button of the panel, with an icon and a name. */
export function tool(name: string, title: string, testId: string, path: string, act: () => void): HTMLButtonElement {
  const button = make("button", { type: "button", class: "plots-tool", title, "aria-label": title.startsWith(name) ? title : `${name}: ${title}`, "data-testid": testId });
  button.innerHTML = `<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="${path}" /></svg>`;
  button.append(make("span", { "aria-hidden": "true" }, name));
  button.addEventListener("click", act);
  return button;
}
