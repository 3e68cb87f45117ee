import { expect, it } from "vitest";
import { yamlOf } from "../src/app/yaml";

it("writes short fields on one line, and long fields below their name", () => {
  const long = "a_".repeat(30);
  const json = JSON.stringify({ version: 1, bodies: { ship: { [long]: 1, [`${long}2`]: [1, 2] } }, steps: [{ name: "lift off", [long]: 1, [`${long}2`]: 2 }] });
  expect(yamlOf(json)).toBe(
    `version: 1\n\nbodies:\n  ship:\n    ${long}: 1\n    ${long}2: [1, 2]\n\nsteps:\n  - name: "lift off"\n    ${long}: 1\n    ${long}2: 2\n`,
  );
});

it("keeps all digits of numbers", () => {
  expect(yamlOf('{"a": -0.0, "seed": 18446744073709551615, "b": [1e-7, 0.30000000000000004, 1e21]}')).toBe(
    "a: -0.0\nseed: 18446744073709551615\nb: [1e-7, 0.30000000000000004, 1e21]\n",
  );
});

it("quotes texts that YAML would read as another type", () => {
  expect(yamlOf(JSON.stringify({ y: "no", unit: "1", colour: "#123456", text: 'a "b": {c}', empty: "", none: null, list: [], map: {} }))).toBe(
    '"y": "no"\nunit: "1"\ncolour: "#123456"\ntext: "a \\"b\\": {c}"\nempty: ""\nnone: null\nlist: []\nmap: {}\n',
  );
});

it("folds a long text if this keeps it unchanged, and writes each value of a long list on a line", () => {
  const text = "a ship: its crane # 1".concat(" and its load".repeat(12));
  const [first, second] = yamlOf(JSON.stringify({ text })).trimEnd().split("\n").slice(1);
  expect([first.length <= 120, `${first.trim()} ${second.trim()}`]).toEqual([true, text]);
  expect(yamlOf(JSON.stringify({ text: `${text}  two spaces` }))).toContain('text: "a ship');
  const numbers = Array.from({ length: 60 }, (_, i) => i);
  expect(yamlOf(JSON.stringify({ numbers }))).toBe(["numbers:", ...numbers.map((one) => `  - ${one}`), ""].join("\n"));
});
