/** Matches main(), also as a host may write it. */
const MAIN = /\bvoid\s+main\s*\(/;

/** Puts declarations before a shader's main(). */
export const beforeMain = (shader: string, declarations: string): string =>
  shader.replace(MAIN, (main) => `${declarations}\n${main}`);
