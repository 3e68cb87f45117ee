import { describe, expect, it } from "vitest";
import { holdsRun } from "../src/app/address";
import { digestOf } from "../src/engine/digest";
import type { Fault } from "../src/engine/engine";
import { hashOf, LONGEST, runIn } from "../src/share/link";
import { packed } from "../src/share/packing";
import type { SharedRun } from "../src/share/shared_run";
import { texts } from "../src/texts";
import { read } from "./gallery";
import { isThorough } from "./lane.mjs";

/** Numbers from 0 to 1, the same for a seed (mulberry32). */
function randomOf(seed: number): () => number {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Returns a random run that a link can contain: short or long, with every kind of value and character. */
function anyRun(seed: number): SharedRun {
  const random = randomOf(seed);
  const below = (n: number) => Math.floor(random() * n);
  const many = <T>(most: number, one: () => T) => Array.from({ length: below(most) }, one);
  const text = () => many(20, () => String.fromCodePoint([0x20, 0x41, 0x22, 0xe5, 0x4e2d, 0x1f6a2, 0x0a][below(7)] + below(6))).join("");
  const number = () => [0, random(), -1 / 3, 5e-324, 1.7976931348623157e308, (random() - 0.5) * 10 ** (below(40) - 20)][below(6)];
  const value = () => [random() < 0.5, number(), text()][below(3)];
  const named = <T>(one: () => T) => Object.fromEntries(many(6, () => [text(), one()] as const));
  let time_s = 0;
  const change = () => {
    time_s += random() < 0.3 ? 0 : random();
    return random() < 0.5 ? { time_s, input: text(), value: number() } : { time_s, parameter: text(), value: value() };
  };
  return {
    scenario: random() < 0.5 ? { gallery: text(), digest: text() } : { file: text(), text: many(400, text).join("\n"), opened: named(text) },
    values: named(value),
    changes: many(300, change),
    moment: random() < 0.3 ? null : { time_s: random() * 100, digest: text() },
  };
}

const small: SharedRun = { scenario: { gallery: "paper", digest: "0a1b2c3d" }, values: { load: true }, changes: [], moment: null };
const faultOf = (hash: string) => runIn(hash).then(
  () => null,
  (fault: Fault) => fault,
);
const linkOf = async (bytes: Uint8Array<ArrayBuffer>) => `#k1=${await packed(bytes)}.${digestOf(bytes)}`;
const linkOfJson = (json: unknown) => linkOf(new TextEncoder().encode(JSON.stringify(json)));

describe("a link", () => {
  it("a link contains any run completely, in characters that every address accepts", async () => {
    for (let seed = 1; seed <= (isThorough ? 200 : 50); seed++) {
      const run = anyRun(seed);
      const hash = await hashOf(run);
      expect(hash).toMatch(/^#k1=[\w-]+\.[0-9a-f]{8}$/);
      expect(await runIn(hash), `seed ${seed}`).toEqual(run);
    }
  });

  it("a link is short enough for a message, and with a scenario's text for an address", async () => {
    expect((await hashOf(small)).length).toBeLessThan(200);
    const own = { ...small, scenario: { file: "paper.yaml", text: read("scenarios/paper.yaml"), opened: {} } };
    expect((await hashOf(own)).length).toBeLessThan(8000);
  });

  it("a link that Python wrote opens", async () => {
    const { link, run } = JSON.parse(read("web/tests/golden/python_link.json"));
    expect(await runIn(link)).toEqual(run);
  });

  it("a link opens beside other parts of an address", async () => {
    const hash = await hashOf(small);
    expect(await runIn(`#quality=best&${hash.slice(1)}`)).toEqual(small);
    expect(["", "#quality=best", "#controls", "#k=1", "#kb1=x"].filter(holdsRun)).toEqual([]);
    expect(holdsRun(hash)).toBe(true);
  });

  it("a link of a newer version reports this, whatever it contains", async () => {
    for (const hash of ["#k2=x", "#k10=", `#k3=${"x".repeat(2 * LONGEST)}`]) {
      expect(holdsRun(hash)).toBe(true);
      expect(await faultOf(hash)).toEqual({ kind: "link", message: texts.share.newer });
    }
  });

  it("a link without its end reports that it was cut", async () => {
    const hash = await hashOf(small);
    for (let length = "#k1=".length; length < hash.length; length++) {
      expect(await faultOf(hash.slice(0, length)), hash.slice(0, length)).toEqual({ kind: "link", message: texts.share.cut });
    }
  });

  it("a link with one changed character does not open", async () => {
    const hash = await hashOf(small);
    for (let at = "#k1=".length; at < hash.length; at++) {
      const other = hash[at] === "A" ? "B" : "A";
      const fault = await faultOf(hash.slice(0, at) + other + hash.slice(at + 1));
      expect([fault?.kind, [texts.share.broken, texts.share.cut].includes(fault!.message)], `at ${at}`).toEqual(["link", true]);
    }
  });

  it.each([
    ["nothing", null],
    ["a list", []],
    ["no scenario", { values: {}, changes: [], moment: null }],
    ["a value that is a list", { ...small, values: { load: [1] } }],
    ["a change without a time", { ...small, changes: [{ input: "hoist", value: 1 }] }],
    ["a change of neither lever nor parameter", { ...small, changes: [{ time_s: 1, value: 1 }] }],
    ["a lever that is a text", { ...small, changes: [{ time_s: 1, input: "hoist", value: "up" }] }],
    ["a change before the start", { ...small, changes: [{ time_s: -1, input: "hoist", value: 1 }] }],
    ["changes in no order", { ...small, changes: [{ time_s: 2, input: "hoist", value: 1 }, { time_s: 1, input: "hoist", value: 1 }] }],
    ["a moment without a mark", { ...small, moment: { time_s: 1 } }],
    ["a scenario whose files are no texts", { ...small, scenario: { file: "a", text: "b", opened: { c: 1 } } }],
  ])("a link that contains %s is damaged", async (_, json) => {
    expect(await faultOf(await linkOfJson(json))).toEqual({ kind: "link", message: texts.share.broken });
  });

  it("a link that would unpack to too many bytes is refused while it is unpacked", async () => {
    const bomb = await linkOf(new Uint8Array(30e6));
    expect(bomb.length).toBeLessThan(LONGEST);
    expect(await faultOf(bomb)).toEqual({ kind: "link", message: texts.share.too_much(2e6) });
  });

  it("a link that is longer than the limit is neither made nor read", async () => {
    const noise = Array.from({ length: 60_000 }, ((random) => () => String.fromCharCode(33 + Math.floor(random() * 90)))(randomOf(7))).join("");
    const large = { ...small, scenario: { file: "a.yaml", text: noise, opened: {} } };
    await expect(hashOf(large)).rejects.toMatchObject({ kind: "link", message: expect.stringContaining("Save scenario makes a file of it") });
    expect((await faultOf(`#k1=${"A".repeat(LONGEST + 1)}.00000000`))?.message).toBe(texts.share.too_long(LONGEST + 10, LONGEST));
  });
});

it("the digest of bytes agrees with published values of FNV-1a", () => {
  expect([digestOf(), digestOf("a"), digestOf("foobar"), digestOf("foo", "bar")]).toEqual(["811c9dc5", "e40c292c", "bf9cf968", "bf9cf968"]);
  expect(digestOf(Float64Array.of(0))).not.toBe(digestOf(Float64Array.of(-0)));
});
