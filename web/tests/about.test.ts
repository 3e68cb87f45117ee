import { expect, it } from "vitest";
import { linked } from "../src/ui/about";

it("links each DOI in a text, without the full stop after it", () => {
  expect(linked("As in doi:10.1115/1.4042536. And more.")).toEqual([
    { text: "As in " },
    { text: "doi:10.1115/1.4042536", href: "https://doi.org/10.1115/1.4042536" },
    { text: ". And more." },
  ]);
  expect(linked("none")).toEqual([{ text: "none" }]);
});
