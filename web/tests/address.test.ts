import { describe, expect, it } from "vitest";
import { askedBy, asksForStart, queryOf } from "../src/app/address";

describe("the address", () => {
  it("asks for a scenario with its parameters, each as the kind of value that it is", () => {
    expect(askedBy("?scenario=paper&load=true&crane_x_m=-2.5&torque_history=pulse&simulation.step_s=0.002")).toEqual({
      scenario: "paper",
      values: { load: true, crane_x_m: -2.5, torque_history: "pulse", "simulation.step_s": 0.002 },
    });
  });

  it("asks for nothing where it is bare", () => {
    expect(askedBy("")).toEqual({ scenario: null, values: {} });
    expect(queryOf({ scenario: null, values: {} })).toBe("");
  });

  it("sets nothing over a scenario that it only names, so that it is what the command line runs", () => {
    expect(askedBy("?scenario=paper")).toEqual({ scenario: "paper", values: {} });
  });

  it("reads back what it was written from", () => {
    const asked = { scenario: "a ship & a crane", values: { load: false, load_t: 13.7, history: "off", "bodies.hull.mass_t": 0 } };
    expect(askedBy(queryOf(asked))).toEqual(asked);
  });

  it("asks for the start page where it is bare, unless the server opens a scenario there or a whole run follows", () => {
    expect(asksForStart({ search: "", hash: "" }, undefined)).toBe(true);
    expect(asksForStart({ search: "", hash: "#quality=best" }, undefined)).toBe(true);
    expect(asksForStart({ search: "", hash: "#k1=abc" }, undefined)).toBe(false);
    expect(asksForStart({ search: "", hash: "" }, "mine")).toBe(false);
    expect(asksForStart({ search: "?gallery", hash: "" }, "mine")).toBe(true);
    expect(asksForStart({ search: "?scenario=paper", hash: "" }, undefined)).toBe(false);
  });
});
