import { validateBytes } from 'gltf-validator';

/** Errors and warnings of Khronos' validator for a GLB. */
export async function glbProblems(bytes: Uint8Array): Promise<string[]> {
  const { issues } = await validateBytes(new Uint8Array(bytes), { maxIssues: 1000 });
  return issues.messages
    .filter(({ severity }) => severity < 2)
    .map(({ code, message, pointer }) => `${code} at ${pointer ?? '/'}: ${message}`);
}
