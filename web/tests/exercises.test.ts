/** The exercises of the book check an answer as the tests of its pages do (tools/docs_book.py). */

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";

const script = readFileSync(fileURLToPath(new URL("../../docs/exercises.js", import.meta.url)), "utf8");

type Said = { dataset: Record<string, string>; hidden: boolean };

/** Answers an exercise: the result, and which text is shown. */
function answer(dataset: Record<string, string>, given: string, usualWrong: string[]) {
  const said: Said[] = [{ right: "" }, ...usualWrong.map((when) => ({ when })), { other: "" }].map((data) => ({
    dataset: data as unknown as Record<string, string>,
    hidden: true,
  }));
  let submit: (event: object) => void = () => undefined;
  const form = {
    dataset: { ...dataset },
    querySelectorAll: () => said,
    addEventListener: (_: string, listener: typeof submit) => (submit = listener),
  };
  const data = class {
    get = () => given;
  };
  new Function("document", "FormData", script)({ querySelectorAll: () => [form] }, data);
  submit({ preventDefault: () => undefined });
  return { result: form.dataset.result, shown: said.filter((one) => !one.hidden).map((one) => Object.entries(one.dataset)[0]) };
}

const number = { kind: "number", answer: "0.82", tolerance: "0.002" };

test.each([
  ["0.82", "right", ["right", ""]],
  ["0,8201", "right", ["right", ""]],
  ["0.35", "wrong", ["when", "0.35"]],
  ["0.8", "wrong", ["other", ""]],
  ["", "wrong", ["other", ""]],
  ["fast", "wrong", ["other", ""]],
])("a number %s is %s", (given, result, shown) => {
  expect(answer(number, given, ["0.35"])).toEqual({ result, shown: [shown] });
});

test("accepts the sign of mathematics before a number", () => {
  expect(answer({ kind: "number", answer: "-3", tolerance: "0.1" }, "−3", []).result).toBe("right");
});

test("a choice is right as it stands, and a usual wrong one has its reason", () => {
  expect(answer({ kind: "choice", answer: "roll" }, "roll", ["yaw"]).result).toBe("right");
  expect(answer({ kind: "choice", answer: "roll" }, "yaw", ["yaw"]).shown).toEqual([["when", "yaw"]]);
});
