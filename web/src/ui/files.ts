import { byId } from "./dom";

/**
 * Largest size of a file, bytes: ten times that of a hydrodynamic database with a thousand frequencies and directions.
 */
const MOST_BYTES = 100e6;

/**
 * Passes files that are chosen or dropped on the page to `open`, together, as texts by name; a file that is too large
 * is refused before it is read.
 */
export function enableFiles(open: (texts: Record<string, string>) => void, refuse: (file: File, most_bytes: number) => void): void {
  const take = async (files: File[]) => {
    const large = files.find(({ size }) => size > MOST_BYTES);
    if (large) return refuse(large, MOST_BYTES);
    if (files.length > 0) open(Object.fromEntries(await Promise.all(files.map(async (file) => [file.name, await file.text()] as const))));
  };
  const input = byId("file", HTMLInputElement);
  for (const button of document.querySelectorAll("[data-opens-file]")) button.addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    const files = [...(input.files ?? [])];
    input.value = "";
    void take(files);
  });
  acceptDrops((files) => void take(files));
}

function acceptDrops(take: (files: File[]) => void): void {
  const veil = byId("drop");
  let depth = 0;
  const carriesFile = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  const show = (change: number) => {
    depth = Math.max(0, depth + change);
    veil.hidden = depth === 0;
  };
  addEventListener("dragenter", (event) => carriesFile(event) && show(1));
  addEventListener("dragleave", (event) => carriesFile(event) && show(-1));
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    show(-depth);
    take([...(event.dataTransfer?.files ?? [])]);
  });
}
