/** Where the generated types stand, by the name of their schema. */
export const TYPES: Record<"scenario" | "model", string>;
export function typesOf(name: string): Promise<string>;
