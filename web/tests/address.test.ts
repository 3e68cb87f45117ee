import { describe, expect, it } from "vitest";
import { askedBy, asksForStart, filmToken, queryOf, unknownIn } from "../src/app/address";

describe("addresses", () => {
  it("reads a scenario and its parameters from an address as booleans, numbers or texts", () => {
    expect(askedBy("?scenario=paper&load=true&crane_x_m=-2.5&torque_history=pulse&simulation.step_s=0.002")).toEqual({
      scenario: "paper",
      values: { load: true, crane_x_m: -2.5, torque_history: "pulse", "simulation.step_s": 0.002 },
    });
  });

  it("finds what it cannot read after the #, but no anchors", () => {
    expect(unknownIn("#run=AAAA")).toBe("run");
    expect(unknownIn("#quality=best&run=AAAA")).toBe("run");
    expect(["", "#controls", "#k1=abc.def", "#k9=abc", "#quality=best&k1=abc"].map(unknownIn)).toEqual([null, null, null, null, null]);
  });

  it("reads no scenario from a bare address", () => {
    expect(askedBy("")).toEqual({ scenario: null, values: {} });
    expect(queryOf({ scenario: null, values: {} })).toBe("");
  });

  it("overrides no value of a scenario if the address has no parameters", () => {
    expect(askedBy("?scenario=paper")).toEqual({ scenario: "paper", values: {} });
  });

  it("writes an address that is read back to the same scenario and values", () => {
    const asked = { scenario: "a ship & a crane", values: { load: false, load_t: 13.7, history: "off", "bodies.hull.mass_t": 0 } };
    expect(askedBy(queryOf(asked))).toEqual(asked);
  });

  it("opens the start page at a bare address, unless the server opens a scenario or the address holds a run", () => {
    expect(asksForStart({ search: "", hash: "" }, undefined)).toBe(true);
    expect(asksForStart({ search: "", hash: "#quality=best" }, undefined)).toBe(true);
    expect(asksForStart({ search: "", hash: "#k1=abc" }, undefined)).toBe(false);
    expect(asksForStart({ search: "", hash: "" }, "mine")).toBe(false);
    expect(asksForStart({ search: "?gallery", hash: "" }, "mine")).toBe(true);
    expect(asksForStart({ search: "?scenario=paper", hash: "" }, undefined)).toBe(false);
  });
});

it("the token of a film is read after the #, and only if it has the signs of one", () => {
  expect(filmToken("#film=aB3-_x")).toBe("aB3-_x");
  expect(["", "#quality=best", "#film=", "#film=../order", "#film=a/b"].map(filmToken)).toEqual([null, null, null, null, null]);
  expect(unknownIn("#film=aB3-_x")).toBeNull();
});
