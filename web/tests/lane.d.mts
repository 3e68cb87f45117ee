export const isThorough: boolean;
export const KINDS: readonly string[];
export let leftOut: number;
export function thorough<T>(tests: Record<string, T>): Record<string, T>;
export function cases<T>(all: readonly T[], isTypical: (one: T) => boolean): T[];
