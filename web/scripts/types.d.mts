/** Where the generated types stand. */
export const TYPES: string;
export function scenarioTypes(): Promise<string>;
