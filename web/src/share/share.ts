import type { Session } from "../app/session";
import { byId } from "../ui/dom";
import type { ShareDialog } from "./dialog";
import type { Shown } from "./embed";

/** Makes the Share button open a link to the present run; its code is loaded at the first use. */
export function enableSharing(session: Session, shown: () => Shown): void {
  const button = byId("share", HTMLButtonElement);
  let dialog: Promise<ShareDialog> | null = null;
  button.addEventListener("click", () => {
    dialog ??= import("./dialog").then(({ ShareDialog }) => new ShareDialog(session, shown));
    void dialog.then(
      (loaded) => loaded.open(),
      (why: unknown) => {
        dialog = null;
        session.report({ kind: "network", message: String(why) });
      },
    );
  });
  session.listen({ statusChanged: (status) => (button.disabled = status === "loading" || status === "empty") });
}
