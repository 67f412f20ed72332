import { surfaceError } from './surfaceError';
import type { SurfaceUniform } from './SurfaceUniform';

/** A product of a number and values of uniforms. */
export interface ReachTerm {
  readonly factor: number;
  readonly names: readonly string[];
}

const LINE = /^[ \t]*\/\/[ \t]*reach[ \t]*:(.*)$/;

/**
 * Reads the greatest displacement of a surface's vertices: a line `// reach: 0.1 + 2 * height`, a sum of products of numbers and
 * of uniforms of type float or int (m, in the object's own space). Culling for pictures and shadow maps uses it.
 * @param name - name of the surface, for errors
 * @returns null if there is no such line
 * @throws MicroShaderCompileError with the line, for any other expression
 */
export function readReach(name: string, text: string, uniforms: readonly SurfaceUniform[]): ReachTerm[] | null {
  const lines = text.split('\n');
  const at = lines.findIndex((line) => LINE.test(line));
  if (at < 0) return null;
  return LINE.exec(lines[at])![1]
    .split('+')
    .map((term) => {
      let factor = 1;
      const names: string[] = [];
      for (const part of term.split('*').map((each) => each.trim())) {
        const value = part === '' ? NaN : Number(part);
        const uniform = uniforms.find((each) => each.name === part);
        if (Number.isFinite(value)) factor *= value;
        else if (uniform?.type === 'float' || uniform?.type === 'int') names.push(part);
        else
          throw surfaceError(
            name,
            text,
            at + 1,
            `"${part}" is neither a number nor a float or int uniform: write the reach as // reach: 0.1 + 2 * height`,
          );
      }
      return { factor, names };
    });
}
