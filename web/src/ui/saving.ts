import type { SavedFile } from "../app/saved";
import type { Session } from "../app/session";
import { byId, make } from "./dom";

/** Hands the scenario over as a file, with the parameters and the levers as they were set. */
export function enableSaving(session: Session): void {
  const button = byId<HTMLButtonElement>("save");
  button.addEventListener("click", () => {
    void session.save().then((file) => {
      if (!file) return;
      download(file);
      if (file.differs) session.report({ kind: "saved", message: file.differs });
    });
  });
  session.listen({ statusChanged: (status) => (button.disabled = status === "loading" || status === "empty") });
}

function download({ name, text }: SavedFile): void {
  const href = URL.createObjectURL(new Blob([text], { type: "application/yaml" }));
  make("a", { href, download: name }).click();
  // The browser has begun to read it once the click is through.
  setTimeout(() => URL.revokeObjectURL(href), 60_000);
}
