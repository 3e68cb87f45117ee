import type { Session } from "../app/session";
import { byId } from "./dom";
import { download } from "./download";

/** Makes the Save button save the scenario as a file, with the parameters and the lever moves. */
export function enableSaving(session: Session): void {
  const button = byId("save", HTMLButtonElement);
  button.addEventListener("click", () => void saveScenario(session));
  session.listen({ statusChanged: (status) => (button.disabled = status === "loading" || status === "empty") });
}

/** Saves the scenario and returns the name of the file; null, with a report, if this is not possible. */
export async function saveScenario(session: Session): Promise<string | null> {
  const file = await session.save();
  if (!file) return null;
  download(file.name, new Blob([file.text], { type: "application/yaml" }));
  if (file.differs) session.report({ kind: "saved", message: file.differs });
  return file.name;
}
