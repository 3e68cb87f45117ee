import { readdirSync, readFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { describe, expect, it } from "vitest";
import { isInEnglish, OF_PAGE } from "../src/engine/faults";
import * as en from "../src/texts/en";
import * as englishOfFigures from "../src/texts/en/figure";
import * as englishOfFilms from "../src/texts/en/film";
import * as englishOfRuns from "../src/texts/en/runs";
import { languageOf } from "../src/texts/language";
import * as nb from "../src/texts/nb";
import * as norwegianOfFigures from "../src/texts/nb/figure";
import * as norwegianOfFilms from "../src/texts/nb/film";
import * as norwegianOfRuns from "../src/texts/nb/runs";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** Texts of a language by their keys, such as `transport.start`. */
function leaves(texts: object, path = ""): [string, unknown][] {
  return Object.entries(texts).flatMap(([name, one]): [string, unknown][] => {
    const key = path === "" ? name : `${path}.${name}`;
    return typeof one === "object" && one !== null ? leaves(one, key) : [[key, one]];
  });
}

/** Returns a text with substitutes for its arguments: once with the count one, once with several. */
function written(text: unknown): string[] {
  if (typeof text !== "function") return [String(text)];
  const given = (first: number) => Array.from({ length: text.length }, (_, k) => first + k);
  return [given(1), given(2)].map((values) => String(text(...values)));
}

/** Texts, with those of the figure page, which loads no others, and of films and kept runs, which are loaded later. */
const english = new Map(leaves({ ...en, ...englishOfFigures, ...englishOfFilms, ...englishOfRuns }));
const norwegian = new Map(leaves({ ...nb, ...norwegianOfFigures, ...norwegianOfFilms, ...norwegianOfRuns }));
/** Texts that are equal in both languages: names, symbols, units, and words. */
const SAME = [
  "equations.names.B_dot", "exports.parquet", "film.formats.mp4", "film.formats.webm", "exports.plot", "exports.save", "floating.trim", "page.name", "page.scenario", "page.title", "picture.scale.moment", "plots.arm_axis", 
  "plots.with_kind", "readouts.integrator", "settings.labels.simulation.integrator", "settings.integrators.dormand_prince", "settings.integrators.newmark", "settings.integrators.rk4",
  "share.send", "transport.pause", "transport.start",
];

describe("Norwegian texts", () => {
  it("Norwegian and English have the same texts", () => {
    expect(english.size).toBeGreaterThan(300);
    expect([...norwegian.keys()].sort()).toEqual([...english.keys()].sort());
  });

  it("Norwegian texts use the same arguments as English texts", () => {
    for (const [key, text] of english) {
      const other = norwegian.get(key);
      expect(typeof other, key).toBe(typeof text);
      if (typeof text !== "function" || typeof other !== "function") continue;
      expect(other.length, key).toBe(text.length);
      const values = Array.from({ length: text.length }, (_, k) => `given${k}`);
      const used = (of: typeof text) => values.filter((value) => String(of(...values)).includes(value));
      expect(used(other), key).toEqual(used(text));
    }
  });

  it("no Norwegian text is empty, or equal to the English one except for listed words", () => {
    for (const [key, text] of norwegian) expect(written(text).every((one) => one.trim() !== ""), key).toBe(true);
    const same = [...english.keys()].filter((key) => written(english.get(key)).join("\n") === written(norwegian.get(key)).join("\n"));
    expect(same.filter((key) => !SAME.includes(key))).toEqual([]);
    expect(SAME.filter((key) => !same.includes(key))).toEqual([]);
  });
});

describe("language of the page", () => {
  it("the language is the chosen one, otherwise the browser's first available one, otherwise English", () => {
    expect(languageOf("nb", ["en-GB"])).toBe("nb");
    expect(languageOf("en", ["nb-NO", "nb"])).toBe("en");
    expect(languageOf(null, ["nb-NO", "en"])).toBe("nb");
    expect(languageOf(null, ["en-US", "nb"])).toBe("en");
    expect(languageOf(null, ["de-DE", "no", "en"])).toBe("nb");
    expect(languageOf("xx", ["ko-KR"])).toBe("en");
    expect(languageOf(null, [])).toBe("en");
  });

  it("every code of Norwegian selects bokmål", () => {
    expect(["nb", "no", "nn", "nn-NO", "NO"].map((code) => languageOf(null, [code]))).toEqual(["nb", "nb", "nb", "nb", "nb"]);
  });
});

describe("the page", () => {
  const html = readFileSync(here("../index.html"), "utf8");

  it("the page names only texts that exist", () => {
    const named = [...html.matchAll(/data-(?:text|label|title)="([^"]*)"/g)].map(([, key]) => key);
    expect(named.length).toBeGreaterThan(60);
    expect(named.filter((key) => typeof english.get(key) !== "string")).toEqual([]);
  });

  it("the page has no text of its own except the app's name, axis symbols and the text without scripts", () => {
    const body = html.slice(html.indexOf("<body>")).replace(/<noscript[\s\S]*?<\/noscript>/, "").replace(/<script[\s\S]*?<\/script>/g, "");
    const texts = body.split(/<[^>]*>/).map((text) => text.trim()).filter((text) => /[A-Za-z]/.test(text));
    expect(texts).toEqual(["Kingpost", "e", "e", "e"]);
    expect([...body.matchAll(/\s(aria-label|title|placeholder|alt)="/g)].map(([, name]) => name)).toEqual([]);
  });
});

/** Source files of the app, except its texts and generated files. */
function sources(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return ["generated", "pkg", "texts"].includes(entry.name) ? [] : sources(path);
    return entry.name.endsWith(".ts") ? [path] : [];
  });
}

/** Returns the words of a literal, with a mark for each value in it; null for other nodes. */
function literal(node: ts.Node): string | null {
  if (ts.isStringLiteral(node) || ts.isNoSubstitutionTemplateLiteral(node)) return node.text;
  return ts.isTemplateExpression(node) ? [node.head.text, ...node.templateSpans.map((span) => span.literal.text)].join("§") : null;
}

/** Matches words with a space between them, or one that begins with a capital letter. */
const READS = /[A-Za-zé]{2,}[^A-Za-z]* [^a-z]*[A-Za-z]{2,}|^[A-Z][a-z]+| [a-z]{2,}|[a-z]{2,} /;
/** Matches texts that are not for users: code, selectors, media queries, styles, drawings, names of keys. */
const CODE = /\n|<svg|^\(|^[.#]\w|px |\\quad|:\/\/|^--|^item-when|^(Enter|Escape|Delete|Home|Files|TimeoutError)$/;
/** Attributes of elements that users do not read. */
const HIDDEN = ["class", "style", "d"];
/** Other texts that are for programs, or for data files in the form of other programs. */
const FOR_PROGRAMS = [
  "forecast/futures.ts: no start is known",
  "app/background_engine.ts: equations for §",
  "app/background_engine.ts: hydrostatics for §",
  "app/format.ts: § cm",
  "app/format.ts: § ms",
  "app/gallery.ts: scenario: found §, allowed: §",
  "engine/runner.ts: no scenario is open",
  "export/parquet.ts: Kingpost",
  "export/run_files.ts: paused at § s",
  "export/run_files.ts: world: z up, x forward, y to port; body: at its centre of mass, ship x forward, y to port",
  "export/run_files.ts: § of about § rows",
  "figure/live.ts: kingpost figures",
  "figure/port.ts: the message is not one of this version of the figure",
  "levers/keys.ts: input, select, textarea, dialog, [contenteditable]",
  "ui/transport.ts: input, select, textarea, button, summary, a, dialog, .panel, .plots, [role=slider], [contenteditable]",
  "offline/leave.ts: kingpost §",
  "offline/worker.ts: kingpost §",
  "physics/release.ts: can be released",
  "physics/release.ts: is released",
  "plots/spectrum_chart.ts: § rad/s",
  "plots/time_chart.ts: in §",
  "plots/view_dialog.ts: last §",
  'share/embed.ts: <iframe src="§" title="§" width="§" height="§" loading="lazy" style="border: 0; max-width: 100%"></iframe>',
  "ui/alert.ts: no file ",
];

function isForPrograms(node: ts.Node, text: string): boolean {
  const { parent } = node;
  if (ts.isPropertyAssignment(parent) && HIDDEN.includes(parent.name.getText())) return true;
  return CODE.test(text) || (ts.isNewExpression(parent) && /Error$/.test(parent.expression.getText()));
}

function readable(path: string): string[] {
  const found: string[] = [];
  const file = ts.createSourceFile(path, readFileSync(path, "utf8"), ts.ScriptTarget.Latest, true);
  const visit = (node: ts.Node): void => {
    if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isTypeNode(node)) return;
    const text = literal(node);
    if (text !== null && READS.test(text) && !isForPrograms(node, text)) found.push(`${relative(here("../src"), path).replaceAll("\\", "/")}: ${text}`);
    ts.forEachChild(node, visit);
  };
  visit(file);
  return found;
}

it("no source file outside the folder of texts has a text for users", () => {
  const found = sources(here("../src")).flatMap(readable);
  expect([...new Set(found)].filter((one) => !FOR_PROGRAMS.includes(one))).toEqual([]);
  expect(FOR_PROGRAMS.filter((one) => !found.includes(one))).toEqual([]);
});

it("every kind of fault that the page reports has a heading", () => {
  expect(OF_PAGE.filter((kind) => !(kind in en.alert.headings))).toEqual([]);
  expect(OF_PAGE.map((kind) => isInEnglish({ kind, message: "" }))).toEqual(OF_PAGE.map(() => false));
  expect(["scenario", "diverged", "input", "internal"].map((kind) => isInEnglish({ kind, message: "" }))).toEqual([true, true, true, true]);
});
