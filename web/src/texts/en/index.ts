/** Every text that a person reads, by the area of the page that shows it. */
export * from "./about";
export * from "./forecast";
export * from "./controls";
export * from "./equations";
export * from "./exports";
export * from "./faults";
export * from "./instruments";
export * from "./page";
export * from "./physics";
export * from "./picture";
export * from "./plots";
export * from "./run";
export * from "./share";
export * from "./start";
