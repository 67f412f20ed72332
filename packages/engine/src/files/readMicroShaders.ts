import { parseMicroShader } from '@farol/renderer/microshaders';
import type { PathLike } from './FilePath';
import { join, type ProblemList } from './ProblemList';

/** Reads the microshaders of a scene file: texts by name. Only a renderer can compile them. */
export function readMicroShaders(value: unknown, path: PathLike, problems: ProblemList): Record<string, string> {
  const texts: [string, string][] = [];
  for (const [name, given] of Object.entries(problems.record(value, path))) {
    const at = join(path, name);
    const text = problems.text(given, at, true);
    try {
      parseMicroShader(name, text);
      texts.push([name, text]);
    } catch (error) {
      problems.add(at, (error as Error).message);
    }
  }
  // fromEntries makes '__proto__' an ordinary key
  return Object.fromEntries(texts);
}
