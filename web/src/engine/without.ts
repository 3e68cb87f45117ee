import { parsed } from "./answers";

/** Returns a resolved scenario without some of its bodies, and without their drives, limits and operations. */
export function withoutBodies(resolvedJson: string, bodies: readonly string[]): string {
  const scenario = parsed("resolved_json", resolvedJson);
  for (const name of bodies) if (scenario.bodies?.[name]) scenario.bodies[name].enabled = false;
  if (scenario.operation) scenario.operation.enabled = false;
  delete scenario.limits;
  return JSON.stringify(scenario);
}
